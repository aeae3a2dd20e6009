// The curves of an axis' dyads as polylines through projective samples: where they run through infinity, or where there
// are no dyads, they are broken, and a place between two samples has a curve coordinate.
import type {Branch, DyadPolygon, Point, Side, TaskAnswer} from "../contract/messages";
import {has_burmester_curve, is_discrete, moving_side} from "../engine/axis";
import type {Viewport} from "./viewport";

export type CurveName = "center" | "circle";
/** Samples from..to-1 belong to one branch, or to a stretch of it. */
export interface Run {
  from: number;
  to: number;
  branch: Branch;
  closed: boolean;
}
export interface CurveSamples {
  /** Whose axes carry these dyads: both grounded links', where they come from the same curve. */
  sides: Sides;
  tau: Float64Array;
  /** Homogeneous (w, x, y) about `origin`, lengths in `unit`: only so do neighbours with a negative product of their
   *  vectors lie on both sides of infinity. */
  center: Float64Array;
  circle: Float64Array;
  origin: Point;
  unit: number;
  runs: Run[];
  /** Single dyads: each run is one of them, all its samples alike. */
  discrete: boolean;
}
/** Which grounded links lie there. */
export type Sides = readonly [Side, ...Side[]];
/** A place on a curve: between sample `index` and the next of its run. */
export interface Spot {
  sides: Sides;
  curve: CurveName;
  index: number;
  share: number; // 0 … 1
  tau: number;
}

/** Of each side; the same object where they come from the same curve. Nothing where a side's dyads depend on the other's. */
export function samples_of_sides(task: TaskAnswer, origin: Point): Record<Side, CurveSamples | null> {
  const of = (curves: DyadPolygon, side: Side, sides: Sides) =>
    curves.tau.length > 0 && task.axes[moving_side(task.axes, side)].branches.length > 0
      ? curve_samples(task, curves, side, sides, origin)
      : null;
  if (!task.output_curves) {
    const both = of(task.curves, "input", ["input", "output"]);
    return {input: both, output: both};
  }
  return {input: of(task.curves, "input", ["input"]), output: of(task.output_curves, "output", ["output"])};
}
function curve_samples(task: TaskAnswer, curves: DyadPolygon, side: Side, sides: Sides, origin: Point): CurveSamples {
  const axis = task.axes[moving_side(task.axes, side)],
    discrete = is_discrete(axis);
  const unit = task.characteristic_length > 0 ? task.characteristic_length : 1;
  const moved = (samples: Float64Array) => {
    const out = new Float64Array(samples.length);
    for (let i = 0; i < samples.length; i += 3) {
      const [w, wx, wy] = homogeneous(samples, i / 3),
        x = (wx - origin[0] * w) / unit,
        y = (wy - origin[1] * w) / unit;
      const size = Math.hypot(w, x, y) || 1;
      out[i] = w / size;
      out[i + 1] = x / size;
      out[i + 2] = y / size;
    }
    return out;
  };
  const gap = has_burmester_curve(task) ? Infinity : least_gap;
  const runs = runs_of(curves, axis.branches, gap).filter((run) => discrete || run.to - run.from > 1);
  return {
    sides,
    tau: curves.tau,
    center: moved(curves.center),
    circle: moved(curves.circle),
    origin,
    unit,
    runs,
    discrete,
  };
}
type Homogeneous = readonly [w: number, x: number, y: number];
function homogeneous(samples: Float64Array, index: number): Homogeneous {
  const at = 3 * index;
  return [samples[at]!, samples[at + 1]!, samples[at + 2]!];
}
function dot(p: Homogeneous, q: Homogeneous): number {
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}
/** What is drawn and slid along: where the ground pivots are given, the centres are no curve. */
export function curves_of({center}: CurveSamples): readonly CurveName[] {
  return center.some((value, i) => Math.abs(value - center[i % 3]!) > 1e-9) ? ["center", "circle"] : ["circle"];
}
/** Other curves have gaps where there are no dyads: steps of τ, the branches of which are 1 long, wider than this. */
const least_gap = 0.012;
function runs_of({tau, branch}: DyadPolygon, branches: readonly Branch[], gap: number): Run[] {
  const runs: Run[] = [];
  for (let i = 0; i < branch.length; ++i) {
    const last = runs.at(-1),
      own = branches[branch[i]!];
    if (last?.to === i && branch[i] === branch[i - 1] && tau[i]! - tau[i - 1]! <= gap) last.to = i + 1;
    else if (own) runs.push({from: i, to: i + 1, branch: own, closed: false});
  }
  for (const run of runs) run.closed = tau[run.from]! + run.branch.to - run.branch.from - tau[run.to - 1]! <= gap;
  return runs;
}
/** The next sample; the last of an open stretch has none and stays. */
export function next_in(run: Run, index: number): number {
  return index + 1 < run.to ? index + 1 : run.closed ? run.from : index;
}
export function previous_in(run: Run, index: number): number {
  return index > run.from ? index - 1 : run.closed ? run.to - 1 : index;
}
export function run_of(samples: CurveSamples, index: number): Run | null {
  return samples.runs.find((run) => index >= run.from && index < run.to) ?? null;
}

