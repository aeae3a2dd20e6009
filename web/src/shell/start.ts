// What the page starts with: the task of a link, the work of the last visit, or the first example, in this order.
import {stored_start} from "../engine/stored";
import {first_example} from "../gallery/gallery";
import {preferences} from "../state/preferences.svelte";
import {engine_text, type Problem} from "../state/problem";
import {Workbench} from "../state/workbench.svelte";
import {open_once} from "../transport/play";
import {accept_drops} from "./files";
import {view_for, type KeptView} from "./kept_view.svelte";
import {open_link} from "./links";
import {save_text} from "../exports/save";
import {damaged_work, forget_damaged, keep_work, own_slot, read_work} from "./storage";

/** Until a link has been read, which takes the engine. `view`: of the last visit, perhaps; what it shows, or the first
 *  example, is on screen before the engine is there. */
export function first_workbench(view: KeptView | null): Workbench {
  const slot = own_slot(),
    kept = read_work(slot);
  const workbench = new Workbench(kept ?? first_example.problem),
    problem = workbench.whole_problem;
  workbench.slot = slot;
  workbench.kept_since = kept?.at ?? null;
  const stored = view_for(workbench, view) ?? (is_first_example(problem) ? stored_start() : null);
  if (stored) workbench.show_stored(stored.task, stored.map, stored.linkage, stored.live);
  return workbench;
}
/** Of a view that was read late: nothing where there is a map already. */
export function show_kept(workbench: Workbench, view: KeptView | null): void {
  const stored = workbench.map ? null : view_for(workbench, view);
  if (stored) workbench.show_stored(stored.task, stored.map, stored.linkage, stored.live);
}
function is_first_example(problem: Problem): boolean {
  return (
    engine_text(problem) === engine_text(first_example.problem) &&
    problem.view?.picked === undefined &&
    problem.view?.order === undefined
  );
}

/** Once the page stands and the engine is being started. Returns how to end it. */
export function begin(workbench: Workbench): () => void {
  const newcomer = !preferences.toured && workbench.kept_since === null && location.hash.length <= 1;
  if (newcomer) workbench.tour = 0;
  const end_keeping = keep_work(workbench, workbench.kept_since ?? 0);
  give_out_damaged(workbench);
  void open_link(workbench);
  const opened = () => void open_link(workbench);
  addEventListener("hashchange", opened);
  const end_drops = accept_drops(workbench);
  const waiting = newcomer ? setInterval(() => first_opening(workbench, waiting), 100) : undefined;
  return () => {
    end_keeping();
    removeEventListener("hashchange", opened);
    end_drops();
    clearInterval(waiting);
  };
}
/** Work of an earlier visit that could not be read is no work to be thrown away. */
function give_out_damaged(workbench: Workbench): void {
  const text = damaged_work();
  if (text === null) return;
  const save = () => {
    save_text("linkwright-damaged.json", text, "application/json");
    forget_damaged();
  };
  workbench.say("state.damaged_work", {}, {key: "state.save_it", run: save});
}
/** As soon as there is a linkage to show: it opens once. */
function first_opening(workbench: Workbench, waiting: ReturnType<typeof setInterval> | undefined): void {
  if (!workbench.hand?.drive) return;
  clearInterval(waiting);
  open_once(workbench);
}
