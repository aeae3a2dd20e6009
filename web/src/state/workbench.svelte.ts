// The one state of the page, and everything that can happen to it. Views read it and call its actions; none keeps
// a copy. What is undoable (problem, picked linkage, pins) lives in `document`; the rest is how it is being looked at.
import {Crashed, EngineClient, Refusal, Superseded} from "../engine/client";
import {
  linkage_types, whole, type Census, type Linkage, type MapAnswer, type Mistake, type Point, type Property, type Replies,
  type TaskAnswer, type TauPair, type Window,
} from "../engine/protocol";
import type {TextKey, Values} from "../texts/texts.svelte";
import {place_of, tau_at} from "./axis";
import {stage_at_angle, angle_at_stage} from "./drive";
import {History} from "./history";
import {preferences} from "./preferences.svelte";
import {engine_text, problem_text, same_poses, with_view, type Pin, type Problem} from "./problem";

export interface Picked {
  tau: TauPair;
  /** Where it stands on the map. It stays there while the task changes; τ follows. Null until the axis is known. */
  place: TauPair | null;
}
/** What undo restores. Immutable. */
export interface Document {
  problem: Problem; // its view.picked and view.pins are written on saving and sharing; here they live in `picked`, `pins`
  picked: Picked | null;
  pins: readonly Pin[];
  order: number | null; // display order of the map
}
export interface Toast {
  id: number;
  key: TextKey;
  values: Values;
  action?: {key: TextKey; run: () => void};
}
export type Mode = "point" | "outline" | "ground_box" | "moving_box" | "trace" | "scale";
export type Sheet = "task" | "limits" | "pins" | "numbers" | "map";
export type Dialog = "examples" | "export" | "keys" | "compare" | "new" | "print";

/** Why there is no map: the number of positions. */
export type Incomplete = "empty" | "too_few" | "too_many" | null;

const even_samples = 400, quick_samples = 100, fine_samples = 1000;
const slow_ms = 25, slow_often = 3, quick_often = 8; // so many 400² maps in a row that take longer make dragging fall back to so many of 100²

export function position_count(problem: Problem): number {
  return problem.task.poses.reduce((sum, pose) => sum + 1 + (pose.derivatives?.length ?? 0), 0);
}

export class Workbench {
  document = $state.raw<Document>({problem: null as unknown as Problem, picked: null, pins: [], order: null});
  can_undo = $state(false);
  can_redo = $state(false);
  /** A drag is under way: changes are not steps yet. */
  gesture = $state(false);

  task = $state.raw<TaskAnswer | null>(null);
  map = $state.raw<MapAnswer | null>(null);
  /** Of the whole region at 400² (100² in a slow drag), whatever part of it is on screen. */
  census = $state.raw<Census | null>(null);
  refusal = $state.raw<Mistake[] | null>(null);
  incomplete = $state<Incomplete>(null);
  engine_ms = $state(0);
  window = $state.raw<Window>(whole);

  hovered = $state.raw<TauPair | null>(null);
  /** The linkage that all views show: the hovered one, else the picked one. */
  hand = $state.raw<Linkage | null>(null);
  picked_linkage = $state.raw<Linkage | null>(null);
  live = $state.raw<Replies["live"] | null>(null);
  halo = $state.raw<(Replies["halo"] & {pose: number; mode: "move" | "turn"}) | null>(null);
  verified = $state.raw<Replies["verify"] | null>(null);
  improving = $state(false);

  /** Where the drive stands: comparable between linkages (state/drive.ts). */
  stage = $state(2.45);
  playing = $state(false);
  /** Play and plot over the whole travel of the driver, not only from the first position to the last. */
  whole_travel = $state(false);
  /** Position (from 0) that was passed a moment ago. */
  lit_pose = $state<number | null>(null);

