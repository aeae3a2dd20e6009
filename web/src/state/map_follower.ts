// Keeps curves, map and counts up to the document. Follows every change at once, coarser where that takes too long, and
// looks closer at rest.
import {Refusal, Superseded, type EngineClient} from "../engine/client";
import {
  whole,
  type Axes,
  type Mistake,
  type Property,
  type Replies,
  type Requests,
  type MapWindow,
} from "../contract/messages";
import type {Questions} from "../questions/questions";
import type {Answers} from "./answers.svelte";
import {hurried, property_of, sampled_properties} from "../kinds/kind_dispatch";
import {settled_on, type TaskDocument} from "./document";
import {engine_text, same_question, type Problem} from "./problem";
import {sharing} from "./sharing";
import {YieldSampler, type YieldProgress} from "./yield_sampler";

interface Mapped {
  readonly questions: Questions;
  readonly engine: EngineClient | null;
  readonly driver_client: EngineClient | null;
  engine_state: "loading" | "ready" | "missing" | "slow";
  readonly answers: Answers;
  readonly document: TaskDocument;
  readonly problem: Problem;
  /** Why the engine is not asked, where it is not. */
  readonly incomplete: object | null;
  readonly gesture: boolean;
  readonly window: MapWindow;
  readonly property: Property;
  accept(document: TaskDocument): void;
  refuse(problem: Problem, mistakes: Mistake[]): boolean;
  amend(change: Partial<TaskDocument>): void;
}
/** What comes with a map, and goes on from it. */
interface Hand {
  /** What it is to bring of the linkage in hand, and what it has brought, of the task that it shows. */
  readonly wanted: Pick<Requests["explore"], "picked" | "live">;
  take(reply: Replies["explore"], of: Problem): void;
  /** The last good task is in force again. */
  follow(): void;
}

const even_samples = 400,
  quick_samples = 100;
const fine_samples = 1000;
const slow_ms = 25,
  slow_often = 3,
  quick_often = 8, // so many 400² maps in a row that take longer make dragging fall back to so many of 100²
  slowest = 8; // one that takes so many times as long counts as so many
const shortest_rest_ms = 80,
  longest_rest_ms = 600; // of a drag, after which it gets its 400² map: twice as long as that takes

export class MapFollower {
  private asked = ""; // what the map on screen, or on its way, answers
  private asked_samples = 0;
  private slow_maps = 0; // in a row
  private quick_maps = 0; // left until the next trial at 400²
  private even_ms = 0; // what the last 400² map took
  private fine = false; // at rest: the fine map was asked for
  private rest_timer: ReturnType<typeof setTimeout> | undefined;
  private fine_timer: ReturnType<typeof setTimeout> | undefined;
  private slow_timer: ReturnType<typeof setTimeout> | undefined;

  private readonly yields: YieldSampler;

  constructor(
    private readonly mapped: Mapped,
    private readonly hand: Hand,
    /** Nothing is in hand yet. */
    private readonly start: () => void,
  ) {
    this.yields = new YieldSampler(mapped.questions, (progress) => this.show_yields(progress));
  }

  refresh(): void {
    this.stop();
    const quick = this.mapped.gesture && this.quick_maps > 0;
    if (quick) --this.quick_maps;
    void this.explore(quick ? quick_samples : even_samples);
    if (!quick) return;
    const rest_ms = Math.min(Math.max(2 * this.even_ms, shortest_rest_ms), longest_rest_ms);
    this.rest_timer = setTimeout(() => void this.explore(even_samples), rest_ms);
  }
  /** Asks for nothing by itself any more. */
  stop(): void {
    clearTimeout(this.rest_timer);
    clearTimeout(this.fine_timer);
    this.mapped.answers.counted.drop();
    this.yields.stop();
    this.fine = false;
  }
  /** What was asked will not be answered, or its answer is gone. */
  forget(): void {
    this.asked = "";
    this.mapped.answers.explored.drop();
  }

