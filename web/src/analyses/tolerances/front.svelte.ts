// Two objectives at once: the transmission angle, and the error that tolerances make of it. All cells of the map that meet
// the requirements, and those that no other beats in both.
import type {EngineClient} from "../../engine/client";
import type {MapAnswer, Property, Replies, TaskAnswer, TauPair, MapWindow} from "../../contract/messages";
import {Question} from "../../questions/question.svelte";
import type {Questions} from "../../questions/questions";
import {engine_text, type Problem} from "../../state/problem";
import type {Workbench} from "../../state/workbench.svelte";
import {tolerances_of} from "./block";

interface Studied {
  readonly questions: Questions;
  readonly engine: EngineClient | null;
  readonly problem: Problem;
  readonly task: TaskAnswer | null;
  readonly map: MapAnswer | null;
  readonly window: MapWindow;
  readonly gesture: boolean;
  readonly is_current: boolean;
  readonly answers: {readonly map_is_of_present: boolean};
}
/** A linkage with both values: degrees, and the unit of the error. */
export interface FrontPoint {
  tau: TauPair;
  angle_deg: number;
  error: number;
}
export interface Front {
  text: string;
  window: MapWindow;
  /** By falling angle, and with it falling error. */
  points: FrontPoint[];
  /** Pairs of angle and error of all cells that meet everything. */
  cells: Float32Array;
}
export const objectives = ["min_transmission_angle", "tolerance_error"] as const;
const properties = ["min_transmission_angle_deg", "tolerance_error"] as const satisfies readonly Property[];
const settle_ms = 450; // after the last map, so that it is the finest one

/** Of the page. */
export function front_study_of(workbench: Workbench): FrontStudy {
  return workbench.study("front", () => new FrontStudy(workbench));
}
export class FrontStudy {
  private readonly question: Question<MapAnswer, Front>;

  constructor(private readonly studied: Studied) {
    this.question = new Question(studied.questions);
  }

  get found(): Front | null {
    return this.question.value;
  }
  get is_current(): boolean {
    return this.found?.text === engine_text(this.studied.problem);
  }
  /** While it is looked at: the map may be another. */
  follow(): void {
    const {question} = this,
      {map, problem, gesture, is_current} = this.studied;
    if (!map || !tolerances_of(problem)) question.forget();
    else if (gesture || !is_current) question.hold();
    else if (!question.is_of(map))
      void question.ask(map, (signal) => this.study(map, signal), {rest_ms: settle_ms, at_leisure: true});
  }
  /** Nobody looks any more. */
  rest(): void {
    if (this.found) this.question.hold();
    else this.question.drop();
  }

  /** Nothing where the map has changed meanwhile: once more with the next. */
  private async study(map: MapAnswer, signal: AbortSignal): Promise<Front | null> {
    const {engine, problem, task, window, answers} = this.studied;
    if (!engine || !task || !answers.map_is_of_present) return null;
    const text = engine_text(problem),
      {samples} = map,
      {order} = task.axes.input;
    const values = async (property: Property) => {
      if (map.property === property) return map.value;
      const reply = await engine.run({kind: "explore", problem: text, samples, window, property, order}, {signal});
      return reply.map?.value;
    };
    const [angles, errors] = [await values(properties[0]), await values(properties[1])];
    const {front} = await engine.run({kind: "front", problem: text, objectives}, {signal});
    if (angles?.length !== map.fails.length || errors?.length !== map.fails.length || !is_of(map, front, angles))
      return null;
    return {text, window, points: points_of(map, front), cells: cells_of(map, angles, errors)};
  }
}

/** Whether the front was found on this map: an engine that has explored another one since tells of that. */
function is_of({columns, rows}: MapAnswer, front: Replies["front"]["front"], angles: Float32Array): boolean {
  return front.every(
    ([row, column, angle]) =>
      row < rows && column < columns && Math.abs(angles[row * columns + column]! - angle) < 1e-3 * (1 + angle),
  );
}
function points_of({input_tau, output_tau}: MapAnswer, front: Replies["front"]["front"]): FrontPoint[] {
  return front.map(([row, column, angle_deg, error]) => ({
    tau: [input_tau[row]!, output_tau[column]!],
    angle_deg,
    error,
  }));
}
function cells_of({fails}: MapAnswer, angles: Float32Array, errors: Float32Array): Float32Array {
  const cells: number[] = [];
  for (let cell = 0; cell < fails.length; ++cell)
    if (fails[cell] === 0 && errors[cell]! > 0) cells.push(angles[cell]!, errors[cell]!);
  return Float32Array.from(cells);
}

/** Where to go from a linkage on the map: as good or better an angle with the least error; and the best angle with half
 *  the error. Nothing where there is no such linkage. */
export function ways_on(
  {points}: Pick<Front, "points">,
  {angle_deg, error}: Pick<FrontPoint, "angle_deg" | "error">,
): {least: FrontPoint | null; half: FrontPoint | null} {
  const slack = 0.005; // degrees: what a cell is off its own middle
  const least = points.findLast((point) => point.angle_deg >= angle_deg - slack) ?? null,
    worth_it = 0.995;
  return {
    least: least && least.error < worth_it * error ? least : null,
    half: points.find((point) => point.error <= error / 2) ?? null,
  };
}
