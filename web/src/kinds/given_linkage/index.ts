import type {TaskModule} from "../kind";
import {linkage_kind} from "./kind";
import type {LinkageTask} from "./task";

export const linkage_modules = {
  four_bar: {...linkage_kind("four_bar"), view: async () => (await import("./view")).four_bar_view},
  six_bar: {...linkage_kind("six_bar"), view: async () => (await import("./view")).six_bar_view},
  spherical: {...linkage_kind("spherical_four_bar"), view: async () => (await import("./view")).spherical_view},
} satisfies Record<string, TaskModule<LinkageTask>>;
