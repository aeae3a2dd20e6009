// Colours of a six-bar's parts: the driver, the two added links as the axes of the map, the rest of the chain.
export type Role = "driver" | "chain" | "input" | "output";

export function role_of_body(body: number): Role {
  return body === 1 ? "driver" : body === 4 ? "input" : body === 5 ? "output" : "chain";
}
/** Hinges a, b, d; c4, z4; c5, z5. */
export function role_of_joint(joint: number): Role {
  return joint === 0 ? "driver" : joint < 3 ? "chain" : joint < 5 ? "input" : "output";
}
