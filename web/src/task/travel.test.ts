import {describe, expect, it} from "vitest";
import type {Pose} from "../state/task";
import {bend_of, travel_of, with_bend, with_next_derivative, with_travel, without_last_derivative} from "./travel";

const at = (x: number, y: number, theta_deg: number, derivatives?: Pose["derivatives"]): Pose => ({x, y, theta_deg, ...(derivatives && {derivatives})});

describe("travel", () => {
  it("does not depend on the parameter", () => {
    // On a circle of radius 10 about (0, 10), turning with the path: x = 10 sin u, y = 10 − 10 cos u, θ = u, at u = 0.5 t + t²
    const u = 0.3, du = 0.5, ddu = 2;
    const first = {x: 10 * Math.cos(u) * du, y: 10 * Math.sin(u) * du, theta: du};
    const second = {
      x: 10 * (Math.cos(u) * ddu - Math.sin(u) * du ** 2), y: 10 * (Math.sin(u) * ddu + Math.cos(u) * du ** 2), theta: ddu,
    };
    const pose = at(0, 0, 0, [first, second]);
    expect(travel_of(pose)!.direction_deg).toBeCloseTo((u * 180) / Math.PI, 10);
    expect(travel_of(pose)!.turn_deg).toBeCloseTo(18 / Math.PI, 10);
    expect(bend_of(pose)!.curvature).toBeCloseTo(0.1, 12);
    expect(bend_of(pose)!.turn_growth_deg).toBeCloseTo(0, 12);
  });
  it("keeps the rest when one number changes", () => {
    const pose = with_bend(with_travel(at(1, 2, 3), {direction_deg: 30, turn_deg: 2}), {curvature: 0.25, turn_growth_deg: -1});
    const turned = with_travel(pose, {direction_deg: 120});
    expect(travel_of(turned)).toEqual({direction_deg: expect.closeTo(120, 10), turn_deg: expect.closeTo(2, 10)});
    expect(bend_of(turned)).toEqual({curvature: expect.closeTo(0.25, 10), turn_growth_deg: expect.closeTo(-1, 10)});
    expect(turned).toMatchObject({x: 1, y: 2, theta_deg: 3});
  });
  it("has no direction where the origin stands still", () => {
    expect(travel_of(at(0, 0, 0, [{x: 0, y: 0, theta: 1}]))).toBeNull();
    expect(travel_of(at(0, 0, 0))).toBeNull();
    expect(bend_of(at(0, 0, 0, [{x: 1, y: 0, theta: 1}]))).toBeNull();
  });
  it("is proposed from the neighbours", () => {
    const line = [at(0, 0, 0), at(10, 0, 10), at(20, 0, 20)];
    for (const i of [0, 1, 2]) expect(travel_of(with_next_derivative(line, i))).toEqual({direction_deg: 0, turn_deg: expect.closeTo(1, 10)});
    const arc = [-20, 0, 20].map((deg) => at(100 * Math.sin(deg * Math.PI / 180), 100 - 100 * Math.cos(deg * Math.PI / 180), deg + 350));
    const middle = with_next_derivative(arc, 1);
    expect(travel_of(middle)!.direction_deg).toBe(0);
    expect(travel_of(middle)!.turn_deg).toBeCloseTo(0.573, 1);
    expect(bend_of(with_next_derivative([arc[0], middle, arc[2]], 1))!.curvature).toBeCloseTo(0.01, 3);
    expect(travel_of(with_next_derivative([at(5, 5, 5)], 0))).toEqual({direction_deg: 0, turn_deg: 0});
  });
  it("is taken away one by one", () => {
    const pose = with_bend(with_travel(at(0, 0, 0), {}), {});
    expect(without_last_derivative(pose).derivatives).toHaveLength(1);
    expect(without_last_derivative(without_last_derivative(pose))).toEqual(at(0, 0, 0));
  });
});
