// The engine's code in two modules: the first is enough for a first minute with a four-bar, and fetches the rest by itself.
import {readFileSync} from "node:fs";
import {expect, it} from "vitest";
import {stored_start} from "./stored";
import {code_urls, type CodePart} from "./code";
import {create_linkwright} from "./module";
import {load_engine} from "./node";
import {whole, type Kind, type Requests} from "../contract/messages";
import {Engine} from "./serve";
import {first_example} from "../gallery/gallery";
import {problem_text} from "../state/problem";
import {with_pose_moved} from "../kinds/kind_dispatch";

const property = "min_transmission_angle_deg",
  problem = problem_text(first_example.problem),
  {tau} = stored_start().linkage;
const compiled = (part: CodePart) => new WebAssembly.Module(readFileSync(code_urls[part]));

/** What is asked for its rest, counted; while `is_there` is false it cannot be had. */
async function begun(rest = {is_there: true, asked: 0}) {
  const fetched = () => {
    ++rest.asked;
    if (!rest.is_there) throw new Error("no rest");
    return compiled("rest");
  };
  return {rest, engine: new Engine(await create_linkwright({first: compiled("first"), rest: fetched}))};
}
const first_minute: {[K in Kind]?: Requests[K]} = {
  read: {text: problem},
  explore: {problem, samples: 100, window: whole, property, order: "nearest"},
  best: {problem, most: 10},
  linkage: {problem, tau},
  live: {problem, tau},
  verify: {problem, tau},
  trace: {problem, tau, point: [1, 2]},
  improve: {problem, tau},
  halo: {problem, part: 1, mode: "move", reach: 10, steps: 5, samples: 40},
};
const timeless = (reply: object) => JSON.stringify(reply, (key, value) => (key === "engine_ms" ? 0 : value));

it("needs its first module alone for a first minute", async () => {
  const {rest, engine} = await begun();
  for (const [kind, request] of Object.entries(first_minute)) engine.ask(kind as Kind, request as never);
  for (let step = 1; step <= 20; ++step) {
    const dragged = problem_text(with_pose_moved(first_example.problem, step % 4, [7 * step - 60, 40 - 5 * step]));
    engine.ask("explore", {problem: dragged, samples: 50, window: whole, property, order: "nearest"});
    for (let k = 0; k < 5; ++k) engine.ask("linkage", {problem: dragged, tau: [0.37 * k, 0.1 + 0.23 * k * step]});
  }
  expect(rest.asked).toBe(0);
});
it("asks for the rest once, where it calls into it, and says then what it says as a whole", async () => {
  const {rest, engine} = await begun(),
    whole_engine = await load_engine();
  for (const format of ["svg", "dxf", "csv"] as const) {
    const asked = ["export", {problem, tau, format}] as const;
    expect(engine.ask(...asked)).toEqual(whole_engine.ask(...asked));
  }
  expect(rest.asked).toBe(1);
  for (const [kind, request] of Object.entries(first_minute)) {
    const [one, other] = [engine, whole_engine].map((it) => timeless(it.ask(kind as Kind, request as never)));
    expect(one).toBe(other);
  }
  expect(rest.asked).toBe(1);
});
it("says why where the rest cannot be had, and asks again", async () => {
  const {rest, engine} = await begun({is_there: false, asked: 0});
  const asked = ["export", {problem, tau, format: "svg"}] as const;
  expect(() => engine.ask(...asked)).toThrow("no rest");
  const {rest: again, engine: other} = await begun({is_there: true, asked: 0});
  expect(other.ask(...asked).text).toContain("<svg");
  expect([rest.asked, again.asked]).toEqual([1, 1]);
});
