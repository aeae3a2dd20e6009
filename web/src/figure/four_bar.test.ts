import {describe, expect, it} from "vitest";
import type {Linkage, Point} from "../contract/messages";
import {body_point, placed} from "../state/problem";
import {four_bar} from "./four_bar";
import type {Carrier} from "./mechanism";

const linkage = {
  input: {center: [0, 0], circle: [100, 0]},
  output: {center: [300, 0], circle: [300, 80]},
} as unknown as Linkage;
const first = {x: 0, y: 0, theta_deg: 0};
const now = (circle: Point) => ({
  pose: {x: 50, y: 20, theta_deg: 90},
  turned_deg: 90,
  joints: [],
  ends: {
    input: {center: linkage.input.center, circle},
    output: {center: linkage.output.center, circle: linkage.output.circle},
  },
});
const home = (carrier: Carrier | null, point: Point) =>
  carrier && placed(body_point(point, carrier.now), carrier.first);

describe("what carries the end of a grounded link", () => {
  it("is the body, and nothing on the ground", () => {
    expect(four_bar.carrier(linkage, "input", "circle", now([50, 120]), first)).toEqual({
      first,
      now: now([50, 120]).pose,
    });
    expect(four_bar.carrier(linkage, "input", "center", now([50, 120]), first)).toBeNull();
    expect(four_bar.carrier(linkage, "input", "center", now([50, 120]), undefined)).toBeNull();
  });
  it("is the grounded link itself where the task has no poses", () => {
    const [x, y] = home(four_bar.carrier(linkage, "input", "circle", now([0, 100]), undefined), [0, 130])!;
    expect(x).toBeCloseTo(130, 9);
    expect(y).toBeCloseTo(0, 9);
  });
});
