// Four-bars on the sphere: orientations, cones, bodies, pins and files. The sphere itself takes WebGL, which is not here.
import {beforeEach, expect, test} from "vitest";
import {
  all,
  choose,
  click,
  download,
  get,
  give_file,
  is_there,
  open_example,
  open_files,
  press,
  text,
  toasts,
  type_into,
  until,
  until_mapped,
  until_settled,
  until_there,
  workbench,
} from "../../../tests/page/support";
import type {SphericalTask} from "./task";

const task = () => workbench.problem.task as SphericalTask;

beforeEach(() => open_example("folding_wing"));

test("orientations are typed in any form, given rates and removed", async () => {
  await click("spherical.open.2");
  await type_into("spherical.2.euler_deg.2", "33");
  expect(task().orientations[1]).toMatchObject({euler_deg: [-5, 10, 33]});
  await choose("spherical.2.form", "quaternion");
  await until(() => Object.keys(task().orientations[1]!).join() === "quaternion");
  await click("spherical.menu.2");
  await click("spherical.add_rate");
  expect(task().orientations[1]).toMatchObject({angular_velocity: [0, 0, 1]});
  await click("spherical.2.remove_rate.1");
  await click("spherical.menu.2");
  await click("spherical.remove");
  expect(task().orientations).toHaveLength(3);
  expect(text("task.missing")).toContain("give both fixed");
  await click("spherical.given.fixed_axes");
  expect(task().given).toMatchObject({fixed_axes: [[0, 0, 1], expect.anything()]});
});

test("an orientation that is added stands a little away from the last, in its form", async () => {
  await click("spherical.add");
  await until(() => task().orientations.length === 5);
  expect(task().orientations[4]).toMatchObject({sequence: "xyz"});
  await until_mapped();
  await press("Control+z");
  expect(task().orientations).toHaveLength(4);
});

test("a cone for the axes is dropped, and another begun", async () => {
  expect(workbench.problem.requirements?.fixed_axes_within?.half_angle_deg).toBeGreaterThan(0);
  await click("fixed_axes_within.drop");
  expect(workbench.problem.requirements?.fixed_axes_within ?? null).toBeNull();
  await click("moving_axes_within.begin");
  expect(workbench.problem.requirements?.moving_axes_within?.half_angle_deg).toBeGreaterThan(0);
});

test("the best has no defects, is pinned, compared, kept in a file, and taken away", async () => {
  expect(workbench.census!.meeting).toBeGreaterThan(0);
  await click("num.best");
  await until_settled();
  expect(text("num.verdict")).toContain("✓");
  expect(is_there("num.verified")).toBe(true);
  await click("pin.add");
  await click("pin.compare");
  await until_there("pin.column");
  expect(all("pin.column")).toHaveLength(1);
  await press("Escape");
  const kept = () => JSON.stringify([task(), workbench.picked?.tau, workbench.pins.map(({tau}) => tau)]),
    before = kept();

  await click("export.title");
  await until(() => is_there("export.plates.report") && text("export.plates.report").includes("nothing collides"));
  expect(text("export.missing")).toContain("no plane");
  expect(text("export.csv")).toContain("quaternion");
  const taken = async (format: string) => (await download(() => click(`export.${format}`))).bytes;
  expect((await taken("svg")).toString()).toContain("<svg");
  expect((await taken("csv")).toString()).toContain("quaternion_w");
  const file = await taken("problem");
  await press("Escape");

  workbench.edit((problem) => ({...problem, title: "Another"}));
  await open_files("wing.json", file);
  await until_settled();
  expect(kept()).toBe(before);
  const {name, bytes} = await download(() => click("num.stl"));
  expect(name).toMatch(/^folding-wing.*\.stl$/);
  expect(bytes.length).toBe(84 + 50 * bytes.readUInt32LE(80));
  expect(bytes.readUInt32LE(80)).toBeGreaterThan(1000);
});

test("links that collide are told before they are saved", async () => {
  workbench.edit((problem) => ({...problem, requirements: {...problem.requirements, min_link_angle_deg: 0}}));
  workbench.pick([1.3632489968250148, 0.8795044523844786]); // short links, hub by hub
  await until_settled();
  await click("num.stl");
  await until(() => is_there("export.plates.report") && text("export.plates.report").includes("has collisions"));
  expect((await download(() => click("export.stl"))).name).toMatch(/\.stl$/);
});

test("five orientations leave a few axes, and a cell with a picture to each pair", async () => {
  workbench.edit((problem) => {
    const {orientations} = problem.task as SphericalTask,
      last = {euler_deg: [-60, 12, 75], sequence: "xyz"} as const;
    return {...problem, task: {...problem.task, orientations: [...orientations, last]} as SphericalTask};
  });
  await until_mapped();
  expect(text("task.pattern")).toBe("P-P-P-P-P");
  expect(workbench.census!.pairs).toBe(2);
  for (const cell of ["1_2", "2_1"]) expect(get(`region.board.${cell}`).querySelector("path")).not.toBeNull();
});

test("a body is chosen, or taken from an STL file", async () => {
  const body = () => workbench.problem.view?.body;
  await choose("spherical.body", "dish");
  expect(body()).toEqual({shape: "dish"});
  const facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 10 0 0\nvertex 0 20 5\nendloop\nendfacet\n";
  await give_file("spherical.body_file", "flap.stl", `solid flap\n${facet}endsolid flap\n`);
  await until(() => body()?.shape === "own");
  expect(body()).toMatchObject({shape: "own", name: "flap.stl"});
  await give_file("spherical.body_file", "empty.stl", "solid none\nendsolid none\n");
  await until(() => toasts().includes("empty.stl was not taken"));
});
