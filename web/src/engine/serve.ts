// Answers requests from an engine session: the worker without the worker.
import {settled} from "./axis";
import {linkage_of, ranked_of, type LinkageReply, type RankedReply} from "./adapter";
import type {LinkwrightModule, MapArrays, Session} from "./module";
import {Refusal} from "./refusal";
import type {
  Census,
  DyadPolygon,
  Kind,
  Linkage,
  MachinePlan,
  MapAnswer,
  Mistake,
  Notice,
  PlacedSpring,
  PlateSizes,
  Replies,
  ReplyMessage,
  RequestMessage,
  Requests,
  TaskAnswer,
  TauPair,
  Tidings,
  ToleranceAnswer,
  ToleranceFigures,
} from "../contract/messages";
import type {FitSearchReply, StudMapReply} from "../contract/replies";

const nearest_order = -1;
const no_dyads: Mistake = {
  code: "no_dyads",
  place: "task.poses",
  values: {},
  message: "these positions have no grounded links to pair; move one of them",
};
const extensions = {svg: ".svg", dxf: ".dxf", csv: ".csv", json: ".json", result: ".json"};
const machine_extensions = {stl: ".stl", "3mf": ".3mf", plates: ".dxf", urdf: ".urdf", sdf: ".sdf", mjcf: ".xml"};
const chosen_sizes: PlateSizes = {width: 0, thickness: 0, gap: 0, pin: 0, clearance: -1, radius: 0};

/** Boxes at which a proof is given up, round by round; 0: a grid and its best places, moved until nothing near is better. */
const rounds_of_boxes = [0, 30_000, 120_000, 500_000, 2_000_000];
/** With more boxes there may be one. */
const may_yet_fit = "nothing_fits";

const now = () => performance.now();

function copied<A extends {slice(): A}>(view: A): A {
  return view.slice();
}

interface PlacedAnswer {
  placed: PlacedSpring;
  /** With the values of its sentence. */
  why_not?: Notice;
}

/** The engine in the thread that asks. `tell` takes what long jobs say on their way. */
export class Engine {
  private readonly session: Session;
  private problem: string | null = null;

  constructor(
    private readonly module: LinkwrightModule,
    private readonly tell: (message: ReplyMessage) => void = () => {},
  ) {
    this.session = new module.Session();
  }

  /** The answer to a request; throws a Refusal. */
  ask<K extends Kind>(kind: K, request: Requests[K]): Replies[K] {
    return this.answer(kind, request, () => {});
  }

  /** The answer to a message, and the buffers to be moved rather than copied. */
  serve(message: RequestMessage): {message: ReplyMessage; transfer: ArrayBuffer[]} {
    const {id, kind} = message;
    try {
      const reply = this.answer(kind, message as never, (tidings) => this.tell({id, kind, tidings} as ReplyMessage));
      return {message: {id, kind, reply} as ReplyMessage, transfer: buffers_of(reply)};
    } catch (error) {
      if (!(error instanceof Refusal)) throw error;
      return {message: {id, kind, refused: {mistakes: error.mistakes}}, transfer: []};
    }
  }

  private answer<K extends Kind>(kind: K, request: Requests[K], tell: (tidings: object) => void): Replies[K] {
    const answers: {[Q in Kind]: (request: Requests[Q]) => Replies[Q]} = {
      explore: (r) => this.explore(r),
      linkage: (r) => this.linkage(r),
      live: (r) => this.live(r),
      halo: (r) => this.halo(r),
      best: (r) => this.best(r.problem, r.most),
      search: (r) => this.search(r, tell),
      improve: (r) => JSON.parse(this.holding(r.problem).improve(...r.tau)),
      verify: (r) => JSON.parse(this.holding(r.problem).verify(...r.tau)),
      tolerance: (r) => this.tolerance(r),
      loads: (r) => JSON.parse(this.holding(r.problem).loads(...r.tau) || '{"loads": null}'),
      place_spring: (r) => this.place_spring(r, tell),
      stud_map: (r) => this.stud_map(r),
      search_fits: (r) => this.search_fits(r, tell),
      yields: (r) => JSON.parse(this.holding(r.problem).sample_yields(r.cells)),
      front: (r) => JSON.parse(this.holding(r.problem).front(...r.objectives)),
      trace: (r) => ({points: copied(this.holding(r.problem).trace(...r.tau, ...r.point))}),
      export: (r) => this.exported(r),
      machine: (r) => this.machine(r),
      machine_file: (r) => this.machine_file(r),
      report: (r) => this.report(r),
      read: (r) => this.read(r),
    };
    return answers[kind](request);
  }

