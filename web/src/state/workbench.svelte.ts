// The one state of the page. Views read it and call its actions; none keeps a copy. What is undoable is in `document`
// (editing.svelte.ts); the rest is how it is being looked at and what the engine answers, for which two followers ask.
import {analysis_of_card, block_of} from "../analyses/analysis_dispatch";
import {EngineClient, no_answer, patience_ms} from "../engine/client";
import {
  whole,
  type Box,
  type Census,
  type Linkage,
  type Live,
  type MapAnswer,
  type Picked,
  type Property,
  type Replies,
  type Requests,
  type Side,
  type TaskAnswer,
  type TauPair,
  type MapWindow,
} from "../contract/messages";
import type {Incomplete} from "../kinds/kind";
import {
  has_lengths,
  gives_linkage,
  has_linkages,
  incompleteness,
  kind_of,
  linkages_at_place,
  map_of,
  measure_of,
  properties_of,
  with_other_task,
  with_pose_moved,
} from "../kinds/kind_dispatch";
import {Question} from "../questions/question.svelte";
import {Questions} from "../questions/questions";
import type {TextKey, Values} from "../texts/texts.svelte";
import {Answers, type Halo} from "./answers.svelte";
import {BestList} from "./best_list.svelte";
import {BestSeeker} from "./best_seeker";
import {held_tau, held_window, places_of} from "../engine/axis";
import {from_problem, to_problem} from "./document";
import {angle_at_stage, stage_at_angle} from "./drive";
import {Editing} from "./editing.svelte";
import {HaloFollower} from "./halo_follower";
import {LinkageFollower} from "./linkage_follower";
import {MapFollower} from "./map_follower";
import {find_pin, free_name, new_pin} from "./pins";
import {preferences} from "./preferences.svelte";
import {most_pins, type Pin, type Problem} from "./problem";
import type {Steps} from "./steps";
import {same_task, same_value} from "./task";
import {WayOutSeeker} from "./way_out.svelte";
import {after_change, with_toast, type Toast} from "./toasts";

export type Mode = "point" | "outline" | "ground_box" | "moving_box" | "search_box" | "trace" | "scale" | "draw";
/** What stands below the map; else an analysis's card, by its id. */
export const below_kinds = ["numbers", "best"] as const;
export type Sheet = "task" | "limits" | "pins" | "numbers" | "map";
export type Dialog = "examples" | "tasks" | "export" | "keys" | "compare" | "new" | "kind" | "print";

/** A task is shown between the last two positions. */
const before_last = 1.55;
/** A round of a search takes longer than any answer, and the user has a button to stop it. */
const search_patience = 10;

export class Workbench extends Editing {
  readonly questions = new Questions();
  /** What the engine has said, each with the problem of which it said it. */
  readonly answers = new Answers(this.questions, this);
  incomplete = $state.raw<Incomplete | null>(null);
  window = $state.raw<MapWindow>(whole);

  hovered = $state.raw<TauPair | null>(null);

  /** Where the drive stands: comparable between linkages (state/drive.ts). */
  stage = $state(4 - before_last);
  playing = $state(false);
  /** Play and plot over the whole travel of the driver, not only from the first position to the last. */
  whole_travel = $state(false);
  /** Position (from 0) that was passed a moment ago. */
  lit_pose = $state<number | null>(null);

  selected_pose = $state<number | null>(null);
  /** A pose being dragged: its table row glows. */
  held_pose = $state<number | null>(null);
  mode = $state<Mode>("point");
  /** The box in which a search puts its pivots, while it is on the drawing. */
  search_box = $state.raw<Box | null>(null);
  /** Counts the tasks that were opened: each is shown whole. */
  opened = $state(0);
  /** Curve coordinate under the pointer on the drawing: bead on the axes of these sides. */
  curve_hover = $state.raw<{sides: readonly Side[]; tau: number} | null>(null);
  /** Legend entry under the pointer (type code): others fade. */
  type_hover = $state<number | null>(null);
  /** Ends of the colour ramp that the user has set, by property. */
  ramps = $state.raw<Partial<Record<Property, readonly [number, number]>>>({});
  /** What the last painting of the map took on the main thread. */
  paint_ms = $state(0);
  full = $state<"none" | "drawing" | "map">("none");
  solid = $state(false);
  sheet = $state<Sheet | null>(null);
  below = $state<string>("numbers");
  dialog = $state<Dialog | null>(null);
  toasts = $state.raw<Toast[]>([]);
  /** Step of the drawing's grid at its zoom, to which positions snap; the drawing says. */
  grid_step = $state(0);
  /** Counts the starts of engines: what was on its way to one before is asked anew. */
  starts = $state(0);
  engine_state = $state<"loading" | "ready" | "missing" | "slow">("loading");
  /** Step of the short tour, from 0; null: it is not on. */
  tour = $state<number | null>(null);
  file_name = $state<string | null>(null);
  kept = $state(true); // the browser stores work between visits
  slot = ""; // where it does (shell/storage)
  kept_since: number | null = null; // when a visit before left it there; null: it did not