  private async explore(samples: number): Promise<void> {
    const {document, window, engine, engine_state, gesture, property, answers} = this.mapped;
    if (!engine || engine_state === "missing") return;
    const problem = engine_text(gesture ? hurried(document.problem) : document.problem);
    const question = (order: number | null) => JSON.stringify([problem, window, property, order]);
    const asked = question(document.order);
    if (asked === this.asked && samples <= this.asked_samples) return this.refine();
    this.asked = asked;
    this.asked_samples = samples;
    this.watch_slowness();
    const order = gesture ? "nearest" : (document.order ?? "fresh"),
      request = {problem, samples, window, property, order, ...this.hand.wanted} as const;
    const of = {problem: document.problem}; // another one each time: one of more samples is another question
    await answers.explored.ask(of, (signal) => this.answer(engine, request, document, signal), {
      at_leisure: samples === fine_samples,
      taken: (reply) => {
        this.take(reply, document, samples, window);
        if (this.asked !== asked) return;
        this.asked = question(reply.task.axes.input.order);
        this.refine();
      },
    });
  }
  /** Nothing where it is not wanted any more. */
  private async answer(
    engine: EngineClient,
    request: Requests["explore"],
    document: TaskDocument,
    signal: AbortSignal,
  ): Promise<Replies["explore"] | null> {
    const {mapped, asked} = this;
    try {
      const reply = await engine.follow("explore", request);
      this.calm();
      if (request.samples === even_samples) this.weigh(reply.engine_ms);
      const taken_back = mapped.answers.map_is_of_present && !same_question(document.problem, mapped.problem); // a drag
      return mapped.incomplete || taken_back ? null : {...reply, task: sharing(reply.task, mapped.answers.task)};
    } catch (error) {
      if (error instanceof Superseded) throw error;
      this.calm();
      if (!signal.aborted) this.not_explored(error, document, asked);
      throw error;
    }
  }
  private weigh(map_ms: number): void {
    this.even_ms = map_ms;
    const times = Math.min(Math.floor(map_ms / slow_ms), slowest);
    this.slow_maps = times > 0 ? this.slow_maps + times : 0;
    if (this.slow_maps >= slow_often) this.quick_maps = quick_often * times;
  }
  private take(reply: Replies["explore"], document: TaskDocument, samples: number, window: MapWindow): void {
    const {mapped} = this,
      {gesture, answers} = mapped;
    if (!reply.map) answers.forget_linkages();
    answers.yields = null;
    answers.engine_ms = reply.engine_ms;
    mapped.accept(document);
    if (reply.map && window === whole && samples !== fine_samples) answers.counted.put(document, reply.map.census);
    if (!gesture && !same_question(mapped.problem, document.problem)) return; // another map is on its way
    this.settle(reply.task.axes);
    this.hand.take(reply, document.problem);
  }
  private settle(axes: Axes): void {
    const {document} = this.mapped;
    const settled = settled_on(axes, document);
    if (settled !== document) this.mapped.amend(settled);
    if (!settled.picked && axes.input.blocks.length > 0) this.start();
  }
  private not_explored(error: unknown, document: TaskDocument, asked: string): void {
    if (this.asked === asked) this.forget();
    if (error instanceof Refusal && this.mapped.refuse(document.problem, error.mistakes)) this.hand.follow();
  }

  // ---- at rest ------------------------------------------------------------------------------------------------

  private refine(): void {
    clearTimeout(this.fine_timer);
    if (this.mapped.gesture || this.fine) return;
    this.fine_timer = setTimeout(() => {
      if (this.mapped.answers.explored.busy) return; // from its answer on: the fine map would supersede the one that counts
      this.fine = true;
      const {engine, problem} = this.mapped;
      if (this.wants_yields) return engine && void this.yields.follow(engine, engine_text(problem));
      if (this.mapped.window !== whole) void this.count_whole();
      void this.explore(fine_samples);
    }, 300);
  }
  /** They are shown, or what is required goes by them: a map as fine as the eye sees would take them minutes. */
  private get wants_yields(): boolean {
    const {
      property,
      problem: {task, requirements = {}},
    } = this.mapped;
    return sampled_properties(task).some(
      (key) => key === property || ((requirements[property_of(task, key).requirement!] as number | undefined) ?? 0) > 0,
    );
  }
  private async show_yields(progress: YieldProgress): Promise<boolean> {
    const {mapped, asked} = this,
      {engine, answers, problem, window, property} = mapped,
      order = answers.task?.axes.input.order ?? "fresh";
    const request = {problem: engine_text(problem), samples: even_samples, window, property, order} as const,
      reply = await engine?.follow("explore", request);
    if (!reply?.map || this.asked !== asked || mapped.problem !== problem) return false;
    answers.explored.put({problem}, reply);
    answers.yields = progress;
    if (window === whole) answers.counted.put({problem}, reply.map.census);
    return true;
  }
  /** Zoomed in, the counts are still of the whole region. */
  private async count_whole(): Promise<void> {
    const {
      document: {problem, order},
      driver_client,
      answers,
    } = this.mapped;
    if (!driver_client) return;
    const request = {
      kind: "explore",
      problem: engine_text(problem),
      samples: even_samples,
      window: whole,
      property: "min_transmission_angle_deg",
      order: order ?? "fresh",
    } as const;
    const census = async (signal: AbortSignal) => (await driver_client.run(request, {signal})).map?.census ?? null;
    await answers.counted.ask({problem}, census, {at_leisure: true});
  }

  // ---- slowness -----------------------------------------------------------------------------------------------

  private watch_slowness(): void {
    clearTimeout(this.slow_timer);
    this.slow_timer = setTimeout(() => {
      if (this.mapped.engine_state === "ready") this.mapped.engine_state = "slow";
    }, 3000);
  }
  private calm(): void {
    clearTimeout(this.slow_timer);
    if (this.mapped.engine_state === "slow") this.mapped.engine_state = "ready";
  }
}
