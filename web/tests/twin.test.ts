// The engine as WebAssembly says to the page what it says as a native program: all replies on examples and bad problems.
import {execFileSync} from "node:child_process";
import {existsSync, readFileSync, rmSync} from "node:fs";
import {join} from "node:path";
import {afterAll, beforeAll, describe, expect, it} from "vitest";
import type {LinkwrightModule, Session} from "../src/engine/module";
import {load_module} from "../src/engine/node";
import {scratch} from "./compared";
import {root} from "./program";

type Call = readonly [method: string, of: readonly unknown[], reply: unknown];
interface Twin {
  sessions: Record<string, Call[]>;
  reports: (readonly [of: string, text: string, reply: string])[];
}
const native = join(root, "build/release/bin/tests_bindings"); // tests/bindings/twin_replies_test.cpp
if (!existsSync(native)) throw new Error("build/release is built first, its tests too (script/build)");
const file = join(scratch, "twin.json");
execFileSync(native, ["--gtest_filter=TwinReplies.*"], {env: {...process.env, LINKWRIGHT_TWIN: file}});
const twin = JSON.parse(readFileSync(file, "utf8")) as Twin;
rmSync(file);

let module: LinkwrightModule;
beforeAll(async () => void (module = await load_module()));

const number = /-?\d+(?:\.\d+)?(?:e[-+]?\d+)?/g;
/** Libraries' sines differ in the last digit, and conditions are poor at times. */
const near = (a: number, b: number) => Math.abs(a - b) <= 1e-5 * Math.max(1, Math.abs(a), Math.abs(b));

/** Where both differ by more than rounding: numbers in texts, too. */
function differences(said: any, native: any, at = ""): string[] {
  if (typeof native === "number" && typeof said === "number" && near(said, native)) return [];
  if (typeof native === "string" && typeof said === "string") {
    if (said === native) return [];
    if (native.startsWith("{")) return differences(JSON.parse(said), JSON.parse(native), at);
    const words = said.replace(number, "#") === native.replace(number, "#") ? [] : [`${at}: other words`];
    return [
      ...words,
      ...differences((said.match(number) ?? []).map(Number), (native.match(number) ?? []).map(Number), at),
    ];
  }
  if (native === null || typeof native !== "object" || said === null || typeof said !== "object")
    return said === native ? [] : [`${at}: ${said}, native ${native}`];
  if (Array.isArray(native) && said.length !== native.length) return [`${at}: ${said.length} of ${native.length}`];
  return Object.keys(native).flatMap((key) => differences(said[key], native[key], `${at}.${key}`));
}

function box_of(vertices: ArrayLike<number>): number[] {
  const of_axis = (axis: number) => Array.from(vertices).filter((_, i) => i % 3 === axis);
  return [0, 1, 2].flatMap((axis) => [Math.min(...of_axis(axis)), Math.max(...of_axis(axis))]);
}
/** Of what hangs on a last digit, what does not: where a climb ends on level ground and at which corner a
 *  surface begins. A cell may lie on a border. */
function certain(method: string, reply: any): any {
  if (method === "machine") return {...reply, triangles: [...reply.triangles].length, vertices: box_of(reply.vertices)};
  if (method === "best") {
    const {linkages, notices} = JSON.parse(reply);
    return {notices, best: linkages[0] && [linkages[0].record.type, linkages[0].record.min_transmission_angle_deg]};
  }
  if (method !== "explore" || !reply.map) return reply;
  const {defects, fails, ...map} = reply.map;
  const census = JSON.parse(map.census ?? "null");
  if (census?.inside) census.inside.looked_at = null; // so many as the arcs inside are long, one more or less to each
  const passing = [...fails].filter((bits) => bits === 0).length;
  return {...reply, map: {...map, census, passing: Math.round(passing / 4), defects: [...defects].length}};
}

describe("a session", () => {
  let session: Session;
  beforeAll(() => void (session = new module.Session()));
  afterAll(() => session.delete());

  /** From starts that the last digit sorts: which paths follow the nearest, it decides, and hardly how near that is. */
  const is_searched = (calls: Call[]) =>
    calls.some(([, , reply]) => JSON.stringify((reply as any)?.task ?? "").includes("fitted_curve"));
  const error_of = ({fit, near}: any): number => fit?.error.rms_over_diagonal ?? near.error.rms;
  const nearest_of = (calls: Call[], replies: unknown[]) =>
    calls.flatMap(([method], i) =>
      method === "best" ? error_of(JSON.parse(replies[i] as string).linkages[0].record) : [],
    );

  it.each(Object.keys(twin.sessions))("says of %s what the native one says", (name) => {
    const calls = twin.sessions[name]!;
    if (is_searched(calls)) {
      const said = nearest_of(
          calls,
          calls.map(([method, of]) => (session as any)[method](...of)),
        ),
        native = nearest_of(
          calls,
          calls.map(([, , reply]) => reply),
        );
      expect(native.length).toBeGreaterThan(0);
      said.forEach((rms, i) => expect(Math.abs(rms - native[i]!)).toBeLessThan(0.02 * native[i]! + 1e-6));
      return;
    }
    for (const [method, of, reply] of calls)
      expect(
        differences(certain(method, (session as any)[method](...of)), certain(method, reply), method).slice(0, 8),
      ).toEqual([]);
  });
});
describe("a report", () => {
  it.each(twin.reports)("on %s says what the native one says of %s", (of, text, reply) =>
    expect(differences(module.report(of, text), reply).slice(0, 8)).toEqual([]),
  );
});
