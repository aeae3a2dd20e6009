import type {TaskModule} from "../kind";
import {function_kind} from "./kind";
import type {FunctionTask} from "./task";

export const function_generation = {
  ...function_kind,
  view: async () => (await import("./view")).function_view,
} satisfies TaskModule<FunctionTask>;