  readonly seeker = new BestSeeker(this);
  readonly linkages = new LinkageFollower(this, (linkage) => this.seeker.weigh(linkage));
  readonly maps = new MapFollower(this, this.linkages, () => this.seeker.start());
  readonly halos = new HaloFollower(this);
  readonly way_out = new WayOutSeeker(this, with_pose_moved);
  readonly best_list = new BestList(this);
  /** What analyses keep of what they have found, by what they call it. */
  readonly studies: Record<string, object> = {};
  /** The linkage as plates on pins, whoever shows it: one is asked for at a time. */
  readonly machines = new Question<Requests["machine"], Replies["machine"]>(this.questions, {
    same: same_value,
    follows: true,
  });
  engine: EngineClient | null = null; // follows the task
  driver_client: EngineClient | null = null; // follows the pointer
  /** One more engine, for what takes its time. */
  start_engine: (() => EngineClient) | null = null;
  private toast_id = 0;
  private map_shown = "";

  constructor(start: Problem | Steps, now?: () => number) {
    super(start, now);
    this.on_commit(() => {
      const left = after_change(this.toasts);
      if (left.length < this.toasts.length) this.toasts = left;
    });
  }

  get task(): TaskAnswer | null {
    return this.answers.task;
  }
  get map(): MapAnswer | null {
    return this.answers.map;
  }
  /** Of the whole region at 400² (100² in a slow drag), whatever part of it is on screen. */
  get census(): Census | null {
    return this.answers.census;
  }
  /** The linkage that all views show: the hovered one, else the picked one. */
  get hand(): Linkage | null {
    return this.answers.hand;
  }
  get picked_linkage(): Linkage | null {
    return this.answers.picked_linkage;
  }
  get live(): Live | null {
    return this.answers.live;
  }
  /** What driving has found of the very linkage in hand through the very task in force; null: not known. */
  get verified(): Replies["verify"] | null {
    const {hand, problem, answers} = this,
      {verdict} = this.linkages;
    return hand && answers.hand_is_of_present && verdict.is_of({problem, tau: hand.tau}) ? verdict.value : null;
  }
  get halo(): Halo | null {
    return this.answers.halo;
  }
  get improving(): boolean {
    return this.seeker.improving;
  }
  get engine_ms(): number {
    return this.answers.engine_ms;
  }
  get tau_in_hand(): TauPair | null {
    return this.hovered ?? this.picked?.tau ?? null;
  }
  /** What the map's colours stand for: what the user wants, where the task has it. */
  get coloring(): "type" | Property {
    const {colour_by} = preferences;
    return colour_by !== "type" && properties_of(this.problem).includes(colour_by) ? colour_by : "type";
  }
  /** What is asked of the engine with a map: behind the types, what the objective goes by. */
  get property(): Property {
    return this.coloring === "type" ? measure_of(this.problem) : this.coloring;
  }
  get unit(): string {
    return has_lengths(this.problem.task) ? (this.problem.length_unit ?? "") : "";
  }
  /** What was asked for below the map, where there is that. */
  get below_map(): string {
    if (gives_linkage(this.problem.task)) return "numbers";
    const analysis = analysis_of_card(this.below);
    return analysis && !block_of(this.problem, analysis) ? "numbers" : this.below;
  }
  /** Made when it is first asked for. */
  study<Study extends object>(name: string, make: (of: Workbench) => Study): Study {
    return (this.studies[name] ??= make(this)) as Study;
  }
  /** The problem as it is saved and shared: with what is picked and pinned. */
  get whole_problem(): Problem {
    return to_problem(this.document);
  }

  // ---- engine -------------------------------------------------------------------------------------------------

