// What the page asks of its engine, timed in node; bench/session_bench.cpp asks the same of the native engine. Writes the
// milliseconds of each question, a JSON object.
import {readFileSync} from "node:fs";
import {fileURLToPath} from "node:url";
import {runnerImport} from "vite";

const node = fileURLToPath(new URL("../src/engine/node.ts", import.meta.url));
const engine = await (await runnerImport(node)).module.load_module();
const example = (name) => readFileSync(new URL(`../../examples/${name}.json`, import.meta.url), "utf8");
const tailgate = example("tailgate");
const tau = [1.3125, 1.1125];

const wing = example("folding_wing");
const crane = example("straight_luffing_crane");
const moved = (step) => tailgate.replace('"x": -220, "y": 220', `"x": ${-220 - 0.01 * (step % 100)}, "y": 220`);
const turned = (step) => wing.replace("[-40, 16, 62]", `[-40, 16, ${62 - 0.01 * (step % 100)}]`);
const shifted = (step) => crane.replace('"point": [9, 16]', `"point": [9, ${16 - 0.01 * (step % 100)}]`);
function whole_map(session, samples) {
  session.explore(samples, 0, 1, 0, 1, "min_transmission_angle_deg", 0);
}
/** Milliseconds a call, the median of at least 15 and of at most half a second, after some to warm up. */
function timed(question) {
  for (let i = 0; i < 3; ++i) question(i);
  const times = [],
    end = performance.now() + 500;
  for (let i = 0; times.length < 15 || (performance.now() < end && times.length < 2000); ++i) {
    const start = performance.now();
    question(i);
    times.push(performance.now() - start);
  }
  return times.sort((a, b) => a - b)[times.length >> 1];
}

const session = new engine.Session(),
  found = {};
for (const samples of [100, 400, 1000]) {
  found[`drag/${samples}`] = timed((step) => {
    session.set_problem(moved(step));
    whole_map(session, samples);
  });
}
found["turn/400"] = timed((step) => {
  session.set_problem(turned(step));
  whole_map(session, 400);
});
for (const samples of [100, 200]) {
  found[`line/${samples}`] = timed((step) => {
    session.set_problem(shifted(step));
    whole_map(session, samples);
  });
}
session.set_problem(tailgate);
whole_map(session, 400);
found.hover = timed(() => session.linkage(...tau));
found.live = timed(() => session.live(...tau));
found.halo = timed(() => session.halo(2, false, 120, 13, 60));
found.best = timed(() => session.best(1));
found.improve = timed(() => session.improve(...tau));
session.delete();
for (const name of [
  "tailgate",
  "latch",
  "airtight_hatch",
  "transfer_arm",
  "nose_gear",
  "sine_generator",
  "flow_meter",
  "log_generator",
  "loader_bucket_chain",
  "folding_wing",
  "ankle_orthosis",
  "universal_joint_like",
  "straight_stage",
]) {
  const text = example(name);
  found[`open/${name}`] = timed(() => {
    const opened = new engine.Session();
    opened.set_problem(text);
    whole_map(opened, 400);
    opened.delete();
  });
}
process.stdout.write(`${JSON.stringify(found)}\n`);