  /** The session with this problem. */
  private holding(problem: string): Session {
    if (problem !== this.problem) {
      this.problem = null;
      if (!this.session.set_problem(problem)) throw new Refusal(JSON.parse(this.session.mistakes()));
      this.problem = problem;
    }
    return this.session;
  }

  private explore({problem, samples, window, property, order, ...hand}: Requests["explore"]): Replies["explore"] {
    const start = now();
    const code = order === "nearest" ? nearest_order : order === "fresh" ? 0 : order;
    const found = this.holding(problem).explore(samples, ...window.input, ...window.output, property, code);
    const task = JSON.parse(found.task) as TaskAnswer;
    Object.assign(task.curves, copied_curves(found.curves));
    task.output_curves = found.output_curves && copied_curves(found.output_curves);
    const map = found.map && copied_map(found.map, {samples, window, property}),
      engine_ms = now() - start;
    const tau = map && hand.picked ? settled(task.axes, hand.picked)?.tau : undefined,
      linkage = tau ? this.linkage_at(problem, tau) : null;
    return {task, map, engine_ms, linkage, live: tau && linkage && hand.live ? this.live({problem, tau}) : null};
  }

  private linkage({problem, tau}: Requests["linkage"]): Replies["linkage"] {
    const start = now(),
      linkage = this.linkage_at(problem, tau);
    if (!linkage) throw new Refusal([no_dyads]);
    return {linkage, engine_ms: now() - start};
  }
  private linkage_at(problem: string, tau: TauPair): Linkage | null {
    const found = this.holding(problem).linkage(...tau);
    if (!found.linkage) return null;
    const linkage = linkage_of(JSON.parse(found.linkage) as LinkageReply),
      drive = linkage.drive && {...linkage.drive, states: copied(found.states)};
    const tolerance = found.tolerance ? (JSON.parse(found.tolerance) as ToleranceFigures) : null;
    return {...linkage, drive, tolerance};
  }

  private best(problem: string, most: number): Replies["best"] {
    const {linkages, notices} = JSON.parse(this.holding(problem).best(most)) as {
      linkages: RankedReply[];
      notices: Notice[];
    };
    return {linkages: linkages.map(ranked_of), notices};
  }

  private tolerance({problem, tau, bins, drawn}: Requests["tolerance"]): Replies["tolerance"] {
    const found = this.holding(problem).tolerance(...tau, bins, drawn);
    if (!found.report) return {tolerance: null};
    return {...(JSON.parse(found.report) as Omit<ToleranceAnswer, "drawn">), drawn: copied(found.drawn)};
  }

  private live({problem, tau}: Requests["live"]): Replies["live"] {
    const start = now(),
      {input, output} = this.holding(problem).live(...tau);
    return {input: copied(input), output: copied(output), engine_ms: now() - start};
  }

  private halo({problem, part, mode, reach, steps, samples}: Requests["halo"]): Replies["halo"] {
    const start = now();
    const turn = mode === "turn";
    const session = this.holding(problem);
    const counts = copied(session.halo(part, turn, turn ? (reach * Math.PI) / 180 : reach, steps, samples));
    const offsets = Float64Array.from({length: steps}, (_, i) =>
      steps === 1 ? 0 : reach * ((2 * i) / (steps - 1) - 1),
    );
    return {offsets, counts, steps, reach, engine_ms: now() - start};
  }

  private search({rounds, most}: Requests["search"], tell: (tidings: Tidings["search"]) => void): Replies["search"] {
    let found: Replies["search"] = {linkages: [], notices: []};
    for (const [round, problem] of rounds.entries()) {
      found = this.best(problem, most);
      tell({rounds: round + 1, found});
    }
    return found;
  }

  private place_spring(
    {problem, tau, boxes}: Requests["place_spring"],
    tell: (tidings: Tidings["place_spring"]) => void,
  ): Replies["place_spring"] {
    const session = this.holding(problem);
    let placed: PlacedSpring | null = null;
    for (const most_boxes of rounds_of_boxes) {
      const answer = answer_of<PlacedAnswer>(session.place_spring(...tau, boxes, most_boxes));
      if (!answer) return {placed: null};
      placed = answer.why_not ? {...answer.placed, why_not: answer.why_not} : answer.placed;
      tell({found: placed});
      const {proven, why_not} = placed;
      if (proven || (why_not && (why_not.code !== may_yet_fit || why_not.values?.proven))) break;
    }
    return {placed};
  }

