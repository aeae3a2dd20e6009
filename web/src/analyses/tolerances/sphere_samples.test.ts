import {describe, expect, it} from "vitest";
import type {ToleranceAnswer} from "../../contract/messages";
import {length, type Vec3} from "../../sphere/vectors";
import {samples_picture} from "./sphere_samples";

const off = 0.01;
const axes_of = (sign: number) => [
  [0, 0, 1],
  [1, sign * off, 0],
  [0, 1, 0],
  [0, 0, -1],
];
const answer = {drawn: Float64Array.from([...axes_of(1), ...axes_of(-1)].flat()), positions: 1} as ToleranceAnswer;
const input_ends = (magnification: number): readonly Vec3[] => {
  const item = samples_picture(answer, magnification)[0]!;
  return item.kind === "strokes" ? item.ends : [];
};

describe("samples on the ball", () => {
  it("are arcs from axis to axis, all on the ball", () => {
    const ends = input_ends(1);
    expect(ends[0]).toEqual([0, 0, 1]);
    expect(ends[9]![1]).toBeCloseTo(off, 4);
    for (const end of ends) expect(length(end)).toBeCloseTo(1, 12);
  });
  it("leave their middle by ten times as much where that is asked for", () => {
    expect(input_ends(10)[9]![1]).toBeCloseTo(10 * off, 2);
    expect(input_ends(10)[19]![1]).toBeCloseTo(-10 * off, 2);
  });
});
