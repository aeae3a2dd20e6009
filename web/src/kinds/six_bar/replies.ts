// What the engine says of six-bars, beside what it says of every linkage.
import type {Point} from "../../contract/messages";
import type {Chain} from "./task";

declare module "../../contract/messages" {
  interface Linkage {
    six_bar?: SixBar; // of six-bars only
  }
  interface Ranked {
    chain?: Chain; // where that is searched for
  }
}

export type Topology = "watt_1" | "stephenson_1" | "stephenson_2" | "stephenson_3";
/** What a six-bar has beside its two added links, which take the places of the grounded links (their centre point on the
 *  first of the bodies that they join, their circle point on the second). */
export interface SixBar {
  topology: Topology;
  /** a, b, d of the chain, both ends of link 4, both of link 5; in position 1. */
  joints: {name: string; ground: boolean; at: Point}[];
  /** Joints of bodies 0 (ground), 1 (driver), 2, 3 (guided), 4, 5. */
  bodies: number[][];
  /** Distances between joints of a body: "2:b-d". */
  lengths: {name: string; length: number}[];
}