  selected_pose = $state<number | null>(null);
  /** A pose being dragged: its table row glows. */
  held_pose = $state<number | null>(null);
  mode = $state<Mode>("point");
  /** Counts the tasks that were opened: each is shown whole. */
  opened = $state(0);
  /** Curve coordinate under the pointer on the drawing: bead on both axes of the map. */
  curve_hover = $state<number | null>(null);
  /** Legend entry under the pointer (type code): others fade. */
  type_hover = $state<number | null>(null);
  /** Ends of the colour ramp that the user has set, by property. */
  ramps = $state.raw<Partial<Record<Property, readonly [number, number]>>>({});
  /** What the last painting of the map took on the main thread. */
  paint_ms = $state(0);
  full = $state<"none" | "drawing" | "map">("none");
  solid = $state(false);
  sheet = $state<Sheet | null>(null);
  dialog = $state<Dialog | null>(null);
  toasts = $state.raw<Toast[]>([]);
  /** Step of the drawing's grid at its zoom, to which positions snap; the drawing says. */
  grid_step = $state(0);
  engine_state = $state<"loading" | "ready" | "missing" | "slow">("loading");
  /** Step of the short tour, from 0; null: it is not on. */
  tour = $state<number | null>(null);
  file_name = $state<string | null>(null);
  kept = $state(true); // the browser stores work between visits

  private history: History<Document>;
  private engine: EngineClient | null = null;
  private driver: EngineClient | null = null;
  private last_good: Document;
  private good_text = ""; // what the engine read of it
  private refused: Problem | null = null;
  private verified_for = "";
  private offering = false; // a gesture has ended: if the picked linkage was lost, the best is offered
  private asked = ""; // what the map on screen, or on its way, answers
  private asked_samples = 0;
  private slow_maps = 0; // in a row
  private quick_maps = 0; // left until the next trial at 400²
  private rest_timer: ReturnType<typeof setTimeout> | undefined;
  private fine_timer: ReturnType<typeof setTimeout> | undefined;
  private fine = false;
  private slow_timer: ReturnType<typeof setTimeout> | undefined;
  private toast_id = 0;
  private want_best = false;
  private picked_problem: Problem | null = null; // whose answer picked_linkage is
  private listeners: (() => void)[] = [];

  constructor(problem: Problem, now: () => number = () => performance.now()) {
    this.document = from_problem(problem);
    this.history = new History(this.document, now);
    this.last_good = this.document;
  }

  get problem(): Problem {
    return this.document.problem;
  }
  get pins(): readonly Pin[] {
    return this.document.pins;
  }
  get picked(): Picked | null {
    return this.document.picked;
  }
  get tau_in_hand(): TauPair | null {
    return this.hovered ?? this.document.picked?.tau ?? null;
  }
  get unit(): string {
    return this.problem.length_unit ?? "";
  }
  /** The problem as it is saved and shared: with what is picked and pinned. */
  get whole_problem(): Problem {
    const {problem, picked, pins, order} = this.document;
    const view = {...problem.view, pins: pins.length ? pins : undefined, picked: picked?.tau, order: order ?? undefined};
    return with_view(problem, view);
  }

  // ---- engine -------------------------------------------------------------------------------------------------

  /** Starts the workers. With one core, one worker does both, hover first. */
  connect(start: () => Worker, cores: number): void {
    const gave_up = () => this.say("state.engine_gave_up", {}, {key: "state.again", run: () => this.wake()});
    const crashed = (_: string, resting: boolean) => {
      this.asked = "";
      if (resting) return gave_up();
      this.say("state.engine_stopped");
      setTimeout(() => this.refresh(), 0);
    };
    const ready = () => {
      this.engine_state = "ready";
      this.refresh();
    };
    this.engine = new EngineClient(start, crashed, ready);
    this.driver = cores > 1 ? new EngineClient(start, (_, resting) => resting && gave_up(), () => this.follow()) : this.engine;
  }
  /** For tests and the Stop button. */
  restart_engine(): void {
    this.engine?.restart();
  }
  /** Starts again what rests after dying time after time: the user has asked for it, or changed the task. */
  private wake(): void {
    for (const client of new Set([this.engine, this.driver])) if (client?.resting) client.restart();
  }
  /** For tests: the worker dies as if the browser had killed it. */
  kill_engine(): void {
    this.engine?.kill();
  }
  /** What the page shows before the engine has answered: a stored answer for the document in force. */
  show_stored(task: TaskAnswer, map: MapAnswer | null, linkage: Linkage | null, live: Replies["live"] | null = null): void {
    this.task = task;
    this.map = map;
    this.census = map?.census ?? null;
    if (linkage && !this.picked) this.amend({picked: {tau: linkage.tau, place: places(task.axis, linkage.tau)}});
    this.amend({order: task.axis.order});
    this.hand = this.picked_linkage = linkage;
    this.live = live;
  }
  /** The map on screen is the engine's answer for the problem in force. */
  get is_current(): boolean {
    return engine_text(this.problem) === this.good_text;
  }
  get driver_client(): EngineClient | null {
    return this.driver;
  }

