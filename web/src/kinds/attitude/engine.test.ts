// The engine as it is built for the page: what it tells of the turns agrees with itself. Compiled for its size it once lost
// the first turn of them.
import {describe, expect, it} from "vitest";
import {ask} from "../../../tests/asked_engine";
import type {AttitudeReply} from "./reply";

const orientation = {euler_deg: [35, 50, 20], sequence: "zxz"};
function turned(turns: number): AttitudeReply {
  const text = JSON.stringify({
    orientation,
    from: {orientation, translation: [0, 0, 0]},
    sequence: "zxz",
    turning: "intrinsic",
    at: {turns},
  });
  return ask("report", {of: "attitude", text}).report as AttitudeReply;
}
const [s1, c1, s2, c2] = [35, 50].flatMap((deg) => [
  Math.sin((deg * Math.PI) / 180),
  Math.cos((deg * Math.PI) / 180),
]) as [number, number, number, number];
/** About z and then about the x carried along, written out. */
const after_two = [
  [c1, -s1 * c2, s1 * s2],
  [s1, c1 * c2, -c1 * s2],
  [0, s2, c2],
];

describe("three turns", () => {
  it("are as far as they are played what they are after each", () => {
    const {frames} = turned(3).turns;
    for (const [k, frame] of frames.entries()) expect(turned(k + 1).turns.now.frame).toEqual(frame);
    for (const [row, numbers] of after_two.entries())
      for (const [column, value] of numbers.entries()) expect(frames[1]![row]![column]).toBeCloseTo(value, 12);
  });
});
