// What the engine says of spherical linkages, beside what it says of every linkage (engine/adapter.ts).
import type {Vec3} from "../../sphere/vectors";

declare module "../../contract/messages" {
  interface Properties {
    min_link_angle_deg: number; // least of the four arcs and their supplements
  }
  interface Linkage {
    spherical?: SphericalBars; // of spherical four-bars only
  }
}

/** Lines through the centre, either sense. */
export interface Cone {
  axis: Vec3;
  half_angle_deg: number;
}
export type LinkName = "ground" | "input" | "coupler" | "output";
export type AxisName = "input_fixed" | "input_moving" | "output_moving" | "output_fixed";
/** Unit vectors, fixed frame; moving ones in position 1. */
export type Axes = Record<AxisName, Vec3>;
export interface SphericalBars extends Axes {
  angles_deg: Record<LinkName, number>;
  min_link_angle_deg: number;
  /** Of triple rockers, about what input and output swing: 0 or π. */
  triple_rocker: "00" | "0pi" | "pi0" | "pipi" | null;
}
