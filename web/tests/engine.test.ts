// The engine in the page against the program: the same library, compiled twice, must give the same answers.
import {readdirSync, readFileSync, writeFileSync} from "node:fs";
import {join} from "node:path";
import {describe, expect, test} from "vitest";
import {linkage_types, whole, type Linkage, type MapAnswer, type Property} from "../src/contract/messages";
import {sampled_cells} from "../src/region/sampled";
import {property_descriptions} from "../src/kinds/kind_dispatch";
import {ask, reply, explored, coarse} from "./asked_engine";
import {samples_of, solved, scratch} from "./compared";
import {root, run} from "./program";

const all_properties = Object.keys(property_descriptions) as Property[];
const some_yields = 2000; // cells, spread over the map: a thousand machines each, and a map has tens of thousands
const locked_deg = 1e-3; // so near a dead point a last bit decides whether it is passed

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
function example_cases(): Case[] {
  const folder = join(root, "examples/");
  return readdirSync(folder)
    .filter((file) => file.endsWith(".json"))
    .map((name) => ({name, problem: readFileSync(folder + name, "utf8")}))
    .filter(({problem}) => !is_fitted(problem));
}
/** Its list is that of a search, which the last digit sorts: twin.test.ts compares the nearest. */
function is_fitted(problem: string): boolean {
  const count = (part: RegExp) => problem.match(part)?.length ?? 0,
    near = count(/"near": true/g);
  return /"kind": "path"[^]*"(closed|tolerance)":/.test(problem) || (near > 0 && count(/"theta_deg"/g) - near < 4);
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

/** What files call places along the curve of the cranks, by what is laid along it. */
const along_curve = new Set(["crank_coordinate", "cognate_coordinate"]);

describe.each([...example_cases(), ...worked_cases()])("$name", ({problem}) => {
  const samples = samples_of(problem),
    result = solved(problem, samples);
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
      const {quantity} = result.region.axes[i];
      expect(task.axes[side].quantity).toBe(along_curve.has(quantity) ? "curve_coordinate" : quantity);
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
