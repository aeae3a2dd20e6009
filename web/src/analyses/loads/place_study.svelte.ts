// The spring that is looked for, how far that is, and the map of one of its studs; not part of the problem.
import type {EngineClient} from "../../engine/client";
import type {Box, PlacedSpring, Replies, StudEnd, TauPair, Tidings} from "../../contract/messages";
import {Refusal} from "../../engine/client";
import {Question} from "../../questions/question.svelte";
import {same_tau} from "../../state/document";
import {engine_text, type Problem} from "../../state/problem";
import type {Workbench} from "../../state/workbench.svelte";
import {loads_of, type Spring} from "./block";
import {with_loads} from "./editing";
import {boxes_text, choices_of, usual_wanted, with_placed, without_chosen, type Choice, type Wanted} from "./placing";

/** All that an answer depends on. */
interface Sought {
  problem: Problem;
  /** What of the problem counts. */
  text: string;
  tau: TauPair;
  boxes: string;
}
interface MapOf extends Sought {
  stud: StudEnd;
}
export const map_cells = 24; // along each side

function same_sought(a: Sought, b: Sought): boolean {
  return a.boxes === b.boxes && a.text === b.text && same_tau(a.tau, b.tau);
}

/** Of the page. */
export function place_study_of(desk: Pick<Workbench, "study">): PlaceStudy {
  return desk.study("place_springs", (workbench) => new PlaceStudy(workbench));
}
export class PlaceStudy {
  /** Its boxes are on the drawing. */
  shown = $state(false);
  /** Whose map is on the drawing. */
  mapped = $state<StudEnd | null>(null);
  seconds = $state(0);
  /** How the last search ended. */
  end = $state.raw<"done" | "stopped" | "failed" | null>(null);
  private chosen = $state.raw<Choice | null>(null);
  private typed = $state.raw<{of: string; change: Partial<Wanted>}>({of: "", change: {}});
  private found = $state.raw<{of: Sought; placed: PlacedSpring} | null>(null);
  private readonly question: Question<Sought, Replies["place_spring"]>;
  private readonly maps: Question<MapOf, Replies["stud_map"]>;

  constructor(private readonly workbench: Workbench) {
    const {questions} = workbench;
    this.question = new Question(questions, {same: same_sought});
    this.maps = new Question(questions, {same: (a, b) => a.stud === b.stud && same_sought(a, b), follows: true});
  }

  // ---- what is wanted -----------------------------------------------------------------------------------------------

  get choice(): Choice {
    const loads = loads_of(this.workbench.problem),
      choices = loads ? choices_of(loads) : [];
    return choices.find((choice) => choice === this.chosen) ?? choices[0] ?? "new";
  }
  get wanted(): Wanted | null {
    const usual = usual_wanted(this.workbench.problem, this.choice);
    return usual && {...usual, ...(this.typed.of === this.of_typed ? this.typed.change : {})};
  }
  /** Of another file, or another spring, something else was typed. */
  private get of_typed(): string {
    return `${this.choice}\n${this.workbench.problem.title ?? ""}\n${this.workbench.unit}`;
  }
  choose(choice: Choice): void {
    this.stop();
    this.chosen = choice;
    this.found = null;
    this.typed = {of: "", change: {}};
  }
  put(change: Partial<Wanted>): void {
    const {of_typed: of, typed} = this;
    this.typed = {of, change: {...(typed.of === of ? typed.change : {}), ...change}};
  }
  put_box(stud: StudEnd, box: Box): void {
    this.put({[stud]: box});
  }
  private get sought(): Sought | null {
    const {problem, tau_in_hand: tau} = this.workbench,
      {wanted} = this;
    if (!wanted || !tau) return null;
    const others = without_chosen(problem, this.choice),
      text = JSON.stringify([others.task, others.loads]);
    // A spring without a name cannot give way to the one that is looked for.
    const nameless = this.choice !== "new" && !problem.loads?.springs?.[this.choice]?.name;
    return {problem: nameless ? others : problem, text, tau, boxes: boxes_text(wanted)};
  }

