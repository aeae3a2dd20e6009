// As the file has it: orientations of a body about the centre of a linkage, each in the form in which it was typed.
import type {Orientation} from "../../orientation/orientation";
import type {Vec3} from "../../sphere/vectors";
import type {Task} from "../../state/task";

/** Fixed frame, radians per unit of a parameter that grows along the task; none is there without those before it. */
export const rate_keys = ["angular_velocity", "angular_acceleration", "angular_jerk"] as const;
export type RateKey = (typeof rate_keys)[number];
export type Rates = {[K in RateKey]?: Vec3};
/** Carries the reference attitude into this one. */
export type PrescribedOrientation = Orientation & Rates;
/** Beside three orientations: both axes, the input's first; moving ones as in position 1. */
export type GivenAxes = {fixed_axes: readonly [Vec3, Vec3]} | {moving_axes: readonly [Vec3, Vec3]};

export interface SphericalTask extends Task {
  kind: "motion";
  mechanism: "spherical_four_bar";
  orientations: readonly PrescribedOrientation[];
  given?: GivenAxes;
}

export function is_spherical(task: Task): task is SphericalTask {
  return task.mechanism === "spherical_four_bar" && task.kind === "motion";
}
export function rates_of(orientation: Rates): Vec3[] {
  return rate_keys.flatMap((key) => (orientation[key] ? [orientation[key]] : []));
}
/** The orientation alone. */
export function without_rates(prescribed: PrescribedOrientation): Orientation {
  const bare = {...prescribed};
  for (const key of rate_keys) delete bare[key];
  return bare;
}
/** Another orientation with the same rates. */
export function turned(prescribed: PrescribedOrientation, orientation: Orientation): PrescribedOrientation {
  const rates = Object.fromEntries(rate_keys.flatMap((key) => (prescribed[key] ? [[key, prescribed[key]]] : [])));
  return {...orientation, ...rates};
}
/** One derivative more, or without one and those above it. */
export function with_next_rate(prescribed: PrescribedOrientation): PrescribedOrientation {
  const next = rate_keys[rates_of(prescribed).length];
  return next ? {...prescribed, [next]: next === "angular_velocity" ? [0, 0, 1] : [0, 0, 0]} : prescribed;
}
export function without_rate(prescribed: PrescribedOrientation, order: number): PrescribedOrientation {
  const left = {...prescribed};
  for (const key of rate_keys.slice(order)) delete left[key];
  return left;
}
/** How many positions: derivatives count as further ones. */
export function position_count({orientations}: SphericalTask): number {
  return orientations.reduce((sum, one) => sum + 1 + rates_of(one).length, 0);
}
/** What is given belongs to three positions. */
export function with_orientations(task: SphericalTask, orientations: readonly PrescribedOrientation[]): SphericalTask {
  const changed = {...task, orientations};
  if (position_count(changed) !== 3) delete changed.given;
  return changed;
}