  /** Told after every committed change (storage). */
  on_commit(listener: () => void): void {
    this.listeners.push(listener);
  }

  // ---- editing ------------------------------------------------------------------------------------------------

  /** One undoable step. Steps with the same `merge` label within a second are one. */
  edit(change: (problem: Problem) => Problem, merge: string | null = null): void {
    this.commit({...this.document, problem: change(this.problem)}, merge);
  }
  edit_document(change: (document: Document) => Document, merge: string | null = null): void {
    this.commit(change(this.document), merge);
  }
  begin_gesture(): void {
    this.gesture = true;
  }
  /** A change inside a gesture: shown at once, not a step. */
  drag(change: (problem: Problem) => Problem): void {
    this.show({...this.document, problem: change(this.problem)});
  }
  drag_document(change: (document: Document) => Document): void {
    this.show(change(this.document));
  }
  end_gesture(): void {
    if (!this.gesture) return;
    this.gesture = false;
    this.halo = null;
    const kept = this.refusal && this.refused === this.problem ? this.last_good : this.document;
    this.refusal = null;
    this.offering = differs(kept, this.history.present);
    if (this.offering) this.commit(kept);
    else this.show(this.history.present);
  }
  cancel_gesture(): void {
    if (!this.gesture) return;
    this.gesture = false;
    this.halo = null;
    this.refusal = null;
    if (this.document !== this.history.present) this.show(this.history.present);
  }
  undo(): void {
    this.cancel_gesture();
    this.show(this.history.undo());
    this.told();
  }
  redo(): void {
    this.cancel_gesture();
    this.show(this.history.redo());
    this.told();
  }
  /** Another task altogether: one step, so that undo brings the old one back. */
  open(problem: Problem, file_name: string | null = null): void {
    this.cancel_gesture();
    this.window = whole;
    this.file_name = file_name;
    this.hovered = null;
    this.selected_pose = null;
    this.mode = "point";
    this.commit(from_problem(problem));
    ++this.opened;
  }

  private commit(document: Document, merge: string | null = null): void {
    this.history.commit(document, merge);
    this.show(document);
    this.told();
  }
  private told(): void {
    this.can_undo = this.history.can_undo;
    this.can_redo = this.history.can_redo;
    this.wake();
    for (const listener of this.listeners) listener();
  }
  private show(document: Document): void {
    this.document = document;
    this.keep_good();
    this.refresh();
  }
  /** Pins, pick and view are no matter of the engine's: they stay when it refuses the task. */
  private keep_good(): void {
    if (this.is_current) this.last_good = this.document;
  }
  /** What the engine adds to the document in force: no step. */
  private amend(change: Partial<Document>): void {
    const before = this.document;
    this.document = {...before, ...change};
    if (!this.gesture && this.history.present === before) this.history.amend(this.document);
    this.keep_good();
  }

  // ---- map ----------------------------------------------------------------------------------------------------

  /** Brings map, curves and the linkage in hand up to the document, coarsely at first and finer at rest. */
  refresh(): void {
    clearTimeout(this.rest_timer);
    clearTimeout(this.fine_timer);
    this.fine = false;
    const count = position_count(this.problem);
    this.incomplete = count === 0 ? "empty" : count < 4 ? "too_few" : count > 4 ? "too_many" : null;
    if (this.incomplete) {
      this.task = this.map = this.census = this.hand = this.picked_linkage = this.live = this.refusal = null;
      this.asked = "";
      this.last_good = this.document;
      return;
    }
    const quick = this.gesture && this.quick_maps > 0;
    if (quick) --this.quick_maps;
    void this.explore(quick ? quick_samples : even_samples, this.window);
    if (quick) this.rest_timer = setTimeout(() => void this.explore(even_samples, this.window), 80);
    this.follow();
  }
  zoom(window: Window): void {
    this.window = window;
    this.refresh();
  }

