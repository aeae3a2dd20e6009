// Two objectives at once: the transmission angle, and the error that tolerances make of it. All cells of the map that meet
// the requirements, and those that no other beats in both.
import type {EngineClient} from "../engine/client";
import type {MapAnswer, Property, Replies, TaskAnswer, TauPair, Window} from "../engine/protocol";
import {engine_text, type Problem} from "./problem";
import {tolerances_of} from "./tolerances";

interface Studied {
  readonly engine: EngineClient | null;
  readonly problem: Problem;
  readonly task: TaskAnswer | null;
  readonly map: MapAnswer | null;
  readonly window: Window;
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
  window: Window;
  /** By falling angle, and with it falling error. */
  points: FrontPoint[];
  /** Pairs of angle and error of all cells that meet everything. */
  cells: Float32Array;
}
export const objectives = ["min_transmission_angle", "tolerance_error"] as const;
const properties = ["min_transmission_angle_deg", "tolerance_error"] as const satisfies readonly Property[];
const settle_ms = 450; // after the last map, so that it is the finest one

export class FrontStudy {
  found = $state.raw<Front | null>(null);
  private asked: {map: MapAnswer; stop: AbortController} | null = null;
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly studied: Studied) {}

  get is_current(): boolean {
    return this.found?.text === engine_text(this.studied.problem);
  }
  /** While it is looked at: the map may be another. */
  follow(): void {
    clearTimeout(this.timer);
    const {map, problem, gesture, is_current} = this.studied;
    if (!map || !tolerances_of(problem)) {
      this.drop();
      this.found = null;
    } else if (map !== this.asked?.map && !gesture && is_current)
      this.timer = setTimeout(() => void this.fetch(map), settle_ms);
  }
  /** Nobody looks any more. */
  rest(): void {
    clearTimeout(this.timer);
    if (!this.found) this.drop();
  }
  private drop(): void {
    this.asked?.stop.abort();
    this.asked = null;
  }

  private async fetch(map: MapAnswer): Promise<void> {
    const {engine, problem, task, window, answers} = this.studied;
    if (!engine || !task || !answers.map_is_of_present) return;
    this.drop();
    const asked = (this.asked = {map, stop: new AbortController()}),
      text = engine_text(problem),
      {signal} = asked.stop;
    const values = async (property: Property) => {
      if (map.property === property) return map.value;
      const {samples} = map,
        order = task.axes.input.order;
      const reply = await engine.run({kind: "explore", problem: text, samples, window, property, order}, {signal});
      return reply.map?.value ?? null;
    };
    try {
      const [angles, errors] = [await values(properties[0]), await values(properties[1])];
      const {front} = await engine.run({kind: "front", problem: text, objectives}, {signal});
      if (this.asked !== asked) return;
      const is_of_map = angles?.length === map.fails.length && errors?.length === map.fails.length;
      if (is_of_map && is_of(map, front, angles))
        this.found = {text, window, points: points_of(map, front), cells: cells_of(map, angles, errors)};
      else this.asked = null; // the map has changed meanwhile, and what was asked for with it
    } catch {
      if (this.asked === asked) this.asked = null; // once more with the next map
    }
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
