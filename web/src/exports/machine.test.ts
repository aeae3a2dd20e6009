// The engine as it is built for the page makes the same plates and pins as the program: sines differ in the last bit from
// one machine to another, and nothing else.
import {execFileSync} from "node:child_process";
import {existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {fileURLToPath} from "node:url";
import {afterEach, beforeAll, describe, expect, it} from "vitest";
import {load_module} from "../engine/node";
import type {MachineFormat, MachinePlan, TauPair} from "../contract/messages";
import {Refusal} from "../engine/refusal";
import {Engine} from "../engine/serve";
import {no_mechanism} from "../figure/no_mechanism";
import {crossings_told} from "../figure/plate_words";
import {examples, first_example} from "../gallery/gallery";
import {engine_text, type Problem} from "../state/problem";
import {load_views, task_view} from "../kinds/view_dispatch";
import {bench, settled, type Bench} from "../state/workbench_bench";
import {ask_machine, machine_of} from "./machine";
import {plate_choice} from "./plate_form.svelte";

const program = fileURLToPath(new URL("../../../build/release/bin/linkwright", import.meta.url));
let engine: Engine;
beforeAll(async () => {
  engine = new Engine(await load_module());
  await load_views();
});

function best_of(problem: Problem): {problem: string; tau: TauPair} {
  const text = engine_text(problem);
  return {problem: text, tau: engine.ask("best", {problem: text, most: 1}).linkages[0]!.tau};
}
const example = (name: string) => examples.find((one) => one.name === name)!.problem;

const text_of = (bytes: Uint8Array) => new TextDecoder().decode(bytes);
const number = /-?\d+(?:\.\d+)?(?:e[-+]\d+)?/g;
const expect_same: Record<MachineFormat, (one: Uint8Array, other: Uint8Array) => void> = {
  "3mf": (one, other) => expect(one.length === other.length && one.every((byte, i) => byte === other[i])).toBe(true),
  stl(one, other) {
    expect(one.length).toBe(other.length);
    const [a, b] = [one, other].map(({buffer, byteOffset, length}) => new DataView(buffer, byteOffset, length));
    let apart = Math.abs(a!.getUint32(80, true) - b!.getUint32(80, true));
    for (let at = 84; at < one.length; at += 50)
      for (let k = 12; k < 48; k += 4)
        apart = Math.max(apart, Math.abs(a!.getFloat32(at + k, true) - b!.getFloat32(at + k, true)));
    expect(apart).toBeLessThan(2e-4); // of a metre, as floats
  },
  plates: expect_same_numbers,
  urdf: expect_same_numbers,
  sdf: expect_same_numbers,
  mjcf: expect_same_numbers,
};
function expect_same_numbers(one: Uint8Array, other: Uint8Array): void {
  const [a, b] = [text_of(one), text_of(other)];
  expect(a.replace(number, "#")).toBe(b.replace(number, "#"));
  const numbers = b.match(number)!.map(Number);
  a.match(number)!.forEach((value, i) => expect(Math.abs(Number(value) - numbers[i]!)).toBeLessThan(1e-6));
}

describe("a linkage as plates on pins", () => {
  it.each([
    ["stl", []],
    ["3mf", []],
    ["plates", []],
    ["urdf", []],
    ["sdf", []],
    ["mjcf", []],
    ["3mf", ["--clearance", "0.4", "--width", "30"]],
  ] as [MachineFormat, string[]][])("is the program's: %s %j", (format, options) => {
    expect(existsSync(program), "build/release is built first").toBe(true);
    const of = best_of(first_example.problem),
      sizes = options.length ? {clearance: 0.4, width: 30} : {},
      {bytes} = engine.ask("machine_file", {...of, sizes, format});
    const folder = mkdtempSync(join(tmpdir(), "linkwright-machine-"));
    try {
      const linkage = join(folder, "linkage.json"), // a result's title would say which of its linkages this is
        made = join(folder, "made");
      writeFileSync(linkage, engine.ask("export", {...of, format: "json"}).text);
      execFileSync(program, ["export", linkage, "--format", format, ...options, "-o", made], {stdio: "pipe"});
      expect_same[format](bytes, readFileSync(made));
    } finally {
      rmSync(folder, {recursive: true});
    }
  });
  it("has the sizes that are wanted, and others that go with them", () => {
    const of = best_of(first_example.problem),
      {sizes, layers} = engine.ask("machine", {...of, sizes: {clearance: 0, pin: 7}});
    expect(sizes).toMatchObject({clearance: 0, pin: 7, radius: 0});
    expect(sizes.width).toBeGreaterThan(7);
    expect(layers.map(({body}) => body)).toEqual(["ground", "input", "coupler", "output"]);
    expect(layers[0]!.layer).toBe(0);
  });
  it.each(["wheel_loader", "folding_wing"])("is made of any kind: %s", (name) => {
    const of = best_of(example(name)),
      plan = engine.ask("machine", {...of, sizes: {}});
    expect(plan.layers.length).toBe(name === "wheel_loader" ? 6 : 4);
    expect(plan.sizes.radius > 0).toBe(name === "folding_wing");
    const {mechanism} = task_view(example(name).task);
    for (const {body} of plan.layers) expect(mechanism.plate_words.body(body)).not.toMatch(/[._]/);
    expect(engine.ask("machine_file", {...of, sizes: {}, format: "3mf"}).bytes.subarray(0, 2)).toEqual(
      Uint8Array.from([0x50, 0x4b]),
    );
  });
  it("is refused where it cannot be made", () => {
    const of = best_of(first_example.problem);
    const refusal = (format: MachineFormat) => {
      try {
        engine.ask("machine_file", {...of, sizes: {pin: 1e6}, format});
      } catch (error) {
        return (error as Refusal).mistakes.map(({code}) => code);
      }
      return [];
    };
    expect(refusal("stl")).toEqual(refusal("plates"));
    expect(refusal("stl")).toHaveLength(1);
  });
  it("tells the first of what collides", () => {
    const plan = {
      crossings: [1, 2, 3, 4].map((n) => ({body: `body ${n}`, other: "ground", from_deg: n, to_deg: 2 * n})),
    } as unknown as MachinePlan;
    expect(crossings_told(no_mechanism, plan)).toHaveLength(3);
    expect(crossings_told(no_mechanism, plan)[0]).toBe("body 1 and ground collide in one layer between 1° and 2°.");
  });
});

describe("the question of it", () => {
  const tau: TauPair = [1.3125, 1.1125];
  const requests = ({asked}: Bench) => asked.filter(({kind}) => kind === "machine").length;

  it("is asked once, whoever asks, and not before", async () => {
    const b = bench(first_example.problem),
      of = machine_of(first_example.problem, tau);
    await settled(b);
    expect(requests(b)).toBe(0);
    const [one, other] = await Promise.all([ask_machine(b.workbench, of), ask_machine(b.workbench, {...of})]);
    expect(one).not.toBeNull();
    expect(other).toBe(one);
    expect(await ask_machine(b.workbench, {...of})).toBe(one);
    expect(b.workbench.machines.value).toBe(one);
    expect(requests(b)).toBe(1);
  });
  it("is superseded by that of another linkage, and has the last one's answer", async () => {
    const b = bench(first_example.problem);
    await settled(b);
    b.machine.late_ms.machine = 20;
    const places = [0, 1, 2, 3, 4].map((k): TauPair => [tau[0] + 1e-3 * k, tau[1]]),
      asked = places.map((place) => ask_machine(b.workbench, machine_of(first_example.problem, place)));
    const last = (await Promise.all(asked)).at(-1);
    expect(last).not.toBeNull();
    expect(b.workbench.machines.value).toBe(last);
    expect(b.workbench.machines.of!.tau).toEqual(places.at(-1));
    expect(requests(b)).toBeLessThanOrEqual(2); // that with the engine, and the last
  });
  it("says why it has no answer", async () => {
    const b = bench(first_example.problem);
    await settled(b);
    plate_choice.give("pin", 1e6);
    expect(await ask_machine(b.workbench, machine_of(first_example.problem, tau))).toBeNull();
    expect((b.workbench.machines.error as Refusal).mistakes[0]!.code).toBe("size_out_of_range");
    plate_choice.give("pin", null);
    expect(await ask_machine(b.workbench, machine_of(first_example.problem, tau))).not.toBeNull();
    expect(b.workbench.machines.error).toBeNull();
  });
});

describe("the sizes given", () => {
  afterEach(() => void (plate_choice.sizes = {}));
  it("are those that are not empty", () => {
    plate_choice.give("clearance", 0.3);
    plate_choice.give("pin", 4);
    plate_choice.give("pin", null);
    expect(plate_choice.sizes).toEqual({clearance: 0.3});
  });
});
