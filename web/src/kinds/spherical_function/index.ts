import type {TaskModule} from "../kind";
import {spherical_function_kind} from "./kind";
import type {SphericalFunctionTask} from "./task";

export const spherical_function = {
  ...spherical_function_kind,
  view: async () => (await import("./view")).spherical_function_view,
} satisfies TaskModule<SphericalFunctionTask>;
