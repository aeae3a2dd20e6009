import {describe, expect, it} from "vitest";
import type {Pose} from "../state/task";
import {bend_of, travel_of, with_bend, with_next_derivative, with_travel, without_derivative} from "./travel";

const at = (x: number, y: number, theta_deg: number, derivatives?: Pose["derivatives"]): Pose => ({
  x,
  y,
  theta_deg,
  ...(derivatives && {derivatives}),
});

describe("travel", () => {
  it("does not depend on the parameter", () => {
    // On a circle of radius 10 about (0, 10), turning with the path: x = 10 sin u, y = 10 − 10 cos u, θ = u, at u = 0.5 t + t²
    const u = 0.3,
      du = 0.5,
      ddu = 2;
    const first = {x: 10 * Math.cos(u) * du, y: 10 * Math.sin(u) * du, theta: du};
    const second = {
      x: 10 * (Math.cos(u) * ddu - Math.sin(u) * du ** 2),
      y: 10 * (Math.sin(u) * ddu + Math.cos(u) * du ** 2),
      theta: ddu,
    };
    const pose = at(0, 0, 0, [first, second]);
    expect(travel_of(pose)!.direction_deg).toBeCloseTo((u * 180) / Math.PI, 10);
    expect(travel_of(pose)!.turn_deg).toBeCloseTo(18 / Math.PI, 10);
    expect(bend_of(pose)!.curvature).toBeCloseTo(0.1, 12);
    expect(bend_of(pose)!.turn_growth_deg).toBeCloseTo(0, 12);
  });
  it("keeps the rest when one number changes", () => {
    const pose = with_bend(with_travel(at(1, 2, 3), {direction_deg: 30, turn_deg: 2}), {
      curvature: 0.25,
      turn_growth_deg: -1,
    });
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
    for (const i of [0, 1, 2])
      expect(travel_of(with_next_derivative(line, i))).toEqual({direction_deg: 0, turn_deg: expect.closeTo(1, 10)});
    const arc = [-20, 0, 20].map((deg) =>
      at(100 * Math.sin((deg * Math.PI) / 180), 100 - 100 * Math.cos((deg * Math.PI) / 180), deg + 350),
    );
    const middle = with_next_derivative(arc, 1);
    expect(travel_of(middle)!.direction_deg).toBe(0);
    expect(travel_of(middle)!.turn_deg).toBeCloseTo(0.573, 1);
    expect(bend_of(with_next_derivative([arc[0]!, middle, arc[2]!], 1))!.curvature).toBeCloseTo(0.01, 3);
    expect(travel_of(with_next_derivative([at(5, 5, 5)], 0))).toEqual({direction_deg: 0, turn_deg: 0});
  });
  it("keeps derivatives above the one that changes", () => {
    const pose = {
      x: 1,
      y: 2,
      theta_deg: 3,
      derivatives: [
        {x: 2, y: 1, theta: 0.1},
        {x: -1, y: 3, theta: 0.2},
        {x: 4, y: -2, theta: 0.3},
        {x: 1, y: 5, theta: -0.4},
      ],
    };
    const same = with_bend(with_travel(pose, {}), {});
    const further = (p: Pose) => [3, 4].map((order) => bend_of(p, order)!);
    const close = (p: Pose) =>
      further(p).map((bend) => ({
        curvature: expect.closeTo(bend.curvature, 9),
        turn_growth_deg: expect.closeTo(bend.turn_growth_deg, 9),
      }));
    expect(same.derivatives).toHaveLength(4);
    for (const changed of [same, with_travel(pose, {direction_deg: 77}), with_bend(pose, {curvature: 3})])
      expect(further(changed)).toEqual(close(pose));
    expect(bend_of(with_bend(pose, {curvature: 7}, 3), 3)!.curvature).toBeCloseTo(7, 9);
    expect(bend_of(with_bend(pose, {curvature: 7}, 3), 2)!.curvature).toBeCloseTo(bend_of(pose)!.curvature, 9);
  });
  it("tells how the curvature grows along the path, by whatever parameter", () => {
    // The parabola y = x²/2 by x: curvature (1 + x²)^(−3/2), by path length d/ds = (1 + x²)^(−1/2) d/dx, at x = 1
    const [third, fourth] = [3, 4].map((order) =>
      bend_of(
        at(1, 0.5, 0, [
          {x: 1, y: 1, theta: 0},
          {x: 0, y: 1, theta: 0},
          {x: 0, y: 0, theta: 0},
          {x: 0, y: 0, theta: 0},
        ]),
        order,
      )!,
    );
    expect(third!.curvature).toBeCloseTo(-3 / 2 ** 3, 12);
    expect(fourth!.curvature).toBeCloseTo((-3 * (1 - 5)) / 2 ** 4.5, 12);
  });
  it("is taken away with those above it", () => {
    const pose = with_bend(with_bend(with_travel(at(0, 0, 0), {}), {}), {}, 3);
    expect(pose.derivatives).toHaveLength(3);
    expect(without_derivative(pose, 3).derivatives).toHaveLength(2);
    expect(without_derivative(pose, 2).derivatives).toHaveLength(1);
    expect(without_derivative(pose, 1)).toEqual(at(0, 0, 0));
  });
  it("gets a derivative more and keeps those it has", () => {
    const line = [at(0, 0, 0), at(10, 0, 10), at(20, 0, 20)];
    let pose = line[1];
    for (const count of [1, 2, 3, 4]) {
      pose = with_next_derivative([line[0]!, pose!, line[2]!], 1);
      expect(pose.derivatives).toHaveLength(count);
    }
    expect(travel_of(pose!)!.turn_deg).toBeCloseTo(1, 9);
    const turning = at(0, 0, 0, [{x: 0, y: 0, theta: 1}]);
    expect(with_next_derivative([turning, line[1]!], 0).derivatives).toEqual([
      {x: 0, y: 0, theta: 1},
      {x: 0, y: 0, theta: 0},
    ]);
  });
});
