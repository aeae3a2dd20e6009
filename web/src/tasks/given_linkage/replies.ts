// What the engine says of linkages that are the task (bindings/wasm/opened_linkage.cpp).
declare module "../../engine/protocol" {
  interface Linkage {
    /** Of a linkage that is the task: by row of its drive, null at dead points. */
    rates?: Rates;
  }
}
export interface Rates {
  /** Moving ones, as the engine calls them. */
  bodies: string[];
  /** To each body its angular velocity and acceleration (about a centre: of the coupler their magnitudes), then of the
   *  plane the point's velocity and acceleration, x and y. The driver turns as it travels, by 1 rad/s. */
  rows: (number[] | null)[];
}
