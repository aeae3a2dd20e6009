// The part of the page that draws in 3-D comes when it is first wanted: the server may be gone by then.
import type {Component} from "svelte";
import type {Bench} from "../drawing/bench";
import type {Workbench} from "../state/workbench.svelte";

type View = Component<{bench?: Bench}>;
const views = import.meta.glob<{default: View}>("./SolidView.svelte");

class SolidPart {
  private loaded = $state.raw<View | null>(null);

  /** What is shown now in place of the flat view. */
  shown({solid}: Workbench): View | null {
    return solid ? this.loaded : null;
  }
  load(workbench: Workbench): void {
    if (!this.loaded)
      void views["./SolidView.svelte"]!().then(
        (module) => (this.loaded = module.default),
        () => say_not_loaded(workbench),
      );
  }
}
export const solid_part = new SolidPart();

export function say_not_loaded(workbench: Workbench): void {
  workbench.solid = false;
  workbench.say("state.solid_not_loaded", {}, {key: "state.try_again", run: () => void (workbench.solid = true)});
}
