import {describe, expect, it} from "vitest";
import type {TaskAnswer} from "../contract/messages";
import {point_at, samples_of_sides, spot_of_tau} from "./curve_samples";
import {beyond_edge, beyond_spot, overshoot, slid, stepped} from "./sliding";
import type {Viewport} from "./viewport";

const view: Viewport = {x: 0, y: 0, scale: 1, width: 400, height: 400};
const count = 400;

/** Centre points: the hyperbola x y = 100², τ rising from x = ∞ over the upper right branch to y = ∞ and back below. */
function hyperbola() {
  const tau = new Float64Array(count),
    center = new Float64Array(3 * count);
  for (let i = 0; i < count; ++i) {
    const t = ((i + 0.5) / count) * Math.PI;
    tau[i] = i / count;
    center.set([Math.sin(t) * Math.cos(t), 100 * Math.cos(t) ** 2, 100 * Math.sin(t) ** 2], 3 * i);
  }
  return samples_of_sides(
    {
      characteristic_length: 100,
      curves: {kind: "one_branch", tau, center, circle: center, branch: new Uint8Array(count)},
      axes: {input: {quantity: "curve_coordinate", order: 0, branches: [{name: "odd", from: 0, to: 1}], blocks: []}},
      output_curves: null,
    } as unknown as TaskAnswer,
    [0, 0],
  ).input!;
}
const samples = hyperbola();

describe("sliding", () => {
  it("stays on its stretch unless another is much nearer", () => {
    const from = spot_of_tau(samples, "center", 0.25)!; // at (100, 100), screen (300, 100)
    const next = slid(samples, "center", view, [310, 95], from);
    expect(next.tau).toBeGreaterThan(0.2);
    expect(next.tau).toBeLessThan(0.3);
    expect(slid(samples, "center", view, [100, 300], from).tau).toBeCloseTo(0.75, 1);
  });
  it("goes through infinity and comes back from the other side", () => {
    const from = spot_of_tau(samples, "center", 0.17)!; // right of (100, 100), x = 100 cot t
    const at = [430, 150] as const,
      beyond = beyond_edge(samples, "center", view, at, from)!;
    expect(beyond).not.toBeNull();
    expect(overshoot(view, at)).toBe(30);
    const taus = [0, 40, 80, 120, 160].map((over) => beyond_spot(samples, "center", beyond, over).tau);
    expect(taus[0]).toBeCloseTo(Math.atan2(1, 2) / Math.PI, 1);
    expect(taus[4]).toBeCloseTo(1 - Math.atan2(1, 2) / Math.PI, 1); // from the left
    const falling = taus.map((tau) => (tau > 0.5 ? tau - 1 : tau));
    expect([...falling].sort((a, b) => b - a)).toEqual(falling);
  });
  it("steps along the curve by pixels, both ways", () => {
    const from = spot_of_tau(samples, "center", 0.25)!,
      p = point_at(samples, "center", from)!;
    const there = stepped(samples, "center", view, from, 10),
      q = point_at(samples, "center", there)!;
    expect(Math.hypot(q[0] - p[0], q[1] - p[1])).toBeCloseTo(10, 0);
    expect(stepped(samples, "center", view, there, -10).tau).toBeCloseTo(0.25, 6);
  });
});
