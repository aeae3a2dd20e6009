// Angles of the crank or of the coupler at the points of a path, hung on them and taken off.
import {multiple} from "../../drawing/snapping";
import {angle_of, type AngleKey, type PathPoint, type PathRate} from "./task";

const usual_turn_deg: Record<AngleKey, number> = {input_deg: 60, theta_deg: -20};
const usual_step_deg: Record<AngleKey, number> = {input_deg: 30, theta_deg: 0};
export function angle_ahead(points: readonly PathPoint[], key: AngleKey): number {
  const angles = points.flatMap((point) => point[key] ?? []),
    last = angles.at(-1) ?? -usual_step_deg[key],
    before = angles.at(-2) ?? last - usual_step_deg[key];
  return Number((2 * last - before).toPrecision(12));
}
/** Of the coupler the derivatives have its rate, too. */
export function with_angle_on(point: PathPoint, key: AngleKey, angle_deg: number): PathPoint {
  const bare = without_angle(point);
  if (key === "input_deg" || !bare.derivatives) return {...bare, [key]: angle_deg};
  return {...bare, [key]: angle_deg, derivatives: bare.derivatives.map((rate) => ({...rate, theta: 0}))};
}
/** Its rates go with it. */
export function without_angle(point: PathPoint): PathPoint {
  const {input_deg: _, theta_deg: __, derivatives, ...place} = point;
  return {...place, ...(derivatives ? {derivatives: derivatives.map(({x, y}): PathRate => ({x, y}))} : {})};
}
/** Between those before and after it, or as they go on. */
export function angle_between(points: readonly PathPoint[], index: number, key: AngleKey): number {
  const others = points.flatMap((point, i) => (i !== index && point[key] !== undefined ? [{i, deg: point[key]}] : [])),
    after = others.find(({i}) => i > index),
    before = others.findLast(({i}) => i < index);
  if (before && after)
    return multiple(before.deg + ((after.deg - before.deg) * (index - before.i)) / (after.i - before.i), 0.1);
  if (!before && !after) return 0;
  return before ? angle_ahead(points.slice(0, index), key) : angle_ahead(points.slice(index + 1).reverse(), key);
}
/** Angles at three of the points, the first and the last among them: those that are there, else some that differ. */
export function some_angled(points: readonly PathPoint[], key: AngleKey): PathPoint[] {
  const chosen = [0, Math.round((points.length - 1) / 2), points.length - 1];
  return points.map((point, i) =>
    chosen.includes(i)
      ? with_angle_on(point, key, angle_of(point) ?? chosen.indexOf(i) * usual_turn_deg[key])
      : without_angle(point),
  );
}

/** Another place in the order in which they are passed; angles of the crank stay where they were, in theirs. */
export function reordered(points: readonly PathPoint[], from: number, to: number): PathPoint[] {
  const all_timed = points.every(({input_deg}) => input_deg !== undefined),
    list = [...points],
    [moved] = list.splice(from, 1);
  if (moved) list.splice(to, 0, moved);
  return all_timed ? list.map((one, i) => ({...one, input_deg: points[i]!.input_deg!})) : list;
}
/** The angles of the crank in equal steps between the first and the last. */
export function evenly_timed(points: readonly PathPoint[]): PathPoint[] {
  const first = points[0]?.input_deg ?? 0,
    span = (points.at(-1)?.input_deg ?? 0) - first;
  return points.map((one, i) => ({
    ...one,
    input_deg: multiple(first + (span * i) / Math.max(points.length - 1, 1), 1e-6),
  }));
}
