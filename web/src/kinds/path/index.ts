import type {TaskModule} from "../kind";
import {path_kind} from "./kind";
import type {PathTask} from "./task";

export const path = {
  ...path_kind,
  view: async () => (await import("./view")).path_view,
} satisfies TaskModule<PathTask>;
