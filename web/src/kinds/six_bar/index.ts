import type {TaskModule} from "../kind";
import {six_bar_kind} from "./kind";
import type {SixBarTask} from "./task";

export const six_bar = {
  ...six_bar_kind,
  view: async () => (await import("./view")).six_bar_view,
} satisfies TaskModule<SixBarTask>;
