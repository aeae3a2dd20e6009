import {describe, expect, it} from "vitest";
import {examples, first_example} from "../gallery/gallery";
import {with_requirements, type Problem} from "../state/problem";
import {poses_of, position_count, type Task} from "../state/task";
import type {MotionTask} from "../kinds/motion/task";
import type {SixBarTask} from "../kinds/six_bar/task";
import type {SphericalTask} from "../kinds/spherical/task";
import {incompleteness, kind_of, with_poses} from "../kinds/kind_dispatch";
import {beginning_of, beginnings, common_with, going_on, has_own} from "./new_task";

const begin = (id: string) => beginnings.find((beginning) => beginning.id === id)!;
const own = with_poses(first_example.problem, [
  {x: 0, y: 0, theta_deg: 0},
  {x: 60, y: 35, theta_deg: 22},
  {x: 160, y: 120, theta_deg: 58},
  {x: 190, y: 240, theta_deg: 95},
]);
const poses = poses_of(own.task);

describe("a task that goes on from the one in hand", () => {
  it("keeps positions, title, unit and what is required of any linkage", () => {
    const asked = with_requirements({...own, title: "Hatch"}, {min_transmission_angle_deg: 40, max_link_ratio: 5});
    const six_bar = going_on(asked, begin("six_bar"));
    expect(kind_of(six_bar.task).name).toBe("task.kind_six_bar");
    expect(poses_of(six_bar.task)).toEqual(poses);
    expect((six_bar.task as SixBarTask).chain).toBeUndefined(); // that of the beginning is for other positions
    expect(incompleteness(six_bar)?.state).toBe("no_chain");
    expect(six_bar).toMatchObject({title: "Hatch", length_unit: asked.length_unit, requirements: asked.requirements});
    const back = going_on(six_bar, begin("four_positions"));
    expect(back.task).toEqual(own.task);
  });
  it("takes the first positions where there are too many, and adds where there are too few", () => {
    expect(poses_of(going_on(own, begin("three_positions")).task)).toEqual(poses.slice(0, 3));
    const five = poses_of(going_on(own, begin("five_positions")).task);
    expect(five.slice(0, 4)).toEqual(poses);
    expect(position_count(five)).toBe(5);
    const moving: Problem = with_poses(own, [
      {...poses[0]!, derivatives: [{x: 1, y: 0, theta: 0}]},
      ...poses.slice(1, 3),
    ]);
    expect(poses_of(going_on(moving, begin("six_bar")).task)).toHaveLength(4);
    expect(poses_of(going_on(moving, begin("six_bar")).task)[0]).toEqual(poses[0]);
    expect(going_on(moving, begin("four_positions")).task).toEqual(moving.task); // it is such a task
  });
  it("keeps what is given beside three positions where it stays of that kind", () => {
    const three = examples.map(({problem}) => problem).find(({task}) => (task as MotionTask).given)!;
    expect(going_on(three, begin("three_positions")).task).toEqual(three.task);
  });
  it("keeps orientations", () => {
    const spherical = begin("four_orientations").make(),
      {orientations} = spherical.task as SphericalTask;
    const five = going_on(spherical, begin("five_orientations")).task as SphericalTask;
    expect(five.orientations.slice(0, 4)).toEqual(orientations);
    expect(five.orientations).toHaveLength(5);
    const attitude = going_on(spherical, begin("attitude"));
    expect(attitude.task).toMatchObject({from: {orientation: orientations[0]}, orientation: orientations[1]});
    expect(attitude.requirements).toBeUndefined();
    const again = going_on(attitude, begin("four_orientations"));
    expect((again.task as SphericalTask).orientations.slice(0, 2)).toEqual(orientations.slice(0, 2));
    expect(again.requirements).toEqual(spherical.requirements);
  });
  it("has nothing in common with what guides no body", () => {
    expect(common_with(own.task, begin("function"))).toBeNull();
    expect(common_with(begin("function").make().task, begin("six_bar"))).toBeNull();
    expect(common_with(own.task, begin("four_orientations"))).toBeNull();
    expect(going_on(own, begin("function"))).toEqual(begin("function").make());
  });
});

it("positions are the user's own unless an example or a beginning has them", () => {
  expect(has_own(own.task)).toBe(true);
  for (const {task} of [first_example.problem, begin("five_positions").make()]) expect(has_own(task)).toBe(false);
});
it("a task's beginning is of its kind, with as many positions", () => {
  const id = (task: Task) => beginning_of(task)?.id;
  for (const name of [
    "four_positions",
    "three_positions",
    "five_positions",
    "six_bar",
    "four_orientations",
    "function",
  ])
    expect(id(begin(name).make().task)).toBe(name);
});
