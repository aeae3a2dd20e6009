// What the parts of a six-bar are: the driver, the two added links as the axes of the map, the rest of the chain.
import type {Side} from "../../contract/messages";
import type {End, Role} from "../../figure/figure";

export const added = {input: 4, output: 5} as const; // bodies
/** The ends of the grounded links among the hinges a, b, d; c4, z4; c5, z5. */
export const end_joints: readonly ({side: Side; end: End} | undefined)[] = [
  undefined,
  undefined,
  undefined,
  {side: "input", end: "center"},
  {side: "input", end: "circle"},
  {side: "output", end: "center"},
  {side: "output", end: "circle"},
];

export function role_of_body(body: number): Role {
  return body === 1 ? "driver" : body === added.input ? "input" : body === added.output ? "output" : "coupler";
}
export function role_of_joint(joint: number): Role {
  return end_joints[joint]?.side ?? (joint === 0 ? "driver" : "coupler");
}
