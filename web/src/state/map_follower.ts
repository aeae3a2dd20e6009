// Keeps curves, map and counts up to the document. Follows every change at once, coarser where that takes too long, and
// looks closer at rest.
import {Crashed, Refusal, Superseded} from "../engine/client";
import {whole, type Replies, type Window} from "../engine/protocol";
import {settled_on, type Document} from "./document";
import {engine_text, same_question} from "./problem";
import type {Workbench} from "./workbench.svelte";

const even_samples = 400,
  quick_samples = 100,
  fine_samples = 1000;
const slow_ms = 25,
  slow_often = 3,
  quick_often = 8; // so many 400² maps in a row that take longer make dragging fall back to so many of 100²

export class MapFollower {
  private asked = ""; // what the map on screen, or on its way, answers
  private asked_samples = 0;
  private forgotten = 0; // how often
  private slow_maps = 0; // in a row
  private quick_maps = 0; // left until the next trial at 400²
  private fine = false; // at rest: the fine map was asked for
  private rest_timer: ReturnType<typeof setTimeout> | undefined;
  private fine_timer: ReturnType<typeof setTimeout> | undefined;
  private slow_timer: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly workbench: Workbench) {}

  refresh(): void {
    this.stop();
    const quick = this.workbench.gesture && this.quick_maps > 0;
    if (quick) --this.quick_maps;
    void this.explore(quick ? quick_samples : even_samples);
    if (quick) this.rest_timer = setTimeout(() => void this.explore(even_samples), 80);
  }
  /** Asks for nothing by itself any more. */
  stop(): void {
    clearTimeout(this.rest_timer);
    clearTimeout(this.fine_timer);
    this.fine = false;
  }
  /** What was asked will not be answered, or its answer is gone. */
  forget(): void {
    this.asked = "";
    ++this.forgotten;
  }

  private async explore(samples: number): Promise<void> {
    const {document, window, engine, engine_state, gesture} = this.workbench;
    if (!engine || engine_state === "missing") return;
    const problem = engine_text(document.problem);
    const {property} = this.workbench;
    const question = (order: number | null) => JSON.stringify([problem, window, property, order]);
    const asked = question(document.order);
    if (asked === this.asked && samples <= this.asked_samples) return this.refine();
    this.asked = asked;
    this.asked_samples = samples;
    this.watch_slowness();
    const {forgotten} = this;
    try {
      const order = gesture ? "nearest" : (document.order ?? "fresh");
      const reply = await engine.request("explore", {problem, samples, window, property, order});
      this.calm();
      if (samples === even_samples) this.weigh(reply.engine_ms);
      if (this.forgotten !== forgotten) return; // a task that cannot be asked has stood between: this is of before
      this.take(reply, document, samples, window);
      if (this.asked !== asked) return;
      this.asked = question(reply.task.axes.input.order);
      this.refine();
    } catch (error) {
      if (error instanceof Superseded) return;
      this.calm();
      this.not_explored(error, document, asked);
    }
  }
  private weigh(map_ms: number): void {
    this.slow_maps = map_ms > slow_ms ? this.slow_maps + 1 : 0;
    if (this.slow_maps >= slow_often) this.quick_maps = quick_often;
  }
  private take(reply: Replies["explore"], document: Document, samples: number, window: Window): void {
    const {workbench} = this,
      {task, gesture} = workbench,
      {input: axis} = reply.task.axes;
    if (workbench.incomplete) return; // positions were removed meanwhile
    if (workbench.answers.map_is_of_present && !same_question(document.problem, workbench.problem)) return; // a drag was taken back meanwhile
    workbench.answers.take_map(reply.task, reply.map, document.problem);
    workbench.engine_ms = reply.engine_ms;
    workbench.accept(document);
    if (reply.map && window === whole && samples !== fine_samples)
      workbench.answers.take_census(reply.map.census, document.problem);
    const split =
      task !== null &&
      gesture &&
      axis.quantity === "curve_coordinate" &&
      task.axes.input.branches.length !== axis.branches.length;
    if (split) workbench.say(axis.branches.length > 1 ? "state.curve_split" : "state.curve_joined");
    if (gesture || workbench.problem === document.problem) this.settle();
    workbench.linkages.follow();
  }
  private settle(): void {
    const {document, task, linkages} = this.workbench;
    const settled = settled_on(task!.axes, document);
    if (settled !== document) this.workbench.amend(settled);
    if (!settled.picked && task!.axes.input.blocks.length > 0) linkages.start_with_best();
  }
  private not_explored(error: unknown, document: Document, asked: string): void {
    if (this.asked === asked) this.forget();
    if (error instanceof Crashed) return; // the workbench asks again
    if (!(error instanceof Refusal)) throw error;
    if (this.workbench.refuse(document.problem, error.mistakes)) this.workbench.linkages.follow();
  }

  // ---- at rest ------------------------------------------------------------------------------------------------

  private refine(): void {
    clearTimeout(this.fine_timer);
    if (this.workbench.gesture || this.fine) return;
    this.fine_timer = setTimeout(() => {
      this.fine = true;
      const {window, engine, driver_client} = this.workbench;
      const refined = () => void (this.fine && this.explore(fine_samples));
      const counted = window === whole ? null : this.count_whole();
      if (counted && driver_client === engine)
        void counted.then(refined); // one worker: the later would replace the earlier
      else refined();
    }, 300);
  }
  /** Zoomed in, the counts are still of the whole region. */
  private async count_whole(): Promise<void> {
    const {workbench} = this,
      {problem, order} = workbench.document;
    const content = {
      problem: engine_text(problem),
      samples: even_samples,
      window: whole,
      property: "min_transmission_angle_deg" as const,
      order: order ?? ("fresh" as const),
    };
    const reply = await workbench.driver_client?.request("explore", content).catch(() => null);
    if (reply?.map && workbench.problem === problem) workbench.answers.take_census(reply.map.census, problem);
  }

  // ---- slowness -----------------------------------------------------------------------------------------------

  private watch_slowness(): void {
    clearTimeout(this.slow_timer);
    this.slow_timer = setTimeout(() => {
      if (this.workbench.engine_state === "ready") this.workbench.engine_state = "slow";
    }, 3000);
  }
  private calm(): void {
    clearTimeout(this.slow_timer);
    if (this.workbench.engine_state === "slow") this.workbench.engine_state = "ready";
  }
}
