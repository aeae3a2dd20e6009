import {describe, expect, it} from "vitest";
import {identity, length, unit, type Vec3} from "../../sphere/vectors";
import {
  fitting_sizes,
  hub_reaches,
  link_solid,
  link_solids,
  pins,
  shells,
  stl,
  usual_sizes,
  type Triangles,
} from "./print";
import {link_names, type Stand} from "./space";

const stand: Stand = {
  input_fixed: [0, 0, 1],
  input_moving: unit([1, 0.2, 1]),
  output_moving: unit([0.2, 1, 0.8]),
  output_fixed: unit([-0.9, 0.4, 0.7]),
  turn: identity,
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

describe("links to be printed", () => {
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
      const solid = link_solid(angle, shell, reaches, usual_sizes);
      expect_closed(solid);
      expect(volume(solid)).toBeGreaterThan(0);
    }
  });
  it("weigh what bar and hubs do", () => {
    const {hub, bore, half_width} = usual_sizes,
      angle = Math.PI / 2,
      solid = link_solid(
        angle,
        {inner: 40, outer: 44},
        [
          [40, 44],
          [40, 44],
        ],
        usual_sizes,
      );
    const bar = half_width * (44 ** 2 - 40 ** 2) * (angle - (2 * hub) / 42),
      hubs = 2 * 4 * Math.PI * (hub ** 2 - bore ** 2);
    expect(volume(solid) / (bar + hubs)).toBeCloseTo(1, 1);
  });
  it("lie on shells that do not overlap, bosses aside", () => {
    const of = shells(order, usual_sizes);
    let below = 0;
    for (const link of order) {
      const solid = link_solid(
          1.2,
          of[link],
          [
            [of[link].inner, of[link].outer],
            [of[link].inner, of[link].outer],
          ],
          usual_sizes,
        ),
        sizes = radii(solid);
      expect(Math.min(...sizes)).toBeGreaterThanOrEqual(of[link].inner * Math.cos((1.5 * Math.PI) / 180) - 1e-9);
      expect(Math.min(...sizes)).toBeGreaterThan(below);
      below = Math.max(...sizes);
    }
  });
  it("meet on their common axis with nothing but the clearance between", () => {
    const sizes = fitting_sizes(stand),
      of = shells(order, sizes);
    expect(hub_reaches("input", order, sizes)[1][1]).toBeCloseTo(of.coupler.inner - sizes.clearance);
    expect(hub_reaches("ground", order, sizes)[1][1]).toBeCloseTo(of.output.inner - sizes.clearance);
    expect(hub_reaches("output", order, sizes)).toEqual([
      [of.output.inner, of.output.outer],
      [of.output.inner, of.output.outer],
    ]);
  });
  it("are closed where they stand", () => {
    const sizes = fitting_sizes(stand),
      solids = link_solids(stand, order, sizes);
    for (const link of link_names) expect_closed(solids[link]);
  });
  it("are larger where a link is short", () => {
    const short = {...stand, input_moving: unit([0.1, 0, 1])};
    expect(fitting_sizes(short).inner).toBeGreaterThan(fitting_sizes(stand).inner);
    for (const solid of Object.values(link_solids(short, order, fitting_sizes(short)))) {
      expect_closed(solid);
      expect(volume(solid)).toBeGreaterThan(0);
    }
  });
  it("have a pin to each axis beside them, as long as the hubs that it joins", () => {
    const of = shells(order, usual_sizes),
      found = pins(order, usual_sizes, 50, -20),
      each = found.length / 4;
    expect_closed(found);
    expect(Math.min(...found.map(([x]) => x))).toBeGreaterThan(50);
    const heights = [0, 1, 2, 3].map((k) => {
      const z = found.slice(k * each, (k + 1) * each).map((corner) => corner[2]);
      expect(Math.min(...z)).toBeCloseTo(-20);
      return Math.max(...z) + 20;
    });
    expect(heights[0]).toBeCloseTo(of.input.outer - of.ground.inner); // the input's fixed axis
    expect(heights[3]).toBeCloseTo(of.output.outer - of.ground.inner);
    expect(volume(found)).toBeGreaterThan(0);
    expect(usual_sizes.pin).toBeLessThan(usual_sizes.bore);
  });
  it("are written as binary STL", () => {
    const solid = link_solid(
        1,
        {inner: 40, outer: 44},
        [
          [40, 44],
          [40, 44],
        ],
        usual_sizes,
      ),
      data = new DataView(stl(solid, "A wing – folded"));
    expect(data.getUint32(80, true)).toBe(solid.length / 3);
    expect(data.byteLength).toBe(84 + 50 * (solid.length / 3));
    expect(data.getFloat32(84 + 12, true)).toBeCloseTo(solid[0]![0], 4);
  });
});
