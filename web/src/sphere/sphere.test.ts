// The view of a ball: what is seen where, rings under the pointer, drags as angles, labels apart.
import {describe, expect, it} from "vitest";
import {placed_labels} from "./labels";
import {knob, ring, ring_at, RingDrag} from "./rings";
import {
  any_normal,
  arc,
  circle,
  column,
  cross,
  dot,
  great_circle,
  identity,
  length,
  minus,
  unit,
  type Vec3,
} from "./vectors";
import {View} from "./view";

function view_of(width = 800, height = 600): View {
  const view = new View(1.4);
  view.resize({width, height});
  return view;
}
const degrees = (angle: number) => (angle * 180) / Math.PI;

describe("points of a ball", () => {
  it("run on circles about their axis", () => {
    const axis = unit([1, 2, 3]);
    for (const point of circle(axis, 0.7)) {
      expect(length(point)).toBeCloseTo(0.7, 12);
      expect(dot(point, axis)).toBeCloseTo(0, 12);
    }
    const quarter = arc([0, 0, 1], [1, 0, 0.5], Math.PI / 2);
    expect(minus(quarter.at(-1)!, [0, 1, 0.5]).every((x) => Math.abs(x) < 1e-12)).toBe(true);
  });
  it("are joined the shorter way", () => {
    const path = great_circle([1, 0, 0], unit([-1, 1, 0]));
    expect(length(minus(path.at(-1)!, unit([-1, 1, 0])))).toBeLessThan(1e-12);
    expect(path.every(([, y]) => y > -1e-12)).toBe(true);
  });
  it("have a normal", () => {
    for (const a of [
      [1, 0, 0],
      [0, -2, 0],
      [3, 3, 3],
    ] as Vec3[])
      expect(dot(any_normal(a), a)).toBeCloseTo(0, 12);
  });
});

describe("a view", () => {
  it("shows the middle in the middle, whatever its shape", () => {
    for (const [width, height] of [
      [800, 600],
      [390, 700],
    ] as const) {
      const view = view_of(width, height);
      expect(view.spot([0, 0, 0]).x).toBeCloseTo(width / 2, 6);
      for (const along of ["x", "y", "z"] as const) {
        view.look_along(along);
        expect(view.spot([0, 0, 0]).y).toBeCloseTo(height / 2, 6);
        for (const point of circle([0, 0, 1], 1.3)) {
          const {x, y} = view.spot(point);
          expect(x > 0 && x < width && y > 0 && y < height).toBe(true);
        }
      }
    }
  });
  it("looks flat along an axis: z up, or y where z points at the eye", () => {
    const view = view_of();
    view.look_along("z");
    expect(view.spot([0, 1, 0]).y).toBeLessThan(300);
    expect(view.spot([1, 0, 0]).x).toBeGreaterThan(400);
    expect(view.spot([0, 0, 1])).toEqual(view.spot([0, 0, -1]));
    view.look_along("x");
    expect(view.spot([0, 0, 1]).y).toBeLessThan(300);
    expect(view.spot([0, 1, 0]).x).toBeGreaterThan(400);
  });
  it("rolls what is seen after the pointer, and ends the flat view", () => {
    const view = view_of();
    view.look_along("x");
    const before = view.spot([1, 0, 0]);
    view.roll(40, 0);
    expect(view.flat).toBeNull();
    expect(view.spot([1, 0, 0]).x).toBeGreaterThan(before.x + 20);
    view.reset();
    expect(view.towards_eye[0]).toBeGreaterThan(0.5);
  });
  it("sees a spot along a ray through it", () => {
    const view = view_of(),
      at: Vec3 = [0.3, -0.5, 0.2],
      {from, along} = view.ray(view.spot(at));
    expect(length(cross(minus(at, from), along))).toBeLessThan(1e-6);
  });
  it("zooms within limits", () => {
    const view = view_of();
    for (let k = 0; k < 50; ++k) view.zoom_by(2);
    expect(view.zoom).toBe(6);
  });
});

describe("rings", () => {
  it("have their knobs apart, on the side of the eye", () => {
    const view = view_of(),
      knobs = [0, 1, 2].map((axis) => knob(identity, axis, view.towards_eye));
    for (const [k, at] of knobs.entries()) {
      expect(dot(at, column(identity, k))).toBeCloseTo(0, 12);
      expect(dot(at, view.towards_eye)).toBeGreaterThan(0);
      for (const other of knobs.slice(0, k)) expect(length(minus(at, other))).toBeGreaterThan(0.9);
    }
  });
  it("are found under the pointer, and nothing beside them", () => {
    const view = view_of();
    for (const axis of [0, 1, 2]) {
      const spot = view.spot(knob(identity, axis, view.towards_eye));
      expect(ring_at(view, identity, spot, 9)?.axis).toBe(axis);
    }
    expect(ring_at(view, identity, {x: 3, y: 3}, 9)).toBeNull();
  });
  it("follow the pointer around, more than a whole turn", () => {
    const view = view_of();
    view.look_along("z");
    const [grabbed, ...rest] = ring(identity, 2);
    const drag = new RingDrag(view, identity, 2, grabbed!, view.spot(grabbed!));
    const angles = [...rest, ...rest].map((point) => degrees(drag.angle_at(view.spot(point))));
    expect(angles[rest.length / 2 - 1]).toBeGreaterThan(150);
    expect(angles.at(-1)).toBeCloseTo(720, 6);
  });
  it("seen from their edge follow along it", () => {
    const view = view_of();
    view.look_along("x");
    const grabbed: Vec3 = [1, 0, 0],
      {x, y} = view.spot(grabbed),
      drag = new RingDrag(view, identity, 2, grabbed, {x, y});
    const radius = view.spot([0, 1, 0]).x - x;
    expect(drag.angle_at({x: x + radius, y})).toBeCloseTo(1, 3);
    expect(drag.angle_at({x: x - radius, y: y + 30})).toBeCloseTo(-1, 3);
  });
});

describe("labels", () => {
  it("stand apart, though their points are one", () => {
    const asked = ["x", "x₀", "a"].map((key) => ({key, x: 120, y: 80, width: 20}));
    const placed = placed_labels(asked, {width: 200, height: 200});
    for (const [k, a] of placed.entries())
      for (const b of placed.slice(0, k)) expect(Math.abs(a.x - b.x) >= 20 || Math.abs(a.y - b.y) >= 16).toBe(true);
    expect(placed[0]!.x).toBeGreaterThan(120);
    expect(placed[0]!.y).toBeLessThan(80);
  });
  it("stand within the view", () => {
    const [label] = placed_labels([{key: "z", x: 199, y: 1, width: 20}], {width: 200, height: 200});
    expect(label).toEqual({key: "z", x: 188, y: 10});
  });
});
