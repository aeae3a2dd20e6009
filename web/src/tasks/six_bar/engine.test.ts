// The engine as it is built for the page: its walks along a six-bar's configurations agree with the program's.
import {readFileSync} from "node:fs";
import {beforeAll, expect, it} from "vitest";
import {create_linkwright} from "../../engine/module";
import {Engine} from "../../engine/serve";
import {whole, type Kind, type Replies, type Requests} from "../../engine/protocol";
import {examples} from "../../gallery/gallery";
import {engine_text} from "../../state/problem";
import {six_bar_kind} from "./kind";

const wasm = readFileSync(new URL("../../engine/generated/linkwright.wasm", import.meta.url));
const problem = engine_text(examples.find(({name}) => name === "wheel_loader")!.problem);
let server: Engine;
beforeAll(async () => {
  server = new Engine(await create_linkwright({wasmBinary: wasm}));
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
    samples: 100,
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
