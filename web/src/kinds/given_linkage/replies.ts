// What the engine says of linkages that are the task (bindings/wasm/opened_linkage.cpp).
import type {Rates} from "../../contract/replies";

declare module "../../contract/messages" {
  interface Linkage {
    /** Of a linkage that is the task: by row of its drive, null at dead points. */
    rates?: Rates;
  }
}

export type {Rates};