const straight_px = 5; // longer strokes are bent to the neighbours
const finite = 1e-7; // |w| of a unit vector that is taken for a point of the drawing

/** Sample in pixels, or nothing at infinity. */
export function sample_at(samples: CurveSamples, curve: CurveName, index: number, view: Viewport): Point | null {
  const [w, x, y] = homogeneous(samples[curve], index);
  return Math.abs(w) < finite ? null : pixel(samples, x / w, y / w, view);
}
function pixel(samples: CurveSamples, x: number, y: number, view: Viewport): Point {
  return [
    view.width / 2 + (samples.origin[0] + x * samples.unit - view.x) * view.scale,
    view.height / 2 - (samples.origin[1] + y * samples.unit - view.y) * view.scale,
  ];
}
/** +1 where b follows a through finite points, −1 through infinity. */
function link_sign(data: Float64Array, a: number, b: number): number {
  const p = homogeneous(data, a),
    q = homogeneous(data, b);
  return (dot(p, q) < 0 ? -1 : 1) * (q[0] < 0 ? -1 : 1) * (p[0] < 0 ? -1 : 1);
}
export function through_infinity(samples: CurveSamples, curve: CurveName, a: number, b: number): boolean {
  return link_sign(samples[curve], a, b) < 0;
}

// ---- drawing --------------------------------------------------------------------------------------------------

/** The path of all segments that `wanted` lets through, clipped to the window and a good border around it. */
export function curve_path(
  samples: CurveSamples,
  curve: CurveName,
  view: Viewport,
  wanted: (a: number, b: number) => boolean = () => true,
): string {
  const pen = new Pen(view);
  for (const run of samples.runs) {
    for (let a = run.from; a < run.to; ++a) {
      const b = next_in(run, a);
      if (wanted(a, b)) add_segment(pen, samples, curve, run, a, view);
    }
  }
  return pen.path;
}
function add_segment(pen: Pen, samples: CurveSamples, curve: CurveName, run: Run, a: number, view: Viewport): void {
  const b = next_in(run, a),
    p = sample_at(samples, curve, a, view),
    q = sample_at(samples, curve, b, view);
  if (p && q && !through_infinity(samples, curve, a, b)) {
    if (Math.abs(p[0] - q[0]) + Math.abs(p[1] - q[1]) < straight_px || !pen.inside(p) || !pen.inside(q))
      return pen.line(p, q);
    const before = previous_in(run, a),
      after = next_in(run, b);
    const o = through_infinity(samples, curve, before, a) ? null : sample_at(samples, curve, before, view);
    const r = through_infinity(samples, curve, b, after) ? null : sample_at(samples, curve, after, view);
    return pen.bend(p, control(o, p, q), control(r, q, p), q);
  }
  const {direction, sense_a, sense_b} = infinity_between(samples[curve], a, b);
  if (p) pen.line(p, far(p, direction, sense_a));
  if (q) pen.line(far(q, direction, sense_b), q);
}
/** Bézier control point of a stroke from p to q, o before p: the tangent at p is that of the parabola through the three. */
function control(o: Point | null, p: Point, q: Point): Point {
  const next = Math.hypot(q[0] - p[0], q[1] - p[1]),
    last = o ? Math.hypot(p[0] - o[0], p[1] - o[1]) : 0;
  if (!o || last === 0 || next === 0) return [p[0] + (q[0] - p[0]) / 3, p[1] + (q[1] - p[1]) / 3];
  const slope = (k: 0 | 1) => ((q[k] - p[k]) * (last / next) + (p[k] - o[k]) * (next / last)) / (last + next);
  return [p[0] + (slope(0) * next) / 3, p[1] + (slope(1) * next) / 3];
}
/** Direction (y up) of the point at infinity between two samples, and whether each of them runs with or against it. */
function infinity_between(
  data: Float64Array,
  a: number,
  b: number,
): {direction: Point; sense_a: number; sense_b: number} {
  const p = homogeneous(data, a),
    q = homogeneous(data, b),
    sign = dot(p, q) < 0 ? -1 : 1;
  const wa = Math.abs(p[0]),
    wb = Math.abs(q[0]),
    share = wa + wb > 0 ? wa / (wa + wb) : 0.5;
  const mixed = (k: 1 | 2) => p[k] * (1 - share) + sign * q[k] * share;
  return {direction: [mixed(1), mixed(2)], sense_a: p[0], sense_b: sign * q[0]};
}
function far(from: Point, direction: Point, sense: number): Point {
  const length = Math.hypot(direction[0], direction[1]) || 1,
    reach = (sense < 0 ? -1 : 1) * 1e5;
  return [from[0] + (direction[0] / length) * reach, from[1] - (direction[1] / length) * reach];
}

