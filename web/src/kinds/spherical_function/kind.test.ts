import {describe, expect, it} from "vitest";
import type {Linkage} from "../../contract/messages";
import {dot, length, minus, type Vec3} from "../../sphere/vectors";
import {with_options, type Problem} from "../../state/problem";
import type {NamedFunction} from "../function/task";
import {incompleteness, objectives_of, properties_of, read_task, told} from "../kind_dispatch";
import {angle_on_dial, dials_of, fixed_axes, on_dial} from "./dials";
import {spherical_function_kind} from "./kind";
import {in_plane, on_sphere, with_ground_angle} from "./surface";
import type {SphericalFunctionTask} from "./task";

const beginning = spherical_function_kind.beginnings[0]!.make(),
  task = beginning.task as SphericalFunctionTask;
const named: NamedFunction = {expression: "x^2", x: [0, 1], input_range_deg: [0, 60], output_range_deg: [0, 90]};

describe("a function on the sphere", () => {
  it("is read with the angle between its axes, and is no function of the plane", () => {
    expect(read_task(JSON.parse(JSON.stringify(task)))).toEqual(task);
    const {ground_angle_deg: _, ...without} = task;
    expect(read_task(without)).toBeNull();
    expect(read_task({...task, pairs: undefined})).toBeNull();
    expect(read_task({...task, mechanism: "four_bar"})).not.toHaveProperty("ground_angle_deg");
  });
  it("has what functions have and what spheres have", () => {
    const of: SphericalFunctionTask = {...task, pairs: undefined, function: named};
    expect(objectives_of({task: of})).toEqual(["structural_error", "min_transmission_angle", "link_angle"]);
    expect(properties_of({task: of})).toEqual(
      expect.arrayContaining(["max_structural_error_deg", "min_link_angle_deg"]),
    );
    expect(properties_of({task})).not.toContain("max_structural_error_deg");
    expect(
      incompleteness({...beginning, task: {...task, pairs: task.pairs!.slice(1)} as SphericalFunctionTask}),
    ).toEqual({state: "too_few", text: "state.too_few_pairs", n: 3});
    expect(told(task, {code: "spherical_order", message: "", values: {}})).toContain("pairs");
  });
});

describe("from the plane to the sphere and back", () => {
  const planar: Problem = {
    linkwright: 1,
    length_unit: "mm",
    task: {kind: "function", mechanism: "four_bar", pairs: task.pairs, free: {number: "output_scale"}} as never,
    requirements: {
      max_length: 500,
      min_transmission_angle_deg: 40,
      types: ["crank_rocker", "triple_rocker_input"],
      respect_direction: false,
    },
  };
  it("keeps what is prescribed, and of the requirements what both have", () => {
    const there = on_sphere(planar);
    expect(there.task).toEqual({...task, free: {number: "output_scale"}, ground_angle_deg: 60});
    expect(there.requirements).toEqual({
      min_transmission_angle_deg: 40,
      types: ["crank_rocker"],
      respect_direction: false,
    });
    expect(there).not.toHaveProperty("length_unit");
    const back = in_plane(there);
    expect(back.task).toMatchObject({mechanism: "four_bar", pairs: task.pairs, free: {number: "output_scale"}});
    expect(back.requirements).toMatchObject({min_transmission_angle_deg: 40, max_length: 500});
    expect(back.length_unit).toBe("mm");
  });
  it("drops an objective that is not there", () => {
    expect(on_sphere(with_options(planar, {objective: "size"})).options).toEqual({objective: undefined});
    expect(in_plane(with_options(beginning, {objective: "link_angle"})).options).toEqual({objective: undefined});
  });
  it("changes the angle between the axes alone", () => {
    expect(with_ground_angle(beginning, 35).task).toEqual({...task, ground_angle_deg: 35});
  });
});

describe("scales on the sphere", () => {
  const hand = {
    spherical: {input_moving: [1, 0, 0], output_moving: [0, 1, 0]},
    function: {
      pairs: [
        [10, 20, 0],
        [40, 50, 0],
      ],
    },
  } as unknown as Linkage;
  const pairs = [
    [10, 20],
    [40, 50],
  ] as const;
  const near = (a: Vec3, b: Vec3) => expect(length(minus(a, b))).toBeLessThan(1e-12);

  it("have their first mark where the link in hand points, the others right-handed about the axis", () => {
    const [input, output] = dials_of(60, pairs, hand) as [never, never];
    const rim = Math.sin((24 * Math.PI) / 180);
    near(on_dial(input, 10), [rim, 0, Math.sqrt(1 - rim * rim)]);
    const [x, y] = on_dial(input, 40);
    expect([x, y]).toEqual([expect.closeTo(rim * Math.cos(Math.PI / 6)), expect.closeTo(rim * Math.sin(Math.PI / 6))]);
    expect(dot(on_dial(output, 20), [0, 1, 0])).toBeGreaterThan(0);
  });
  it("tell the angle of a point on them", () => {
    for (const dial of dials_of(100, pairs, hand))
      for (const angle of [-170, -10, 0, 33, 120]) expect(angle_on_dial(dial, on_dial(dial, angle))).toBeCloseTo(angle);
  });
  it("begin at the arc between the axes, or at its continuation, where there is no linkage", () => {
    const [input, output] = dials_of(90, pairs, null);
    near(input!.zero, [1, 0, 0]);
    near(output!.zero, [0, 0, -1]);
    near(fixed_axes(90).output, [1, 0, 0]);
  });
});
