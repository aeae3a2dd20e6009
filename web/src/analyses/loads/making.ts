// What of its linkages each kind of task has that can be loaded.
import type {LinkMasses} from "../../contract/problem";

export interface Loading {
  /** Links that weigh something. */
  links: readonly (keyof LinkMasses)[];
}
declare module "../../kinds/kind" {
  interface Analysed {
    loads?: Loading;
  }
}
export const four_bar_loading: Loading = {links: ["input", "coupler", "output"]};
