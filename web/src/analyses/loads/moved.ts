// Loads where the fixed frame is seen from elsewhere: what belongs to the body and the links stays as it is.
import type {Point} from "../../contract/messages";
import {is_between_studs, type CarriedPoint, type Loads} from "./block";

type Move = (point: Point) => Point;

function tidy(value: number): number {
  return Number(value.toFixed(9)) + 0;
}
const tidy_point = ([x, y]: Point): Point => [tidy(x), tidy(y)];

export function moved_loads(loads: Loads, move: Move): Loads {
  const {gravity, extra, handle, springs, drive} = loads,
    turn = turn_of(move);
  const carried = <P extends CarriedPoint>(stud: P): P =>
    stud.on === "ground" ? {...stud, at: tidy_point(move(stud.at))} : stud;
  const between = <P extends {from: CarriedPoint; to: CarriedPoint}>(ends: P): P => ({
    ...ends,
    from: carried(ends.from),
    to: carried(ends.to),
  });
  return {
    ...loads,
    ...(gravity === null || turn.deg === 0
      ? {}
      : {gravity: {...gravity, direction_deg: tidy((gravity?.direction_deg ?? -90) + turn.deg)}}),
    ...(extra && {extra: extra.map((one) => (keeps_force(one) ? {...one, force: turn.vector(one.force)} : one))}),
    ...(typeof handle?.direction === "object" && {
      handle: {...handle, direction: {fixed_deg: tidy(handle.direction.fixed_deg + turn.deg)}},
    }),
    ...(springs && {springs: springs.map((one) => (is_between_studs(one) ? between(one) : one))}),
    ...(typeof drive === "object" && {drive: {cylinder: between(drive.cylinder)}}),
  };
}
type Extra = NonNullable<Loads["extra"]>[number];
function keeps_force(extra: Extra): extra is Extract<Extra, {force: Point}> {
  return "force" in extra && extra.frame !== "body";
}
function turn_of(move: Move): {deg: number; vector: Move} {
  const [x0, y0] = move([0, 0]);
  const vector: Move = (of) => {
    const [x, y] = move(of);
    return tidy_point([x - x0, y - y0]);
  };
  const [c, s] = vector([1, 0]);
  return {deg: tidy((Math.atan2(s, c) * 180) / Math.PI), vector};
}
