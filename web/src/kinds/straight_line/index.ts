import type {TaskModule} from "../kind";
import {straight_line_kind} from "./kind";
import type {StraightLineTask} from "./task";

export const straight_line = {
  ...straight_line_kind,
  view: async () => (await import("./view")).straight_line_view,
} satisfies TaskModule<StraightLineTask>;
