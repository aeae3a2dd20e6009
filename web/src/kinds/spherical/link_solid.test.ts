import {describe, expect, it} from "vitest";
import {length, type Vec3} from "../../sphere/vectors";
import {hub_reaches, link_solid, shells, type Sizes, type Triangles} from "./link_solid";

const sizes: Sizes = {
  inner: 36,
  thickness: 4,
  half_width: 3,
  hub: 5,
  bore: 1.6,
  clearance: 0.4,
  corners: 24,
  step_deg: 3,
};
const order = ["ground", "input", "coupler", "output"] as const;

/** How often each edge is run along one way and the other; corners that coincide are one. */
function edges(triangles: Triangles): Map<string, number> {
  const name = (corner: Vec3) => corner.map((value) => Math.round(value * 1e6)).join(),
    found = new Map<string, number>();
  for (let k = 0; k < triangles.length; k += 3)
    for (let i = 0; i < 3; ++i) {
      const edge = `${name(triangles[k + i]!)} ${name(triangles[k + ((i + 1) % 3)]!)}`;
      found.set(edge, (found.get(edge) ?? 0) + 1);
    }
  return found;
}
function expect_closed(triangles: Triangles): void {
  const found = edges(triangles),
    open = [...found].filter(([edge, count]) => {
      const [from, to] = edge.split(" ");
      return from === to || count !== 1 || found.get(`${to} ${from}`) !== 1;
    });
  expect(open).toEqual([]);
}
function volume(triangles: Triangles): number {
  let sum = 0;
  for (let k = 0; k < triangles.length; k += 3) {
    const [a, b, c] = [triangles[k]!, triangles[k + 1]!, triangles[k + 2]!];
    sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return sum / 6;
}
const radii = (triangles: Triangles) => triangles.map(length);

describe("links on the stage", () => {
  it.each([20, 60, 90, 140, 175])("are closed and manifold, the outside out: %d°", (angle_deg) => {
    const shell = {inner: 40, outer: 44},
      angle = (angle_deg * Math.PI) / 180;
    for (const reaches of [
      [
        [40, 44],
        [40, 44],
      ],
      [
        [40, 52],
        [40, 44],
      ],
      [
        [40, 44],
        [40, 60],
      ],
    ] as const) {
      const solid = link_solid(angle, shell, reaches, sizes);
      expect_closed(solid);
      expect(volume(solid)).toBeGreaterThan(0);
    }
  });
  it("weigh what bar and hubs do", () => {
    const {hub, bore, half_width} = sizes,
      angle = Math.PI / 2,
      solid = link_solid(
        angle,
        {inner: 40, outer: 44},
        [
          [40, 44],
          [40, 44],
        ],
        sizes,
      );
    const bar = half_width * (44 ** 2 - 40 ** 2) * (angle - (2 * hub) / 42),
      hubs = 2 * 4 * Math.PI * (hub ** 2 - bore ** 2);
    expect(volume(solid) / (bar + hubs)).toBeCloseTo(1, 1);
  });
  it("lie on shells that do not overlap, bosses aside", () => {
    const of = shells(order, sizes);
    let below = 0;
    for (const link of order) {
      const solid = link_solid(
          1.2,
          of[link],
          [
            [of[link].inner, of[link].outer],
            [of[link].inner, of[link].outer],
          ],
          sizes,
        ),
        away = radii(solid);
      expect(Math.min(...away)).toBeGreaterThanOrEqual(of[link].inner * Math.cos((1.5 * Math.PI) / 180) - 1e-9);
      expect(Math.min(...away)).toBeGreaterThan(below);
      below = Math.max(...away);
    }
  });
  it("meet on their common axis with nothing but the clearance between", () => {
    const of = shells(order, sizes);
    expect(hub_reaches("input", order, sizes)[1][1]).toBeCloseTo(of.coupler.inner - sizes.clearance);
    expect(hub_reaches("ground", order, sizes)[1][1]).toBeCloseTo(of.output.inner - sizes.clearance);
    expect(hub_reaches("output", order, sizes)).toEqual([
      [of.output.inner, of.output.outer],
      [of.output.inner, of.output.outer],
    ]);
  });
});
