// Drives a MuJoCo model by its motor through its keyframes, in their order, and says on standard output as JSON where its
// bodies got to. usage: node drive.mjs MODEL.xml [SWEEP]   SWEEP: after that turn the motor by so many radians, and back
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import loadMujoco from "@mujoco/mujoco";

const speed = 1; // radians of the driver a second
const settling = 0.4; // seconds
const observed = 0.05; // radians of a sweep between two looks

const wasm = createRequire(import.meta.url).resolve("@mujoco/mujoco/mujoco.wasm");
const complaints = [];
const mujoco = await loadMujoco({ wasmBinary: readFileSync(wasm), print: (line) => complaints.push(line), printErr: (line) => complaints.push(line) });
const model = mujoco.MjModel.from_xml_string(readFileSync(process.argv[2], "utf8"));
const data = new mujoco.MjData(model);

const bodies = Array.from({ length: model.nbody - 1 }, (_, i) => model.body(i + 1).name);
const sites = Array.from({ length: model.nsite }, (_, i) => model.site(i).name);
const triple = (array, i, n = 3) => Array.from(array.slice(n * i, n * i + n));

function look() {
  mujoco.mj_forward(model, data);
  return {
    turn: data.ctrl[0],
    motor: data.actuator_force[0],
    joints: Array.from(data.qpos),
    bodies: Object.fromEntries(bodies.map((name, i) => [name, { at: triple(data.xpos, i + 1), quat: triple(data.xquat, i + 1, 4) }])),
    sites: Object.fromEntries(sites.map((name, i) => [name, triple(data.site_xpos, i)])),
  };
}

function run(seconds, control = () => data.ctrl[0]) {
  const steps = Math.ceil(seconds / model.opt.timestep);
  for (let k = 1; k <= steps; ++k) {
    data.ctrl[0] = control(k / steps);
    mujoco.mj_step(model, data);
  }
}

function turnTo(goal) {
  const from = data.ctrl[0];
  // Starts and ends at rest.
  run(1.5 * Math.abs(goal - from) / speed, (s) => from + (goal - from) * s * s * (3 - 2 * s));
}

const keys = [];
mujoco.mj_resetDataKeyframe(model, data, 0);
for (let key = 0; key < model.nkey; ++key) {
  mujoco.mj_resetDataKeyframe(model, data, key);
  keys.push(look());
}
mujoco.mj_resetDataKeyframe(model, data, 0);
const driven = [];
for (const { turn } of keys) {
  turnTo(turn);
  run(settling);
  driven.push(look());
}
const swept = [];
const sweep = Number(process.argv[3] ?? 0);
const begin = data.ctrl[0];
for (let k = 1; k <= Math.abs(sweep) / observed; ++k) {
  const goal = begin + k * Math.sign(sweep) * observed, from = data.ctrl[0];
  run(observed / speed, (s) => from + (goal - from) * s);
  swept.push(look());
}
console.log(JSON.stringify({ complaints, names: bodies, joints: model.njnt, mass: Array.from(model.body_mass), gravity: Array.from(model.opt.gravity), keys, driven, swept }));
