import type {TaskModule} from "../kind";
import {motion_kind} from "./kind";
import type {MotionTask} from "./task";

export const motion = {
  ...motion_kind,
  view: async () => (await import("./view")).motion_view,
} satisfies TaskModule<MotionTask>;
