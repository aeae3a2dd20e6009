// The engine in the page against the program: the same library, compiled twice, must give the same answers.
import {criteria_of} from "../src/analyses/analyses";
import {suggested_limit, suggested_tolerances} from "../src/analyses/tolerances/editing";
import {execFileSync} from "node:child_process";
import {existsSync, mkdtempSync, readdirSync, readFileSync, writeFileSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {fileURLToPath} from "node:url";
import {beforeAll, describe, expect, test} from "vitest";
import {tau_of_places} from "../src/engine/axis";
import {load_module} from "../src/engine/node";
import {
  linkage_types,
  state_width,
  whole,
  type Kind,
  type Linkage,
  type MapAnswer,
  type Mistake,
  type Picked,
  type Property,
  type ReplyMessage,
  type Replies,
  type RequestMessage,
  type Requests,
} from "../src/contract/messages";
import {Engine} from "../src/engine/serve";
import {load_thumbnails, stored_start} from "../src/engine/stored";
import {first_example} from "../src/gallery/gallery";
import {halo_reach, roomy_squares} from "../src/state/halo_follower";
import {sampled_cells} from "../src/region/sampled";
import {engine_text} from "../src/state/problem";
import {read_problem} from "../src/state/problem_shape";
import {poses_of} from "../src/state/task";
import {
  incompleteness,
  properties_of,
  property_descriptions,
  kind_of,
  requirements_of,
  task_kinds,
} from "../src/tasks/kinds";
import {round_of, rounds_of} from "../src/tasks/six_bar/search.svelte";

const root = fileURLToPath(new URL("../../", import.meta.url));
const program = join(root, "build/release/bin/linkwright");
const scratch = mkdtempSync(join(tmpdir(), "linkwright-"));
const tailgate = readFileSync(join(root, "examples/tailgate.json"), "utf8");
const all_properties = Object.keys(property_descriptions) as Property[];
const coarse = 100;
const some_yields = 2000; // cells, spread over the map: a thousand machines each, and a map has tens of thousands
const locked_deg = 1e-3; // so near a dead point a last bit decides whether it is passed

let server: Engine;
beforeAll(async () => {
  expect(existsSync(program), "build/release is built first (script/build)").toBe(true);
  server = new Engine(await load_module());
});

function reply<K extends Kind>(kind: K, content: Requests[K]): Replies[K] | {refused: Mistake[]} {
  const {message} = server.serve({id: 1, kind, ...content} as unknown as RequestMessage);
  const answer = message as Exclude<Extract<ReplyMessage, {id: number}>, {tidings: unknown}>;
  return "refused" in answer ? {refused: answer.refused.mistakes} : (answer.reply as Replies[K]);
}
function ask<K extends Kind>(kind: K, content: Requests[K]): Replies[K] {
  const answer = reply(kind, content);
  if ("refused" in answer) throw new Error(JSON.stringify(answer.refused));
  return answer;
}
function explored(problem: string, property: MapAnswer["property"] = "link_ratio", n = coarse) {
  return ask("explore", {problem, samples: n, window: whole, property, order: "fresh"});
}

interface Case {
  name: string;
  problem: string;
}
type Row = [x: number, y: number, theta: number]; // of a pose, or of its derivative
/** The worked cases of data/planar as problems. */
function worked_cases(): Case[] {
  const folder = join(root, "data/planar/");
  return readdirSync(folder)
    .filter((file) => file.endsWith(".json"))
    .map((file) => {
      const positions = JSON.parse(readFileSync(folder + file, "utf8")).positions as [Row, ...Row[]][];
      const poses = positions.map(([[x, y, theta], ...derivatives]) => ({
        x,
        y,
        theta_deg: (theta * 180) / Math.PI,
        ...(derivatives.length > 0 && {
          derivatives: derivatives.map(([dx, dy, dtheta]) => ({x: dx, y: dy, theta: dtheta})),
        }),
      }));
      const task = {kind: "motion", mechanism: "four_bar", poses};
      return {name: file, problem: JSON.stringify({linkwright: 1, task})};
    });
}
function examples(): Case[] {
  const folder = join(root, "examples/");
  return readdirSync(folder)
    .filter((file) => file.endsWith(".json"))
    .map((name) => ({name, problem: readFileSync(folder + name, "utf8")}));
}

function run(...args: string[]): string {
  return execFileSync(program, args, {encoding: "utf8", maxBuffer: 1 << 28, stdio: ["ignore", "pipe", "pipe"]});
}
/** Where an axis is no Burmester curve it is laid out for a map of 400. */
function samples_of(problem: string): number {
  const {kind, given = {}} = JSON.parse(problem.replace(/^\s*\/\/.*$/gm, "")).task;
  return kind === "function" || "side_lengths" in given || "side_length" in given || "side_angle_deg" in given
    ? 400
    : coarse;
}
/** What the program answers; null where it refuses. */
function solved(problem: string, samples: number) {
  const file = join(scratch, "problem.json");
  writeFileSync(file, problem);
  try {
    return JSON.parse(run("solve", file, "--region", "--samples", String(samples), "-o", "-"));
  } catch (error) {
    if ((error as {status?: number}).status === 2) return null;
    throw error;
  }
}
const decoded = (text: string) => new Uint8Array(Buffer.from(text, "base64"));
const floats = (text: string) => new Float32Array(decoded(text).buffer);

function expect_near(value: number, wanted: number, room: number, what: string): void {
  if (!(Math.abs(value - wanted) <= room)) expect(value, `${what}: not within ${room}`).toBe(wanted);
}
/** Homogeneous vectors: the same direction. */
function expect_same_point(a: readonly number[], b: readonly number[], size: number, room: number, what: string): void {
  const scaled = (v: readonly number[]) => [v[0]! * size, v[1]!, v[2]!];
  const unit = (v: number[]) => v.map((x) => x / Math.hypot(...v));
  const p = unit(scaled(a)),
    q = unit(scaled(b));
  if (Math.hypot(...a) === 0 && Math.hypot(...b) === 0) return; // no partner at all
  const sign = p[0]! * q[0]! + p[1]! * q[1]! + p[2]! * q[2]! < 0 ? -1 : 1;
  const distance = Math.hypot(...p.map((x, i) => x - sign * q[i]!));
  expect_near(distance, 0, room, what);
}

/** The angles between two axes of the links, or the lengths, in the same unit on both sides. */
function sizes_of(wanted: Record<string, Record<string, number>>, linkage: Linkage): [Sizes, Sizes] {
  return wanted.angles_deg
    ? [linkage.spherical!.angles_deg as Sizes, wanted.angles_deg]
    : [linkage.lengths as unknown as Sizes, wanted.lengths!];
}

/** For each of our rows the program's. Only the places on a planar Burmester curve are the same bit by bit. */
function rows_of(ours: Float64Array, theirs: number[], exactly: boolean): number[] {
  const rising = [...ours.keys()].sort((a, b) => ours[a]! - ours[b]!),
    rows = new Array<number>(ours.length);
  expect(ours.length).toBe(theirs.length);
  for (const [row, own] of rising.entries()) {
    expect_near(ours[own]!, theirs[row]!, exactly ? 0 : 1e-12, `row ${row}`);
    rows[own] = row;
  }
  return rows;
}
type Sizes = Record<string, number>;
interface Pair {
  ours: number;
  theirs: number;
}
/** Our cells and the program's. */
function* cells_of(
  map: MapAnswer,
  region: {input_coordinate: number[]; output_coordinate: number[]},
  exactly: boolean,
): Generator<Pair> {
  const rows = rows_of(map.input_tau, region.input_coordinate, exactly),
    columns = rows_of(map.output_tau, region.output_coordinate, exactly);
  for (const [i, row] of rows.entries())
    for (const [k, column] of columns.entries()) yield {ours: i * map.columns + k, theirs: row * map.columns + column};
}

/** What the program says of the samples of its own map; the page draws others at every look. */
const of_its_samples = new Set(["side_links_left_out", "linkages_left_out", "stretch_between_samples"]);

describe.each([...examples(), ...worked_cases()])("$name", ({problem}) => {
  const samples = samples_of(problem),
    result = existsSync(program) ? solved(problem, samples) : null;
  // tests/bindings and the kinds' own tests compare their maps and linkages.
  const others = ["six_bar", "straight_line"].some((name) =>
    [result?.problem.task.mechanism, result?.problem.task.kind].includes(name),
  );
  const has_map = result?.region?.type && !others,
    exactly = samples === coarse && result?.problem.task.mechanism !== "spherical_four_bar";
  const shared_properties = has_map ? all_properties.filter((property) => property in result.region.properties) : [];
  const their_defects = has_map ? decoded(result.region.defects) : new Uint8Array();
  const same_defects = (map: MapAnswer, {ours, theirs}: Pair) => map.defects[ours] === their_defects[theirs];
  // Sines of two C libraries differ in the last bit; the conditions of the task magnify that.
  const well_conditioned = result?.condition < 1e4,
    precision = 1e-12 * Math.max(10, result?.condition);

  test("is refused by both or by none", () => {
    const answer = reply("explore", {problem, samples, window: whole, property: "link_ratio", order: "fresh"});
    expect("refused" in answer).toBe(result === null);
  });
  test.runIf(result && !others)("has the same curve, or axes", () => {
    const {task} = explored(problem);
    expect(task.status).toBe(result.status);
    expect(task.pattern).toBe(result.pattern);
    for (const [i, side] of (["input", "output"] as const).entries()) {
      if (result.status !== "solved") continue;
      expect(task.axes[side].quantity).toBe(result.region.axes[i].quantity);
      expect(task.axes[side].branches).toEqual(result.region.axes[i].branches);
    }
    if (!result.curve) return;
    expect(task.curves.kind).toBe(result.curve.kind);
    expect(task.curves.center_kind ?? undefined).toBe(result.curve.center_kind);
    expect_near(
      task.characteristic_length,
      result.characteristic_length,
      1e-12 * result.characteristic_length,
      "length",
    );
    const {pivot_on} = result.problem.task; // where they leave single dyads of the curve, those are the axes
    if (!pivot_on) expect(task.axes.input.branches).toEqual(result.curve.branches);
    if (task.reason) expect(task.reason.message).toBe(result.reason);
    const of_task = result.warnings.filter(({code}: {code: string}) => !of_its_samples.has(code));
    expect(task.warnings.map(({code, message}) => ({code, message}))).toEqual(of_task);
    if (!well_conditioned || result.status !== "solved" || !task.symmetric) return;
    const {coordinate} = result.curve.samples,
      centers = result.curve.samples.center_homogeneous ?? result.curve.samples.fixed_axis,
      circles = result.curve.samples.circle_homogeneous ?? result.curve.samples.moving_axis;
    for (const [i, tau] of (coordinate as number[]).entries()) {
      const {linkage} = ask("linkage", {problem, tau: [tau, tau]});
      expect_same_point(
        linkage.input.center_homogeneous,
        centers[i],
        result.characteristic_length,
        precision,
        `τ ${tau}`,
      );
      expect_same_point(
        linkage.input.circle_homogeneous,
        circles[i],
        result.characteristic_length,
        precision,
        `τ ${tau}`,
      );
    }
  });
  test.runIf(has_map)("has the same map", () => {
    const {map} = explored(problem, "min_transmission_angle_deg", samples);
    const type = decoded(result.region.type),
      angles = floats(result.region.properties.min_transmission_angle_deg);
    let differing = 0,
      by_a_bit = 0;
    for (const pair of cells_of(map!, result.region, exactly)) {
      if (map!.type[pair.ours] === type[pair.theirs] && same_defects(map!, pair)) continue;
      if (Math.max(map!.value[pair.ours]!, angles[pair.theirs]!) < locked_deg) ++by_a_bit;
      else ++differing;
    }
    expect(differing).toBe(0);
    if (by_a_bit > 0) return;
    const {counts} = result.region,
      {census} = map!;
    expect(census.types).toEqual(linkage_types.map((name) => counts[name] ?? 0)); // a file has those of its class
    expect([census.order, census.branch, census.circuit, census.defect_free, census.pairs]).toEqual([
      counts.order,
      counts.branch,
      counts.circuit,
      counts.defect_free,
      counts.pairs,
    ]);
    expect(census.meeting).toBe(result.region.meeting_requirements);
    expect(map!.fails.filter((bits) => bits === 0).length).toBe(census.meeting);
  });
  test.each(shared_properties)("has the same %s", (property) => {
    explored(problem, property, samples);
    const {done, total} = property === "yield" ? ask("yields", {problem, cells: some_yields}) : {done: 0, total: 0};
    expect(done).toBe(Math.min(total, some_yields));
    const {map} = explored(problem, property, samples);
    const sampled = done < total ? sampled_cells(map!, done, 0) : null;
    const wanted = floats(result.region.properties[property]);
    // Single precision: its last bit turns over here and there, more where a link is very long or an angle nearly 0.
    let beyond = 0;
    for (const pair of cells_of(map!, result.region, exactly)) {
      if (!same_defects(map!, pair)) continue;
      if (sampled && map!.fails[pair.ours] === 0 && !sampled[pair.ours]) continue;
      const value = map!.value[pair.ours],
        right = wanted[pair.theirs]!;
      beyond += Number(Math.abs(value! - right) > 1.2e-7 * Math.abs(right));
      expect_near(
        value!,
        right,
        (well_conditioned ? 1e-4 : 1e-2) * Math.abs(right) +
          (property === "min_transmission_angle_deg" ? locked_deg : 0),
        `${property} ${pair.ours}`,
      );
    }
    if (well_conditioned) expect(beyond).toBeLessThanOrEqual(map!.value.length / 100);
  });
  test.runIf(result?.linkages?.length && !others)("has the same linkages", () => {
    for (const wanted of result.linkages) {
      const tau = [wanted.input.coordinate, wanted.output.coordinate] as const;
      const {linkage} = ask("linkage", {problem, tau});
      if ([linkage.type, wanted.type].includes("change_point")) continue; // a last bit decides
      expect(linkage.type).toBe(wanted.type);
      expect(linkage.defects).toEqual(wanted.defects);
      expect(linkage.drive_sense).toBe(wanted.drive);
      expect(linkage.swapped!.type).toBe(wanted.swapped.type);
      const [ours, theirs] = sizes_of(wanted, linkage),
        size = Math.max(...Object.values(theirs));
      for (const link of ["ground", "input", "coupler", "output"] as const) {
        // Where the directions of a grounded link end, the fixed pivot runs with all speed.
        expect_near(ours[link]!, theirs[link]!, (exactly ? precision : 1e-6) * size, link);
      }
    }
  });
});

describe("a file that is no problem", () => {
  const folder = join(root, "data/bad_problems/");
  const files = Object.keys(JSON.parse(readFileSync(folder + "expected.json", "utf8")).files);
  test.each(files)("%s is refused in the program's words", (file) => {
    // As a browser reads a file: bytes that are no UTF-8 become replacement characters.
    const text = readFileSync(folder + file, "utf8");
    const copy = join(scratch, file);
    writeFileSync(copy, text);
    let said = "";
    try {
      run("solve", copy);
    } catch (error) {
      said = (error as {stderr: string}).stderr;
    }
    for (const answer of [
      reply("explore", {problem: text, samples: coarse, window: whole, property: "link_ratio", order: "fresh"}),
      reply("read", {text}),
    ]) {
      expect("refused" in answer).toBe(said !== "");
      if (!("refused" in answer)) continue;
      const lines = said.trimEnd().split("\n");
      expect(answer.refused.length).toBe(lines.length);
      for (const [i, {place, message}] of answer.refused.entries()) {
        expect(lines[i]).toContain(message);
        expect(lines[i]).toContain(place);
      }
    }
  });
});

describe("the tailgate", () => {
  const at = {problem: tailgate, tau: [1.3125, 1.1125]} as const;
  const with_angle = (degrees: number) => tailgate.replace('angle_deg": 30', `angle_deg": ${degrees}`);

  test("has its known linkage", () => {
    const {linkage} = ask("linkage", at);
    expect(linkage.type).toBe("triple_rocker_output");
    expect(linkage.min_transmission_angle_deg).toBeCloseTo(73.5, 1);
    expect(linkage.link_ratio).toBeCloseTo(4.7, 1);
    expect(linkage.longest).toBeCloseTo(256, 0);
    expect(Object.values(linkage.lengths!).map((x) => x.toFixed(2))).toEqual(["65.03", "211.05", "53.92", "255.90"]);
  });
  test("passes its positions exactly and in order", () => {
    const {states, ticks, task} = ask("linkage", at).linkage.drive!;
    const poses = JSON.parse(tailgate.replace(/^\s*\/\/.*$/gm, "")).task.poses;
    let last = -1;
    for (const [i, tick] of ticks.entries()) {
      expect(tick.reached).toBe(true);
      expect(tick.state).toBeGreaterThan(last);
      last = tick.state;
      const [x, y, theta] = states.subarray(tick.state * state_width + 5);
      expect(Math.hypot(x! - poses[i].x, y! - poses[i].y)).toBeLessThan(1e-9);
      expect(theta).toBeCloseTo(poses[i].theta_deg, 9);
    }
    expect(task).toEqual([ticks[0]!.state, ticks[3]!.state]);
  });
  test("exchanges its grounded links with its drivers", () => {
    const {linkage} = ask("linkage", at),
      mirrored = ask("linkage", {problem: tailgate, tau: [1.1125, 1.3125]}).linkage;
    expect(mirrored.lengths!.input).toBe(linkage.lengths!.output);
    expect(mirrored.type).toBe(linkage.swapped!.type);
  });
  test("says which value would leave something, and keeps its word", () => {
    const {census} = explored(with_angle(89)).map!;
    expect(census.meeting).toBe(0);
    const {requirement, value, leaves} = census.relax[0]!;
    expect(requirement).toBe("min_transmission_angle_deg");
    expect(explored(with_angle(value as number)).map!.census.meeting).toBe(leaves);
  });
  test("leads to the box that would do, and names what leaves nothing only together, as the program does", () => {
    const asking = (requirements: object) => {
      const problem = JSON.parse(tailgate.replace(/^\s*\/\/.*$/gm, ""));
      return JSON.stringify({...problem, requirements: {...problem.requirements, ...requirements}});
    };
    const solved = (text: string) => {
      const file = join(scratch, "asking.json");
      writeFileSync(file, text);
      return JSON.parse(run("solve", file, "-o", "-"));
    };
    const box = {x: [150, 160], y: [300, 320]},
      narrow = asking({ground_pivots_within: box});
    const {relax, missed_boxes} = explored(narrow, "min_transmission_angle_deg", 400).map!.census,
      result = solved(narrow);
    expect(relax).toEqual(result.relax);
    expect(
      explored(asking({[relax[0]!.requirement]: relax[0]!.value}), "min_transmission_angle_deg", 400).map!.census
        .meeting,
    ).toBe(relax[0]!.leaves);
    expect(missed_boxes).toHaveLength(1);
    const {nearest, beyond} = missed_boxes[0]!;
    expect([nearest[0] - beyond[0], nearest[1] - beyond[1]].map((v) => Number(v.toFixed(9)))).toEqual([150, 320]);
    expect(result.reason).toContain(
      "The centre-point curve does not enter ground_pivots_within; nearest is (141.9, 320.6)",
    );

    const two = asking({ground_pivots_within: box, max_length: 50}),
      {relax_together} = explored(two, "min_transmission_angle_deg", 400).map!.census;
    expect(relax_together!.requirements).toEqual(["max_length", "ground_pivots_within"]);
    expect(relax_together).toEqual(solved(two).relax_together);
  });
  test("keeps its map still where the curve splits", () => {
    const moved = (x: number) => tailgate.replace('{"x": -220, "y": 220', `{"x": ${-220 + x}, "y": 220`);
    const frame = (x: number, order: "nearest" | "fresh") =>
      ask("explore", {problem: moved(x), samples: 200, window: whole, property: "link_ratio", order});
    const one = frame(-0.412, "fresh"),
      other = frame(-0.373, "nearest");
    expect(one.task.curves.kappa! < 0).toBe(true);
    expect(other.task.curves.kappa! > 0).toBe(true);
    const changed = one.map!.type.filter(
      (type, i) => type !== other.map!.type[i] || one.map!.defects[i] !== other.map!.defects[i],
    );
    expect(changed.length / 200 ** 2).toBeLessThan(0.1);
    const forced = ask("explore", {
      problem: moved(-0.373),
      samples: 200,
      window: whole,
      property: "link_ratio",
      order: other.task.axes.input.order,
    });
    expect(forced.map!.type).toEqual(other.map!.type);
  });
  test("brings with a map what is picked there: its place stays, τ follows", () => {
    const explore = (problem: string, picked: Picked | null, live = false) =>
      ask("explore", {problem, samples: coarse, window: whole, property: "link_ratio", order: "nearest", picked, live});
    const [before, after] = [-0.412, -0.373].map((x) => tailgate.replace('{"x": -220', `{"x": ${-220 + x}`)); // the curve splits
    const {axes} = explore(before!, null).task,
      place = [0.7, 0.4] as const,
      tau = tau_of_places(axes, place)!,
      asked = {problem: before!, tau};
    const {linkage, live} = explore(before!, {tau, place: null}, true);
    expect([linkage, live!.input]).toEqual([ask("linkage", asked).linkage, ask("live", asked).input]);
    const there = explore(after!, {tau, place}),
      moved = tau_of_places(there.task.axes, place)!;
    expect(moved).not.toEqual(tau);
    expect(there.linkage).toEqual(ask("linkage", {problem: after!, tau: moved}).linkage);
    expect(there.live).toBeNull();
    expect(explore(after!, {tau: [9, 9], place: null}).linkage).toBeNull(); // none of its axes
    expect(explore(after!, null).linkage).toBeNull();
  });
  test("says where its third position may go", () => {
    const {counts, offsets, steps} = ask("halo", {
      problem: tailgate,
      part: 2,
      mode: "move",
      reach: 40,
      steps: 13,
      samples: 60,
    });
    expect(steps).toBe(13);
    expect([offsets[0], offsets[6], offsets[12]]).toEqual([-40, 0, 40]);
    const center = counts[6 * 13 + 6];
    expect(center).toBe(explored(tailgate, "link_ratio", 60).map!.census.meeting);
    expect(counts[6 * 13 + 12]).toBe(0); // at +40 in x
    // What the tour asks for: the last position goes far without all being lost.
    const poses = poses_of(first_example!.problem.task);
    const room = poses.map((_, part) =>
      roomy_squares(
        ask("halo", {problem: tailgate, part, mode: "move", reach: halo_reach(poses), steps: 13, samples: 60}).counts,
      ),
    );
    expect(Math.max(...room)).toBe(room[3]);
    expect(room[3]).toBeGreaterThan(13 ** 2 / 3);
    const turned = ask("halo", {problem: tailgate, part: 2, mode: "turn", reach: 5, steps: 5, samples: 60});
    expect(turned.counts.length).toBe(5);
    expect(turned.counts[2]).toBe(center);
  });
  test("is improved, verified, traced and written", () => {
    const {tau, improved} = ask("improve", at);
    expect(improved).toBe(true);
    const angle = (linkage: Linkage) => linkage.min_transmission_angle_deg!;
    expect(angle(ask("linkage", {problem: tailgate, tau}).linkage)).toBeGreaterThan(angle(ask("linkage", at).linkage));
    expect(ask("verify", {problem: tailgate, tau}).verified).toBe(true);
    expect(ask("trace", {...at, point: [10, 20]}).points.length % 2).toBe(0);
    for (const format of ["svg", "dxf", "csv", "json", "result"] as const) {
      const {text, extension} = ask("export", {...at, format});
      expect(text.length).toBeGreaterThan(1000);
      expect(extension.startsWith(".")).toBe(true);
    }
    const linkage = join(scratch, "linkage.json");
    writeFileSync(linkage, ask("export", {...at, format: "json"}).text);
    expect(run("analyze", linkage)).toContain("Triple rocker");
  });
  test("has the best linkages that the program finds", () => {
    const file = join(scratch, "best.json");
    writeFileSync(file, tailgate);
    const result = JSON.parse(run("solve", file, "-o", "-"));
    const {linkages} = ask("best", {problem: tailgate, most: 10});
    expect(linkages.map(({type}) => type)).toEqual(result.linkages.map((linkage: {type: string}) => linkage.type));
    for (const [i, {tau}] of linkages.entries()) {
      expect(tau[0]).toBeCloseTo(result.linkages[i].input.coordinate, 6);
      expect(tau[1]).toBeCloseTo(result.linkages[i].output.coordinate, 6);
    }
  });
  test("finds the six-bars that the program finds for the same file", () => {
    const file = join(root, "examples/loader_bucket.json"),
      result = JSON.parse(run("solve", file, "-o", "-"));
    const problem = read_problem(JSON.parse(readFileSync(file, "utf8").replace(/^ *\/\/.*$/gm, "")))!,
      last = rounds_of(problem).at(-1)!;
    const {linkages} = ask("best", {problem: engine_text(round_of(problem, last)), most: problem.options?.best ?? 10});
    type Found = {min_transmission_angle_deg: number; chain?: {a: readonly number[]}};
    const numbers = (found: Found) => [found.min_transmission_angle_deg, ...found.chain!.a];
    const same = (one: Found, other: Found) =>
      numbers(one).every((number, k) => Math.abs(number - numbers(other)[k]!) < 5e-7);
    expect(linkages).toHaveLength(result.linkages.length);
    expect(same(linkages[0]!, result.linkages[0])).toBe(true);
    // Last digits differ between the two builds, and a climb may end on another hill.
    const shared = linkages.filter((found) => result.linkages.some((other: Found) => same(found, other)));
    expect(shared.length).toBeGreaterThanOrEqual(0.8 * linkages.length);
  });
  test("is stored for the page to begin with", async () => {
    const stored = stored_start(),
      live = explored(tailgate, stored.map.property, stored.map.samples);
    expect(stored.task.axes.input).toEqual(live.task.axes.input);
    expect(stored.map.type).toEqual(live.map!.type);
    expect(stored.map.fails).toEqual(live.map!.fails);
    expect(stored.task.curves.center.length).toBe(3 * stored.task.curves.tau.length);
    for (const [i, x] of live.task.curves.center.entries())
      expect(Math.abs(stored.task.curves.center[i]! - x)).toBeLessThanOrEqual(1e-7 * Math.abs(x));
    const {linkage} = ask("linkage", {problem: tailgate, tau: stored.linkage.tau});
    for (const [i, x] of linkage.drive!.states.entries())
      expect(Math.abs(stored.linkage.drive!.states[i]! - x)).toBeLessThanOrEqual(1e-7 * Math.abs(x));
    const thumbnail = await load_thumbnails();
    expect(thumbnail("landing_gear")!.linkage!.pivots.length).toBe(4);
    expect(thumbnail("landing_gear")!.type.length).toBe(64 ** 2);
    expect(thumbnail("nothing")).toBeNull();
  });
});

describe("yields", () => {
  const problem = engine_text({
    ...first_example!.problem,
    tolerances: {length: 0.5, limit: {position: 2}, samples: 1000},
  });
  const values = () => explored(problem, "yield", 60).map!;

  test("are sampled in the order in which the map tells them apart", () => {
    explored(problem, "yield", 60);
    const {done, total} = ask("yields", {problem, cells: 40}),
      some = values();
    expect(done).toBe(40);
    expect(total).toBe(some.census.meeting);
    const sampled = sampled_cells(some, done, 0);
    while (ask("yields", {problem, cells: 1000}).done < total);
    const all = values().value;
    expect(sampled_cells(some, total, 0).reduce((sum, is) => sum + is, 0)).toBe(total);
    const changed = [...all.keys()].filter((cell) => all[cell] !== some.value[cell]);
    expect(changed.length).toBeGreaterThan(total / 10);
    expect(changed.filter((cell) => sampled[cell])).toEqual([]);
  });
});

describe("suggested tolerances", () => {
  const beginnings = task_kinds
    .flatMap((kind) => (kind.analysed?.tolerances ? kind.beginnings : []))
    .map(({id, make}) => ({id, problem: make()}))
    .filter(({problem}) => incompleteness(problem) === null);

  test.each(beginnings)("and the limit are what the engine takes, requirements and all: $id", ({problem}) => {
    const made = {...problem, tolerances: suggested_tolerances(problem.task)},
      asked = {...made, tolerances: {...made.tolerances, limit: suggested_limit(made)}};
    const keys = requirements_of(problem.task),
      required = {...asked, requirements: {...asked.requirements, max_tolerance_error: 1e6, min_yield: 0.01}};
    expect(keys.slice(-2)).toEqual(["max_tolerance_error", "min_yield"]);
    expect(Object.keys(criteria_of(kind_of(problem.task)).requirements).sort()).toEqual([...keys].sort());
    expect(properties_of(asked)).toEqual(expect.arrayContaining(["tolerance_error", "yield"]));
    for (const objective of ["tolerance_error", "yield"] as const) {
      const text = engine_text({...required, options: {...required.options, objective}}),
        {map} = explored(text, "tolerance_error", 20);
      expect(Object.keys(map!.census.only)).toEqual([...keys]);
    }
  });
});
