import {expect, it} from "vitest";
import {Questions} from "../questions/questions";
import {poses_of} from "./task";
import {nearest, WayOutSeeker} from "./way_out.svelte";
import {with_pose_moved} from "../kinds/kind_dispatch";
import {new_problem} from "../kinds/motion/kind";

it("the nearest square of a halo that has enough left", () => {
  const counts = new Uint32Array(25);
  counts[0] = 9; // (−2, −2)
  counts[14] = 3; // (2, 0)
  const halo = {counts, steps: 5, reach: 2};
  expect(nearest(halo, 1)).toEqual([2, 0]);
  expect(nearest(halo, 5)).toEqual([-2, -2]);
  expect(nearest(halo, 10)).toBeNull();
});

it("the smallest move that leaves something is found, counted on its own map, and offered with its halo", async () => {
  const problem = new_problem(),
    answers = {halo: null as object | null},
    asked: [number, number][] = [],
    counted: number[] = [];
  const halo_of = (part: number, reach: number) => {
    const counts = new Uint32Array(169);
    if (part === 3 && reach > 50) counts[6 * 13 + 8] = 50; // two squares to the right
    if (part === 1 && reach > 50) counts[0] = 50; // a corner: farther
    return {counts, steps: 13, reach};
  };
  const stuck = {
    questions: new Questions(),
    problem,
    answers,
    gesture: false,
    property: "min_transmission_angle_deg",
    driver_client: {
      run({kind, problem: text, part, reach}: {kind: string; problem: string; part: number; reach: number}) {
        if (kind === "halo") {
          asked.push([part, reach]);
          return Promise.resolve(halo_of(part, reach));
        }
        counted.push(JSON.parse(text).task.poses[3].x);
        return Promise.resolve({map: {census: {meeting: 1234}}});
      },
    },
  };
  const seeker = new WayOutSeeker(stuck as unknown as ConstructorParameters<typeof WayOutSeeker>[0], with_pose_moved);
  seeker.seek();
  seeker.seek(); // once for a problem
  await expect.poll(() => seeker.found).not.toBeNull();
  const reach = asked.at(-1)![1],
    step = reach / 6;
  expect(asked.map(([part]) => part)).toEqual([...Array(asked.length).keys()].map((i) => i % 4));
  expect(seeker.found).toEqual({pose: 3, by: [2 * step, 0], meeting: 1234});
  expect(counted).toEqual([poses_of(problem.task)[3]!.x + 2 * step]);
  expect(answers.halo).toMatchObject({part: 3, reach});
  seeker.forget();
  expect([seeker.found, answers.halo]).toEqual([null, null]);
});
