import type {TaskModule} from "../kind";
import {spherical_kind} from "./kind";
import type {SphericalTask} from "./task";

export const spherical = {
  ...spherical_kind,
  view: async () => (await import("./view")).spherical_view,
} satisfies TaskModule<SphericalTask>;