class Pen {
  path = "";
  private end: Point | null = null;
  private readonly low: Point;
  private readonly high: Point;
  constructor(view: Viewport) {
    this.low = [-view.width, -view.height];
    this.high = [2 * view.width, 2 * view.height];
  }
  line(p: Point, q: Point): void {
    const clipped = this.inside(p) && this.inside(q) ? ([p, q] as const) : clip(p, q, this.low, this.high);
    if (!clipped) return;
    const [a, b] = clipped;
    this.go(a);
    this.path += `L${text(b)}`;
    this.end = b;
  }
  bend(p: Point, first: Point, second: Point, q: Point): void {
    this.go(p);
    this.path += `C${text(first)} ${text(second)} ${text(q)}`;
    this.end = q;
  }
  private go(to: Point): void {
    if (!this.end || Math.abs(this.end[0] - to[0]) + Math.abs(this.end[1] - to[1]) > 0.01) this.path += `M${text(to)}`;
  }
  inside(p: Point): boolean {
    return p[0] >= this.low[0] && p[0] <= this.high[0] && p[1] >= this.low[1] && p[1] <= this.high[1];
  }
}
function text(p: Point): string {
  return `${Math.round(p[0] * 10) / 10} ${Math.round(p[1] * 10) / 10}`;
}
/** Liang and Barsky. */
export function clip(p: Point, q: Point, low: Point, high: Point): [Point, Point] | null {
  let enter = 0,
    leave = 1;
  for (const k of [0, 1] as const) {
    const d = q[k] - p[k];
    for (const [side, limit] of [
      [-d, p[k] - low[k]],
      [d, high[k] - p[k]],
    ] as const) {
      if (side === 0) {
        if (limit < 0) return null;
      } else if (side < 0) enter = Math.max(enter, limit / side);
      else leave = Math.min(leave, limit / side);
    }
  }
  if (enter > leave) return null;
  const at = (s: number): Point => [p[0] + s * (q[0] - p[0]), p[1] + s * (q[1] - p[1])];
  return [at(enter), at(leave)];
}

// ---- places on the curve --------------------------------------------------------------------------------------