  /** Starts the workers. With one core, one worker does both, hover first. */
  connect(start: () => Worker, cores: number): void {
    const died = (reason: string, resting: boolean): void => {
      if (resting) this.say("state.engine_gave_up", {}, {key: "state.again", run: () => this.wake()});
      else if (reason === no_answer) this.say("state.engine_hung", {s: patience_ms / 1000});
      else this.say("state.engine_stopped");
    };
    const crashed = (reason: string, resting: boolean): void => {
      this.maps.forget();
      died(reason, resting);
      if (!resting) setTimeout(() => this.refresh(), 0);
    };
    const ready = () => {
      ++this.starts;
      this.engine_state = "ready";
      this.refresh();
    };
    const driver_ready = () => {
      ++this.starts;
      this.linkages.follow();
    };
    this.engine = new EngineClient(start, crashed, ready);
    this.driver_client = cores > 1 ? new EngineClient(start, died, driver_ready) : this.engine;
    const unheard = () => {};
    this.start_engine = () => new EngineClient(start, unheard, unheard, search_patience * patience_ms);
    this.on_commit(() => this.wake());
  }
  /** The Stop button. */
  restart_engine(): void {
    this.engine?.restart();
  }
  /** Starts again what rests after dying time after time: the user has asked for it, or changed the task. */
  private wake(): void {
    for (const client of [this.engine, this.driver_client]) if (client?.resting) client.restart();
  }
  /** What the page shows before the engine has answered: a stored answer for the document in force. */
  show_stored(task: TaskAnswer, map: MapAnswer | null, linkage: Linkage | null, live: Live | null = null): void {
    const {answers, problem} = this;
    answers.explored.put({problem}, {task, map, linkage, live: null, engine_ms: 0});
    if (map) answers.counted.put({problem}, map.census);
    if (linkage && !this.picked) this.amend({picked: {tau: linkage.tau, place: this.place_of(linkage.tau)}});
    this.amend({order: task.axes.input.order});
    if (linkage) {
      answers.take_hand(linkage, problem);
      answers.take_picked(linkage, problem);
      this.seeker.weigh(linkage); // a change may come before the engine
      if (live) answers.along.put({problem, tau: linkage.tau}, live);
    }
  }
  /** Brings map, curves and the linkage in hand up to the document. */
  refresh(): void {
    this.incomplete = incompleteness(this.problem);
    this.show_whole_map();
    if (this.incomplete || !has_linkages(this.problem.task)) {
      this.answers.forget();
      this.maps.stop();
      this.maps.forget();
      if (this.incomplete) this.accept_unread(); // else its kind asks the engine itself
    } else {
      this.answers.asked_anew();
      if (gives_linkage(this.problem.task)) return this.take_given();
      this.maps.refresh();
      if (this.answers.map_is_of_present) this.linkages.follow(); // else the map brings it
    }
  }
  /** The task is the linkage in hand. */
  private take_given(): void {
    this.maps.stop();
    this.maps.forget();
    this.answers.forget_map();
    if (!this.picked) this.amend({picked: {tau: [0, 0], place: null}});
    this.linkages.follow();
  }
  /** A part of one map is no part of another. */
  private show_whole_map(): void {
    const map = map_of(this.problem.task);
    if (map !== this.map_shown) this.window = whole;
    this.map_shown = map;
  }
  zoom(window: MapWindow): void {
    this.window = this.task ? held_window(this.task.axes, window) : window;
    this.refresh();
  }

  // ---- editing ------------------------------------------------------------------------------------------------

  override end_gesture(): void {
    this.halos.release();
    super.end_gesture();
  }
  override cancel_gesture(): void {
    this.halos.release();
    super.cancel_gesture();
  }
  /** Another task altogether: one step, so that undo brings the old one back. */
  open(problem: Problem, file_name: string | null = null): void {
    this.cancel_gesture();
    this.window = whole;
    this.file_name = file_name;
    this.hovered = null;
    this.selected_pose = null;
    this.mode = "point";
    this.stage = gives_linkage(problem.task)
      ? 0 // as it lies in its file
      : Math.max(kind_of(problem.task).stops(problem.task) - before_last, 0.45);
    this.just_changed = false;
    this.commit(from_problem(problem));
    ++this.opened;
  }

  // ---- the linkage in hand ------------------------------------------------------------------------------------

