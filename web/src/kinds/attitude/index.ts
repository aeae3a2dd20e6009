import type {TaskModule} from "../kind";
import {attitude_kind} from "./kind";
import type {AttitudeTask} from "./task";

export const attitude = {
  ...attitude_kind,
  view: async () => (await import("./view")).attitude_view,
} satisfies TaskModule<AttitudeTask>;
