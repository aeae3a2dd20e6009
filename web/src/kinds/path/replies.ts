// What the engine says of linkages whose point follows a path (engine/adapter.ts).
import type {LayerReply} from "../../contract/replies";
import type {FourBar} from "../../contract/result";
import type {CarriedPoint} from "../../figure/tracing";

declare module "../../contract/messages" {
  interface Properties {
    path_error: number; // of paths near points: root mean square of their distances from it, user's unit
  }
  interface Linkage {
    path?: FollowedPath | null; // of such tasks only; null: there is none
  }
}

/** Where no angles are given: all linkages at this place of the map, the best first. */
export interface Layers {
  layers?: readonly LayerReply[];
}
export type FollowedPath = CarriedPoint &
  Layers &
  Pick<FourBar, "input_deg_at_points" | "theta_deg_at_points" | "cognate" | "fit" | "full_turn" | "circuit_order">;