  // ---- the search ---------------------------------------------------------------------------------------------------

  get running(): boolean {
    return this.question.busy;
  }
  get placed(): PlacedSpring | null {
    return this.found?.placed ?? null;
  }
  /** It is of the very boxes, loads and linkage that there are. */
  get is_present(): boolean {
    const {found, sought} = this;
    return found !== null && sought !== null && same_sought(found.of, sought);
  }
  get refusal(): Refusal | null {
    const {error} = this.question;
    return error instanceof Refusal ? error : null;
  }
  async place(): Promise<void> {
    const {start_engine} = this.workbench,
      {sought, wanted} = this;
    if (this.running || !start_engine || !sought || !wanted) return;
    this.question.forget();
    this.put({ground: wanted.ground, body: wanted.body}); // they stay where they are when it is taken
    [this.seconds, this.end, this.found] = [0, null, null];
    const reply = await this.question.ask(sought, (signal) => this.look(start_engine(), sought, signal), {
      at_leisure: true,
    });
    if (reply) this.found = reply.placed && {of: sought, placed: reply.placed};
    this.end ??= reply ? "done" : "failed";
  }
  private async look(client: EngineClient, sought: Sought, signal: AbortSignal): Promise<Replies["place_spring"]> {
    const begin = performance.now(),
      timer = setInterval(() => (this.seconds = Math.round((performance.now() - begin) / 1000)), 250);
    const {problem, tau, boxes} = sought,
      progress = ({found}: Tidings["place_spring"]) => void (this.found = {of: sought, placed: found});
    try {
      return await client.run({kind: "place_spring", problem: engine_text(problem), tau, boxes}, {signal, progress});
    } finally {
      clearInterval(timer);
      client.close();
    }
  }
  /** What was found so far is kept. */
  stop(): void {
    if (!this.running) return;
    this.end = "stopped";
    this.question.drop();
  }
  /** It is among the loads as it was found. */
  get is_taken(): boolean {
    const spring = this.placed?.spring,
      springs = this.workbench.problem.loads?.springs ?? [];
    return Boolean(spring) && springs.some((one) => same_spring(one, spring!));
  }
  take(): void {
    const {placed, choice, wanted} = this,
      spring = placed?.spring;
    if (!spring) return;
    const at = choice === "new" ? (this.workbench.problem.loads?.springs?.length ?? 0) : choice;
    this.workbench.edit((problem) => with_loads(problem, (loads) => with_placed(loads, choice, spring)));
    this.chosen = at; // from now on it is that one
    this.put(wanted!);
  }

  // ---- the map of a stud --------------------------------------------------------------------------------------------

  get map(): {stud: StudEnd; box: Box; map: NonNullable<Replies["stud_map"]["map"]>} | null {
    const {of, value} = this.maps;
    if (!of || !value?.map || of.stud !== this.mapped) return null;
    return {stud: of.stud, box: (JSON.parse(of.boxes) as Record<StudEnd, Box>)[of.stud], map: value.map};
  }
  /** Boxes, loads or linkage may be others. */
  follow_map(): void {
    const {driver_client} = this.workbench,
      {sought, mapped, maps} = this;
    if (!mapped) return maps.forget();
    if (!sought || !driver_client) return maps.hold();
    const of = {...sought, stud: mapped};
    if (maps.is_of(of)) return maps.drop();
    const {problem, tau, boxes} = sought,
      [columns, rows] = [map_cells, map_cells];
    void maps.ask(of, () =>
      driver_client.follow("stud_map", {problem: engine_text(problem), tau, boxes, stud: mapped, columns, rows}),
    );
  }
}
function same_spring(a: Spring, b: Spring): boolean {
  return JSON.stringify(a) === JSON.stringify(b);
}
