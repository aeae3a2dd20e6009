import {readFileSync} from "node:fs";
import {it} from "vitest";
import {create_linkwright} from "../../engine/module";
import {Engine} from "../../engine/serve";
import {whole} from "../../engine/protocol";
import {examples} from "../../gallery/gallery";
import {engine_text} from "../../state/problem";
import {six_bar_kind} from "./kind";
const wasm = readFileSync(new URL("../../engine/generated/linkwright.wasm", import.meta.url));
it("times", {timeout: 100000}, async () => {
  const server = new Engine(await create_linkwright({wasmBinary: wasm}));
  const ask = (kind: string, content: object) => (server.serve({id: 1, kind, ...content} as never).message as any).reply;
  for (const problem of [examples.find(({name}) => name === "wheel_loader")!.problem, six_bar_kind.beginnings[0]!.make()])
  for (const tol of [false, true]) {
    const p = tol ? {...problem, tolerances: {length: 0.5, limit: {position: 5}}} as any : problem;
    for (const samples of [100, 400, 1000, 101, 401, 1001]) {
      const t0 = performance.now();
      const r = ask("explore", {problem: engine_text(p), samples, window: samples % 2 ? {input: [0, 0.999], output: [0, 1]} : whole, property: tol ? "tolerance_error" : "min_transmission_angle_deg", order: "fresh"});
      console.log(tol, samples, r.map.rows, (performance.now() - t0).toFixed(1), ((performance.now() - t0)*1000/r.map.rows/r.map.columns).toFixed(1)+" us", r.map.census.meeting);
    }
    const t0 = performance.now();
    const h = ask("halo", {problem: engine_text(p), pose: 2, part: 2, mode: "move", reach: 60, steps: 13, samples: 60});
    console.log("halo", (performance.now() - t0).toFixed(1), String(h?.counts));
  }
});