  private async explore(samples: number, window: Window): Promise<void> {
    if (!this.engine || this.engine_state === "missing") return;
    const document = this.document, text = engine_text(document.problem);
    const property = preferences.colour_by === "type" ? "min_transmission_angle_deg" : preferences.colour_by;
    const question = (order: number | null) => JSON.stringify([text, window, property, order]);
    const asked = question(document.order);
    if (asked === this.asked && samples <= this.asked_samples) return this.refine();
    this.asked = asked;
    this.asked_samples = samples;
    this.watch_slowness();
    try {
      const order = this.gesture ? "nearest" : (document.order ?? "fresh");
      const reply = await this.engine.request("explore", {problem: text, samples, window, property, order});
      this.calm();
      if (samples === even_samples) this.weigh(reply.engine_ms);
      this.take(reply, document, samples, window);
      if (this.asked !== asked) return;
      this.asked = question(reply.task.axis.order);
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
    if (this.incomplete) return; // positions were removed meanwhile
    const split = this.task !== null && this.gesture && this.task.axis.branches.length !== reply.task.axis.branches.length;
    this.task = reply.task;
    if (reply.map) this.map = reply.map;
    else this.map = this.census = this.hand = this.picked_linkage = null;
    this.engine_ms = reply.engine_ms;
    this.refusal = null;
    this.last_good = document;
    this.good_text = engine_text(document.problem);
    if (reply.map && window === whole && samples !== fine_samples) this.census = reply.map.census;
    if (split) this.say(reply.task.axis.branches.length > 1 ? "state.curve_split" : "state.curve_joined");
    const current = this.document.problem === document.problem;
    if (current || this.gesture) this.settle_on_axis();
    this.follow();
  }
  /** The picked linkage keeps its place on the map; a freshly loaded one gets its place from τ. */
  private settle_on_axis(): void {
    const {axis} = this.task!;
    if (axis.blocks.length === 0) return; // no curve: picked and pins wait for one
    const {picked, pins} = this.document;
    const settled = picked && {
      tau: picked.place ? kept_tau(picked.tau, [tau_at(axis, picked.place[0]), tau_at(axis, picked.place[1])]) : picked.tau,
      place: picked.place ?? places(axis, picked.tau),
    };
    const marked = pins.some((pin) => !pin.place) ? pins.map((pin) => (pin.place ? pin : {...pin, place: places(axis, pin.tau) ?? undefined})) : pins;
    const moved = settled?.tau !== picked?.tau || settled?.place !== picked?.place;
    if (moved || marked !== pins || axis.order !== this.document.order) this.amend({order: axis.order, picked: moved ? settled : picked, pins: marked});
    if (!settled && !this.want_best) void this.pick_best(true);
  }
  private not_explored(error: unknown, document: Document, asked: string): void {
    if (this.asked === asked) this.asked = "";
    if (error instanceof Crashed) return; // on_crash asks again
    if (!(error instanceof Refusal)) throw error;
    if (this.document.problem !== document.problem) return;
    this.refusal = error.mistakes;
    this.refused = document.problem;
    if (this.gesture) return; // the last good state stays on screen until the drag moves on or ends
    this.document = this.last_good;
    this.history.retract(this.last_good, (a, b) => !differs(a, b));
    this.told();
    this.follow();
  }
  private refine(): void {
    clearTimeout(this.fine_timer);
    if (this.gesture || this.fine) return;
    this.fine_timer = setTimeout(() => {
      this.fine = true;
      const refined = () => void (this.fine && this.explore(fine_samples, this.window));
      const counted = this.window === whole ? null : this.count_whole();
      if (counted && this.driver === this.engine) void counted.then(refined); // one worker: the later would replace the earlier
      else refined();
    }, 300);
  }
  /** Zoomed in, the counts are still of the whole region. */
  private async count_whole(): Promise<void> {
    const document = this.document;
    const content = {problem: engine_text(document.problem), samples: even_samples, window: whole, property: "min_transmission_angle_deg" as const, order: document.order ?? ("fresh" as const)};
    const reply = await this.driver?.request("explore", content).catch(() => null);
    if (reply?.map && this.document.problem === document.problem) this.census = reply.map.census;
  }
  private watch_slowness(): void {
    clearTimeout(this.slow_timer);
    this.slow_timer = setTimeout(() => {
      if (this.engine_state === "ready") this.engine_state = "slow";
    }, 3000);
  }
  private calm(): void {
    clearTimeout(this.slow_timer);
    if (this.engine_state === "slow") this.engine_state = "ready";
  }

  // ---- the linkage in hand ------------------------------------------------------------------------------------

  hover(tau: TauPair | null): void {
    this.hovered = tau;
    if (tau) void this.fetch_hand();
    else if (this.picked_linkage && this.picked_problem === this.problem && same_tau(this.picked_linkage.tau, this.document.picked?.tau)) {
      this.hand = this.picked_linkage;
      void this.fetch_live();
    } else this.follow();
  }
  /** An undoable choice. */
  pick(tau: TauPair, merge: string | null = null): void {
    const place = this.task ? places(this.task.axis, tau) : null;
    this.edit_document((document) => ({...document, picked: {tau, place}}), merge);
  }
  /** Inside a gesture: a pivot slides along its curve. */
  slide(tau: TauPair): void {
    const place = this.task ? places(this.task.axis, tau) : null;
    this.drag_document((document) => ({...document, picked: {tau, place}}));
  }
  async pick_best(quietly = false): Promise<void> {
    if (!this.driver) return;
    this.want_best = true;
    const problem = this.problem;
    const reply = await this.driver.request("best", {problem: engine_text(problem), most: 1}).catch(() => null);
    this.want_best = false;
    if (!reply || this.problem !== problem) return;
    if (reply.linkages.length === 0) {
      if (!quietly) this.say("state.nothing_to_go_to");
      return;
    }
    const tau = reply.linkages[0].tau;
    if (quietly) {
      this.amend({picked: {tau, place: this.task && places(this.task.axis, tau)}});
      this.follow();
    } else this.pick(tau);
  }
  /** The next local best of another type (N), or the one before. */
  async pick_next_best(step: 1 | -1): Promise<void> {
    const problem = this.problem, at = this.document.picked;
    const reply = await this.driver?.request("best", {problem: engine_text(problem), most: 20}).catch(() => null);
    if (!reply || reply.linkages.length === 0 || this.problem !== problem) return;
    const firsts = reply.linkages.filter((a, i, all) => all.findIndex((b) => b.type === a.type) === i);
    const now = firsts.findIndex((f) => f.type === this.picked_linkage?.type);
    const next = firsts[(now + step + firsts.length) % firsts.length];
    if (at?.tau[0] !== next.tau[0] || at.tau[1] !== next.tau[1]) this.pick(next.tau);
  }
  async improve(): Promise<void> {
    const picked = this.document.picked, problem = this.problem;
    if (!picked || !this.driver) return;
    this.improving = true;
    const reply = await this.driver.request("improve", {problem: engine_text(problem), tau: picked.tau}).catch(() => null);
    this.improving = false;
    if (!reply || this.problem !== problem) return;
    if (reply.improved) this.pick(reply.tau);
    else this.say("state.cannot_improve");
  }
  /** The same bars driven from the other side. */
  swap_driver(): void {
    const tau = this.tau_in_hand;
    if (tau) this.pick([tau[1], tau[0]]);
  }

  /** Fetches what the document's picked linkage, and the one in hand, are now. */
  private follow(): void {
    if (!this.task || this.task.status !== "solved") return;
    void this.fetch_hand();
  }
  private async fetch_hand(): Promise<void> {
    const tau = this.tau_in_hand, problem = this.problem;
    if (!tau || !this.driver) {
      this.hand = null;
      return;
    }
    try {
      const reply = await this.driver.request("linkage", {problem: engine_text(problem), tau});
      if (this.incomplete || !same_tau(this.tau_in_hand, tau)) return;
      this.hand = reply.linkage;
      void this.fetch_live();
      if (same_tau(tau, this.document.picked?.tau)) this.take_picked(reply.linkage, problem);
    } catch (error) {
      if (error instanceof Crashed) setTimeout(() => this.follow(), 50);
    }
  }
  private take_picked(linkage: Linkage, problem: Problem): void {
    this.picked_linkage = linkage;
    this.picked_problem = problem;
    if (this.gesture) return;
    void this.fetch_verified(linkage.tau, problem);
    if (this.offering && this.is_current) {
      this.offering = false;
      this.offer_best();
    }
  }
  private async fetch_live(): Promise<void> {
    const tau = this.tau_in_hand, problem = this.problem;
    if (!tau || !this.driver) return;
    const reply = await this.driver.request("live", {problem: engine_text(problem), tau}).catch(() => null);
    if (reply) this.live = reply;
  }
  private async fetch_verified(tau: TauPair, problem: Problem): Promise<void> {
    const asked = engine_text(problem) + tau.join();
    if (asked === this.verified_for && this.verified) return;
    this.verified = null;
    this.verified_for = asked;
    const reply = await this.driver!.request("verify", {problem: engine_text(problem), tau}).catch(() => null);
    if (reply && asked === this.verified_for) this.verified = reply;
  }
  /** Where a held position may go with linkages left; steps² cells of a square, or steps of an arc. */
  async fetch_halo(pose: number, mode: "move" | "turn", reach: number): Promise<void> {
    const problem = this.problem, held = () => this.gesture && this.held_pose === pose;
    const ask = async (steps: number) => {
      const reply = await this.driver?.request("halo", {problem: engine_text(problem), pose, mode, reach, steps, samples: 60}).catch(() => null);
      if (reply && held()) this.halo = {...reply, pose, mode};
      return reply;
    };
    let reply = await ask(mode === "turn" ? 61 : 13);
    if (mode === "turn") return;
    for (let closer = 0; closer < 2 && reply && held() && in_inner_half(reply.counts, 13); ++closer) {
      reach /= 2;
      reply = await ask(13);
    }
    let seen = this.document;
    while (held()) { // finer once the hand rests
      await new Promise((resolve) => setTimeout(resolve, 300));
      if (this.document === seen) return void (await (held() && ask(25)));
      seen = this.document;
    }
  }

  // ---- pins ---------------------------------------------------------------------------------------------------

  pin(linkage: Linkage | null = this.hand): void {
    if (!linkage) return;
    const {pins} = this.document;
    const known = pins.find((p) => same_poses(p.poses, this.problem.task.poses) && Math.hypot(p.tau[0] - linkage.tau[0], p.tau[1] - linkage.tau[1]) < 1e-6);
    if (known) return this.say("state.already_pinned", {name: known.name});
    const pin = new_pin(linkage, this.problem, free_name(pins), this.task ? places(this.task.axis, linkage.tau) : null);
    this.edit_document((document) => ({...document, pins: [...document.pins, pin]}));
    this.say("state.pinned", {name: pin.name}, {key: "edit.undo", run: () => this.undo()});
  }
  /** Pins the linkage at a place that was pointed at, fetching it if it is not in hand yet. */
  async pin_at(tau: TauPair): Promise<void> {
    const problem = this.problem;
    for (let tries = 0; tries < 3 && this.problem === problem; ++tries) {
      if (this.hand?.tau.join() === tau.join()) return this.pin(this.hand);
      const reply = await this.driver?.request("linkage", {problem: engine_text(problem), tau}).catch(() => null);
      if (reply) return this.pin(reply.linkage);
    }
  }
  unpin(name: string): void {
    this.edit_document((document) => ({...document, pins: document.pins.filter((pin) => pin.name !== name)}));
  }
  change_pin(name: string, change: Partial<Pin>): void {
    this.edit_document((document) => ({...document, pins: document.pins.map((pin) => (pin.name === name ? {...pin, ...change} : pin))}), `pin ${name}`);
  }
  is_stale(pin: Pin): boolean {
    return !same_poses(pin.poses, this.problem.task.poses);
  }
  /** Takes a pin in hand; one of an earlier task brings that task back. One step. */
  pick_pin(pin: Pin): void {
    this.edit_document((document) => ({
      ...document,
      problem: this.is_stale(pin) ? {...document.problem, task: {...document.problem.task, poses: pin.poses}} : document.problem,
      picked: {tau: pin.tau, place: this.is_stale(pin) ? null : (pin.place ?? null)},
    }));
  }

  // ---- drive --------------------------------------------------------------------------------------------------

  /** Driver angle of the linkage in hand, degrees from position 1. */
  get angle(): number {
    return this.hand?.drive ? angle_at_stage(this.hand.drive, this.stage) : 0;
  }
  set_angle(angle_deg: number): void {
    if (this.hand?.drive) this.stage = stage_at_angle(this.hand.drive, angle_deg);
  }

  // ---- words --------------------------------------------------------------------------------------------------

  say(key: TextKey, values: Values = {}, action?: Toast["action"]): void {
    const toast = {id: ++this.toast_id, key, values, action};
    this.toasts = [...this.toasts.filter((t) => t.key !== key).slice(-2), toast];
    const long = action !== undefined || /bad|huge|newer|storage/.test(key);
    setTimeout(() => this.dismiss(toast.id), long ? 10_000 : key === "state.curve_split" || key === "state.curve_joined" ? 2000 : 5000);
  }
  dismiss(id: number): void {
    this.toasts = this.toasts.filter((toast) => toast.id !== id);
  }
  private offer_best(): void {
    const hand = this.picked_linkage;
    if (hand && hand.fails !== 0 && this.census && this.census.meeting > 0) {
      this.say("state.picked_lost", {}, {key: "region.best", run: () => void this.pick_best()});
    }
  }
}

/** The document of a problem file: picked linkage and pins are taken out of its view. */
export function from_problem(problem: Problem): Document {
  const {picked, pins, order, ...view} = problem.view ?? {};
  return {
    problem: Object.keys(view).length ? {...problem, view} : (({view: _, ...rest}) => rest)(problem),
    picked: picked ? {tau: picked, place: null} : null,
    pins: pins ?? [],
    order: order ?? null,
  };
}

/** Whether there is something, and nothing of it outside of the inner half of a square of steps² cells. */
function in_inner_half(counts: ArrayLike<number>, steps: number): boolean {
  const middle = (steps - 1) / 2, all = Array.from(counts, (count, i) => count > 0 && Math.max(Math.abs((i % steps) - middle), Math.abs(Math.floor(i / steps) - middle)));
  const farthest = Math.max(...all.map((distance) => (distance === false ? -1 : distance)));
  return farthest >= 0 && farthest <= middle / 2;
}
function places(axis: TaskAnswer["axis"], tau: TauPair): TauPair | null {
  const input = place_of(axis, tau[0]), output = place_of(axis, tau[1]);
  return input === null || output === null ? null : [input, output];
}
/** τ as it was where its place has not moved it: undo restores a linkage to the last bit. */
function kept_tau(before: TauPair, now: TauPair): TauPair {
  return Math.hypot(before[0] - now[0], before[1] - now[1]) < 1e-9 ? before : now;
}
function differs(a: Document, b: Document): boolean {
  const same_problem = a.problem === b.problem || problem_text(a.problem) === problem_text(b.problem);
  return !same_problem || a.pins !== b.pins || a.picked?.tau.join() !== b.picked?.tau.join();
}
function same_tau(a: TauPair | null | undefined, b: TauPair | null | undefined): boolean {
  return a === b || (!!a && !!b && a[0] === b[0] && a[1] === b[1]);
}
function free_name(pins: readonly Pin[]): string {
  for (let i = 0; ; ++i) {
    const name = String.fromCharCode(65 + (i % 26)) + (i < 26 ? "" : Math.floor(i / 26));
    if (!pins.some((pin) => pin.name === name)) return name;
  }
}
function new_pin(linkage: Linkage, problem: Problem, name: string, place: TauPair | null): Pin {
  const pivot = (point: Point | null) => point;
  return {
    name,
    tau: linkage.tau,
    place: place ?? undefined,
    poses: problem.task.poses,
    type: linkage.type,
    min_transmission_angle_deg: linkage.min_transmission_angle_deg,
    link_ratio: linkage.link_ratio,
    longest: linkage.longest,
    lengths: linkage.lengths,
    pivots: {
      input_center: pivot(linkage.input.center), input_circle: pivot(linkage.input.circle),
      output_center: pivot(linkage.output.center), output_circle: pivot(linkage.output.circle),
    },
  };
}
export function type_code(type: Linkage["type"]): number {
  return linkage_types.indexOf(type);
}