  private stud_map({problem, tau, boxes, stud, columns, rows}: Requests["stud_map"]): Replies["stud_map"] {
    const found = answer_of<StudMapReply>(this.holding(problem).stud_map(...tau, boxes, stud, columns, rows));
    return {map: found?.columns ? found : null};
  }

  private search_fits(
    {problem}: Requests["search_fits"],
    tell: (tidings: Tidings["search_fits"]) => void,
  ): Replies["search_fits"] {
    const found = JSON.parse(this.module.search_fits(problem, (done) => tell({done}))) as
      FitSearchReply | {mistakes: Mistake[]};
    if ("mistakes" in found) throw new Refusal(found.mistakes);
    return found;
  }

  private exported({problem, tau, format}: Requests["export"]): Replies["export"] {
    const text = this.holding(problem).exported(...tau, format);
    if (!text)
      throw new Refusal([
        {code: "no_four_bar", place: "", values: {}, message: "a slider or zero link cannot be written as a four-bar"},
      ]);
    return {text, extension: extensions[format]};
  }

  private machine({problem, tau, sizes}: Requests["machine"]): Replies["machine"] {
    const made = this.holding(problem).machine(...tau, {...chosen_sizes, ...sizes}),
      plan = JSON.parse(made.plan) as MachinePlan | {mistakes: Mistake[]};
    if ("mistakes" in plan) throw new Refusal(plan.mistakes);
    return {
      ...plan,
      vertices: copied(made.vertices),
      triangles: copied(made.triangles),
      travel: copied(made.travel),
    };
  }

  private machine_file({problem, tau, sizes, format}: Requests["machine_file"]): Replies["machine_file"] {
    const file = this.holding(problem).machine_file(...tau, format, {...chosen_sizes, ...sizes}),
      mistakes = JSON.parse(file.mistakes) as Mistake[];
    if (mistakes.length) throw new Refusal(mistakes);
    return {bytes: copied(file.bytes), extension: machine_extensions[format]};
  }

  private report({of, text}: Requests["report"]): Replies["report"] {
    const report = JSON.parse(this.module.report(of, text)) as {mistakes?: Mistake[]};
    if (report.mistakes) throw new Refusal(report.mistakes);
    return {report};
  }

  private read({text}: Requests["read"]): Replies["read"] {
    const problem = this.session.read(text);
    if (!problem) throw new Refusal(JSON.parse(this.session.mistakes()));
    return {problem, notices: JSON.parse(this.session.notices()) as Notice[]};
  }
}

/** Null: the text says nothing. */
function answer_of<Answer extends object>(text: string): Answer | null {
  const answer = text ? (JSON.parse(text) as Answer | {mistakes: Mistake[]}) : null;
  if (answer && "mistakes" in answer) throw new Refusal(answer.mistakes);
  return answer;
}

function copied_curves(from: DyadPolygon): DyadPolygon {
  return {tau: copied(from.tau), center: copied(from.center), circle: copied(from.circle), branch: copied(from.branch)};
}

function copied_map(from: MapArrays, asked: Pick<MapAnswer, "samples" | "window" | "property">): MapAnswer {
  return {
    ...asked,
    rows: from.input_tau.length,
    columns: from.output_tau.length,
    input_tau: copied(from.input_tau),
    output_tau: copied(from.output_tau),
    type: copied(from.type),
    defects: copied(from.defects),
    fails: copied(from.fails),
    value: copied(from.value),
    census: JSON.parse(from.census) as Census,
    ridge: {
      input: copied(from.ridge_input),
      input_partner: copied(from.ridge_input_partner),
      output: copied(from.ridge_output),
      output_partner: copied(from.ridge_output_partner),
    },
  };
}

/** The buffers of all typed arrays in a reply. */
function buffers_of(value: unknown): ArrayBuffer[] {
  if (ArrayBuffer.isView(value)) return [value.buffer as ArrayBuffer];
  if (Array.isArray(value)) return typeof value[0] === "object" ? value.flatMap(buffers_of) : [];
  if (value !== null && typeof value === "object") return Object.values(value).flatMap(buffers_of);
  return [];
}
