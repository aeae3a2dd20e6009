// For tests.
import fc from "fast-check";
import {arbitrary_task as arbitrary_function} from "../function/arbitrary";
import type {SphericalFunctionTask} from "./task";

export const arbitrary_task = fc
  .tuple(arbitrary_function, fc.double({min: 0, max: 180, noNaN: true}))
  .map(([{ground_pivots: _, ...angles}, angle]): SphericalFunctionTask => {
    return {...angles, mechanism: "spherical_four_bar", ground_angle_deg: angle + 0};
  });
