// What the engine says of linkages whose point follows a path (engine/adapter.ts).
import type {FourBar} from "../../contract/result";
import type {CarriedPoint} from "../../figure/tracing";

declare module "../../contract/messages" {
  interface Linkage {
    path?: FollowedPath | null; // of such tasks only; null: there is none
  }
}

export type FollowedPath = CarriedPoint &
  Pick<FourBar, "input_deg_at_points" | "theta_deg_at_points" | "cognate" | "full_turn" | "circuit_order">;