  hover(tau: TauPair | null): void {
    this.hovered = tau;
    this.answers.asked_anew();
    this.linkages.hover();
  }
  /** An undoable choice. */
  pick(tau: TauPair, merge: string | null = null): void {
    const picked = this.placed(tau);
    this.edit_document((document) => ({...document, picked}), merge);
  }
  /** Inside a gesture: a pivot slides along its curve. */
  slide(tau: TauPair): void {
    const picked = this.placed(tau);
    this.drag_document((document) => ({...document, picked}));
  }
  /** In hand without a step. */
  put(tau: TauPair): void {
    this.amend({picked: {tau, place: this.place_of(tau)}});
    this.linkages.follow();
  }
  private placed(tau: TauPair): Picked {
    return {tau: this.task ? held_tau(this.task.axes, tau) : tau, place: this.place_of(tau)};
  }
  pick_best(): Promise<void> {
    return this.seeker.pick_best();
  }
  /** The next local best of another type (N), or the one before. */
  pick_next_best(step: 1 | -1): Promise<void> {
    return this.seeker.pick_next_best(step);
  }
  improve(): Promise<void> {
    return this.seeker.improve();
  }
  /** Of several linkages at a place of the map the one so many on from that in hand. */
  pick_beside(step: number): void {
    const {all, at} = (this.hand && linkages_at_place(this.hand)) ?? {all: [], at: 0};
    if (all.length < 2) return;
    if (this.hovered) this.hover(null);
    this.pick(all[(at + step + all.length) % all.length]!, "beside");
  }
  /** The same bars driven from the other side. */
  swap_driver(): void {
    const tau = this.tau_in_hand;
    if (tau && this.task?.symmetric) this.pick([tau[1], tau[0]]);
  }
  /** Where a held part of the task may go with linkages left. */
  fetch_halo(part: number, mode: "move" | "turn", reach: number): Promise<void> {
    return this.halos.follow(part, mode, reach);
  }
  /** For the first step of the tour: where the position with the most room may go. */
  offer_halo(poses: number, reach: number): Promise<void> {
    return this.halos.offer(poses, reach, () => this.tour === 0);
  }
  private place_of(tau: TauPair): TauPair | null {
    return this.task && places_of(this.task.axes, tau);
  }

  // ---- pins ---------------------------------------------------------------------------------------------------

  pin(linkage: Linkage | null = this.hand): void {
    if (linkage && linkage === this.hand && !this.answers.hand_is_of_present)
      return void this.pin_at(this.tau_in_hand ?? linkage.tau); // as the task is now
    if (!linkage) return;
    const known = find_pin(this.pins, this.problem.task, linkage.tau);
    if (known) return this.say("state.already_pinned", {name: known.name});
    if (this.pins.length >= most_pins) return this.say("state.too_many_pins", {n: most_pins});
    const pin = new_pin(linkage, this.problem, free_name(this.pins), this.place_of(linkage.tau));
    this.edit_document((document) => ({...document, pins: [...document.pins, pin]}));
    this.say("state.pinned", {name: pin.name}, {key: "edit.undo", run: () => this.undo()});
  }
  /** Pins the linkage at a place that was pointed at, fetching it if it is not in hand yet. */
  async pin_at(tau: TauPair): Promise<void> {
    const linkage = await this.linkages.fetch(tau);
    if (linkage) this.pin(linkage);
    else this.say("state.not_pinned");
  }
  unpin(name: string): void {
    this.edit_document((document) => ({...document, pins: document.pins.filter((pin) => pin.name !== name)}));
  }
  change_pin(name: string, change: Partial<Pin>): void {
    this.edit_document(
      (document) => ({...document, pins: document.pins.map((pin) => (pin.name === name ? {...pin, ...change} : pin))}),
      `pin ${name}`,
    );
  }
  /** Those that have a place on the map. */
  get pins_on_map(): Pin[] {
    const map = map_of(this.problem.task);
    return this.pins.filter((pin) => pin.place && map_of(pin.task) === map);
  }
  is_stale(pin: Pin): boolean {
    return !same_task(pin.task, this.problem.task);
  }
  /** Takes a pin in hand; one of an earlier task brings that task back. One step. */
  pick_pin(pin: Pin): void {
    const stale = this.is_stale(pin);
    this.edit_document((document) => ({
      ...document,
      problem: stale ? with_other_task(document.problem, pin.task) : document.problem,
      picked: {tau: pin.tau, place: stale ? null : (pin.place ?? null)},
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
    this.toasts = with_toast(this.toasts, toast);
    const long = action !== undefined || /bad|huge|newer|storage|hung|state\.is_/.test(key);
    setTimeout(() => this.dismiss(toast.id), long ? 10_000 : 5000);
  }
  dismiss(id: number): void {
    this.toasts = this.toasts.filter((toast) => toast.id !== id);
  }
}
