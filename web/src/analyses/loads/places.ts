// Where points of the loads are while the linkage moves, and which point of a body lies at a place.
import type {Point} from "../../contract/messages";
import type {Place} from "../../figure/figure";
import type {Configuration} from "../../figure/mechanism";
import {body_point, placed} from "../../state/problem";
import {is_between_studs, type CarriedPoint, type Loads} from "./block";

type Body = CarriedPoint["on"];
/** The frames of the bodies as they stand; null: nobody knows where that body is. */
export type Frames = Readonly<Record<Body, Place | null>>;

const ground: Place = {x: 0, y: 0, theta_deg: 0};
/** From one pivot towards the other. */
function along(from: Point | null | undefined, to: Point | null | undefined): Place | null {
  if (!from || !to) return null;
  return {x: from[0], y: from[1], theta_deg: (Math.atan2(to[1] - from[1], to[0] - from[0]) * 180) / Math.PI};
}
/** Without a linkage the body is at its first position. */
export function frames_of(now: Configuration | null, first: Place | undefined): Frames {
  const {input, output} = now?.ends ?? {};
  return {
    ground,
    body: now?.pose ?? first ?? null,
    input: along(input?.center, input?.circle),
    coupler: along(input?.circle, output?.circle),
    output: along(output?.center, output?.circle),
  };
}
export function place_of({on, at}: CarriedPoint, frames: Frames): Point | null {
  const frame = frames[on];
  return frame && placed(at, frame);
}
/** The point of that body there, in round numbers of a step. */
export function carried_at(on: Body, place: Point, frames: Frames, step: number): Point {
  const [x, y] = body_point(place, frames[on] ?? ground),
    round = (value: number) => Number((Math.round(value / step) * step).toPrecision(12)) + 0;
  return [round(x), round(y)];
}

export interface Mark {
  /** As handles are called. */
  part: string;
  stud: CarriedPoint;
  /** What it is of: a spring by its place in the list. */
  of: {kind: "center"} | {kind: "handle"} | {kind: "stud"; spring: number; end: "from" | "to"};
}
/** All points that are shown and can be taken hold of. */
export function marks_of(loads: Loads): Mark[] {
  const {body, handle, springs = []} = loads;
  const studs = springs.flatMap((spring, index) =>
    is_between_studs(spring)
      ? (["from", "to"] as const).map((end): Mark => ({
          part: `load_spring_${index + 1}_${end}`,
          stud: spring[end],
          of: {kind: "stud", spring: index, end},
        }))
      : [],
  );
  return [
    ...(body ? [{part: "load_center", stud: on_body(body.center ?? [0, 0]), of: {kind: "center"} as const}] : []),
    ...(handle ? [{part: "load_handle", stud: on_body(handle.point), of: {kind: "handle"} as const}] : []),
    ...studs,
  ];
}
function on_body(at: Point): CarriedPoint {
  return {on: "body", at};
}
/** On another body where it is in position 1, as far as the task alone tells; else where that body begins. */
export function put_on({on, at}: CarriedPoint, body: Body, first: Place | undefined): CarriedPoint {
  const frames = frames_of(null, first),
    place = place_of({on, at}, frames);
  return {on: body, at: place && frames[body] ? carried_at(body, place, frames, 1e-6) : on === body ? at : [0, 0]};
}
