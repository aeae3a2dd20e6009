// The engine as it is built for the page: its walks along a six-bar's configurations agree with the program's.
import {beforeAll, expect, it} from "vitest";
import {load_module} from "../../engine/node";
import {Engine} from "../../engine/serve";
import {whole, type Kind, type Replies, type Requests} from "../../contract/messages";
import {examples} from "../../gallery/gallery";
import {engine_text} from "../../state/problem";
import {six_bar_kind} from "./kind";

const problem = engine_text(examples.find(({name}) => name === "wheel_loader")!.problem);
let server: Engine;
beforeAll(async () => {
  server = new Engine(await load_module());
});
function ask<K extends Kind>(kind: K, content: Requests[K]): Replies[K] {
  const {message} = server.serve({id: 1, kind, ...content} as never);
  return (message as unknown as {reply: Replies[K]}).reply;
}

it("finds linkages in a task that is begun anew", () => {
  const problem = engine_text(six_bar_kind.beginnings[0]!.make());
  const {task, map} = ask("explore", {
    problem,
    samples: 100,
    window: whole,
    property: "min_transmission_angle_deg",
    order: "fresh",
  });
  expect(task.status).toBe("solved");
  expect(map!.census.meeting).toBeGreaterThan(0);
});
it("counts what the program counts, and drives what meets everything through all positions", () => {
  const {map} = ask("explore", {
    problem,
    samples: 80,
    window: whole,
    property: "min_transmission_angle_deg",
    order: "fresh",
  });
  expect(map!.census).toMatchObject({pairs: 400, order: 0, branch: 343, circuit: 0, defect_free: 57});
  const {linkages} = ask("best", {problem, most: 1}),
    {tau} = linkages[0]!;
  const {linkage} = ask("linkage", {problem, tau});
  expect(linkage).toMatchObject({
    fails: 0,
    six_bar: {topology: "watt_1"},
    input: {center: linkage.six_bar!.joints[3]!.at},
    output: {circle: linkage.six_bar!.joints[6]!.at},
  });
  expect(linkage.drive!.ticks.every(({reached}) => reached)).toBe(true);
  expect(linkage.drive!.states.length % linkage.drive!.width).toBe(0);
  expect(ask("verify", {problem, tau}).verified).toBe(true);
});
it("shows a part of the map as finely as the whole", () => {
  const asked = {problem, samples: 80, property: "tolerance_error", order: "fresh"} as const,
    whole_map = ask("explore", {...asked, window: whole}).map!,
    part = ask("explore", {...asked, window: {input: [0.25, 0.5], output: [0.5, 0.75]}}).map!;
  expect([part.rows, part.columns]).toEqual([whole_map.rows, whole_map.columns]);
  const cell = (map: typeof part) => map.input_tau[1]! - map.input_tau[0]!;
  expect(cell(part)).toBeCloseTo(cell(whole_map) / 4);
});
it("colours the map by the error of what is made with tolerances, and counts what a limit of it leaves", () => {
  const with_limit = (limit: number | undefined) => {
    const file = JSON.parse(problem) as Record<string, object>;
    return JSON.stringify({
      ...file,
      tolerances: {length: 0.5},
      requirements: {...file.requirements, max_tolerance_error: limit},
    });
  };
  const explored = (limit?: number) =>
    ask("explore", {
      problem: with_limit(limit),
      samples: 80,
      window: whole,
      property: "tolerance_error",
      order: "fresh",
    }).map!;
  const {value, fails, census} = explored(),
    errors = [...value.keys()].filter((cell) => fails[cell] === 0).map((cell) => value[cell]!);
  expect(Math.min(...errors)).toBeGreaterThan(0.5);
  const middle = errors.sort((a, b) => a - b)[Math.floor(errors.length / 2)]!,
    left = explored(middle).census.meeting;
  expect(left).toBeGreaterThan(0);
  expect(left).toBeLessThan(census.meeting);
});
it("says where positions and the chain's hinges may go", () => {
  for (const part of [3, 4, 5, 6]) {
    const {counts} = ask("halo", {problem, part, mode: "move", reach: 180, steps: 5, samples: 60}),
      possible = Array.from(counts).filter((count) => count > 0).length;
    expect(counts[2 * 5 + 2], `part ${part}`).toBeGreaterThan(0);
    expect(possible).toBeLessThan(25);
  }
  expect(ask("halo", {problem, part: 7, mode: "move", reach: 180, steps: 5, samples: 60}).counts).toHaveLength(0);
});
