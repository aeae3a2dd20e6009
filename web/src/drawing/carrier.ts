// What carries the end of a side link along: its curve lies on that body, drawn as in position 1.
import type {End, Ends, Side} from "./handles";
import type {Linkage, Point} from "../engine/protocol";
import type {SixBar} from "../tasks/six_bar/replies";
import type {Pose} from "../state/task";

type Place = Pick<Pose, "x" | "y" | "theta_deg">;
/** A frame on a body, in position 1 and now. */
export interface Carrier {
  first: Place;
  now: Place;
}

/** Of the side links' ends, by joint: center and circle point of link 4, then of link 5. */
const first_joint = {input: 3, output: 5} as const,
  first_added = {input: 4, output: 5} as const;
export function joint_of(side: Side, end: End): number {
  return first_joint[side] + (end === "center" ? 0 : 1);
}

/** Nothing on the ground. Without poses the links are to turn by given angles: each carries its own end. */
export function carrier_of(
  linkage: Linkage,
  side: Side,
  end: End,
  now: {pose: Place; joints: readonly Point[]; ends: Ends},
  first: Place | undefined,
): Carrier | null {
  if (linkage.six_bar) return carrier_in_six_bar(linkage.six_bar, side, joint_of(side, end), now.joints);
  if (end === "center") return null;
  if (first) return {first, now: now.pose};
  const {center, circle} = linkage[side],
    moved = now.ends[side].circle;
  return center && circle && moved && {first: frame(center, circle), now: frame(center, moved)};
}
function carrier_in_six_bar(
  {bodies, joints}: SixBar,
  side: Side,
  joint: number,
  now: readonly Point[],
): Carrier | null {
  const body = bodies.findIndex((list, k) => k !== first_added[side] && list.includes(joint));
  if (body <= 0) return null;
  const [from, to] = bodies[body];
  return {first: frame(joints[from].at, joints[to].at), now: frame(now[from], now[to])};
}
function frame([x, y]: Point, to: Point): Place {
  return {x, y, theta_deg: (Math.atan2(to[1] - y, to[0] - x) * 180) / Math.PI};
}