export function spot_at(samples: CurveSamples, curve: CurveName, run: Run, index: number, share: number): Spot {
  const length = run.branch.to - run.branch.from;
  const from = tau_of(samples, index);
  let tau = from + share * (next_tau(samples, run, index) - from);
  if (tau >= run.branch.to) tau -= length;
  return {sides: samples.sides, curve, index, share, tau};
}
function tau_of({tau}: CurveSamples, index: number): number {
  return tau[index]!;
}
/** τ of the next sample, running on past the end of a closed branch. */
function next_tau(samples: CurveSamples, run: Run, index: number): number {
  const next = next_in(run, index);
  return tau_of(samples, next) + (run.closed && next === run.from ? run.branch.to - run.branch.from : 0);
}
/** The place of a curve coordinate. */
export function spot_of_tau(samples: CurveSamples, curve: CurveName, tau: number): Spot | null {
  const on = samples.runs.filter((r) => tau >= r.branch.from - 1e-12 && tau <= r.branch.to + 1e-12);
  const run = on.findLast((r) => tau >= tau_of(samples, r.from)) ?? on[0];
  if (!run) return null;
  let low = run.from,
    high = run.to;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (tau_of(samples, middle) <= tau) low = middle;
    else high = middle;
  }
  const length = run.branch.to - run.branch.from;
  const spot = {sides: samples.sides, curve, tau};
  if (run.closed && tau < tau_of(samples, run.from))
    return {...spot, index: run.to - 1, share: wrap_share(samples, run, tau + length)};
  const from = tau_of(samples, low),
    to = next_tau(samples, run, low);
  return {...spot, index: low, share: to > from ? Math.max((tau - from) / (to - from), 0) : 0};
}
function wrap_share(samples: CurveSamples, run: Run, tau: number): number {
  const from = tau_of(samples, run.to - 1),
    to = tau_of(samples, run.from) + run.branch.to - run.branch.from;
  return to > from ? (tau - from) / (to - from) : 0;
}

/** The place nearest to a point of the screen among the segments that `wanted` lets through. */
export function nearest(
  samples: CurveSamples,
  curve: CurveName,
  view: Viewport,
  at: Point,
  wanted: (run: Run, a: number) => boolean = () => true,
): (Spot & {distance: number; x: number; y: number}) | null {
  let best: {run: Run; index: number; share: number; distance: number; x: number; y: number} | null = null;
  for (const run of samples.runs) {
    let p = sample_at(samples, curve, run.from, view);
    for (let a = run.from; a < run.to; ++a) {
      const b = next_in(run, a),
        q = sample_at(samples, curve, b, view),
        from = p;
      p = q;
      if (!from || !q || !wanted(run, a) || through_infinity(samples, curve, a, b)) continue;
      const found = nearest_on_segment(from, q, at);
      if (!best || found.distance < best.distance) best = {run, index: a, ...found};
    }
  }
  return (
    best && {
      ...spot_at(samples, curve, best.run, best.index, best.share),
      distance: best.distance,
      x: best.x,
      y: best.y,
    }
  );
}
export function nearest_on_segment(
  p: Point,
  q: Point,
  at: Point,
): {share: number; distance: number; x: number; y: number} {
  const dx = q[0] - p[0],
    dy = q[1] - p[1],
    square = dx * dx + dy * dy;
  const share = square > 0 ? Math.min(Math.max(((at[0] - p[0]) * dx + (at[1] - p[1]) * dy) / square, 0), 1) : 0;
  const x = p[0] + share * dx,
    y = p[1] + share * dy;
  return {share, distance: Math.hypot(at[0] - x, at[1] - y), x, y};
}

/** The point of a curve at a spot found on either curve, user units; nothing near infinity. */
export function point_at(samples: CurveSamples, curve: CurveName, spot: Spot): Point | null {
  const run = run_of(samples, spot.index);
  if (!run) return null;
  const {origin, unit} = samples,
    a = spot.index,
    b = next_in(run, a);
  const user = (i: number): Point | null => {
    const [w, x, y] = homogeneous(samples[curve], i);
    return Math.abs(w) < finite ? null : [origin[0] + (x / w) * unit, origin[1] + (y / w) * unit];
  };
  const p = user(a),
    q = user(b);
  if (!p || !q || through_infinity(samples, curve, a, b)) return null;
  return [p[0] + spot.share * (q[0] - p[0]), p[1] + spot.share * (q[1] - p[1])];
}
