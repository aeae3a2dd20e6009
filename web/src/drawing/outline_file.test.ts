import {DOMParser as XmlParser} from "@xmldom/xmldom";
import {execFileSync, spawnSync} from "node:child_process";
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {afterAll, beforeAll, describe, expect, it, vi} from "vitest";
import {load_engine, type Engine} from "../engine/node";
import type {Point} from "../contract/messages";
import type {OutlineShape} from "../contract/replies";
import type {Workbench} from "../state/workbench.svelte";
import {read_outlines} from "./outline_file";
import {preset, preset_names} from "./outline_presets";

const root = join(import.meta.dirname, "../../.."),
  program = process.env.LINKWRIGHT_CLI ?? join(root, "build/release/bin/linkwright");

/** As browsers do: what is no XML becomes a document that says so. */
class BrowserLikeParser {
  parseFromString(text: string): unknown {
    try {
      return new XmlParser({onError: () => {}}).parseFromString(text, "image/svg+xml");
    } catch {
      return new XmlParser().parseFromString("<parsererror/>", "application/xml");
    }
  }
}
let engine: Engine, folder: string;
beforeAll(async () => {
  vi.stubGlobal("DOMParser", BrowserLikeParser);
  engine = await load_engine();
  folder = mkdtempSync(join(tmpdir(), "linkwright-"));
});
afterAll(() => {
  rmSync(folder, {recursive: true});
  vi.unstubAllGlobals();
});

const size = 0.3 * 90 * Math.SQRT2;
async function read(name: string, text: string, unit = "mm"): Promise<readonly OutlineShape[] | string> {
  const run: Workbench["driver_client"] = {
    run: (job: {of: string; text: string}) => new Promise((resolve) => resolve(engine.ask("report", job))),
  } as never;
  return read_outlines({driver_client: run, unit}, new File([text], name), size);
}
async function shapes_of(name: string, text: string): Promise<readonly OutlineShape[]> {
  const shapes = await read(name, text);
  if (typeof shapes === "string") throw new Error(shapes);
  return shapes;
}
const svg = (inside: string, attributes = "") =>
  `<?xml version="1.0"?><!DOCTYPE svg><svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" ${attributes}>${inside}</svg>`;
const dxf = (...groups: (number | string)[]) =>
  [0, "SECTION", 2, "ENTITIES", ...groups, 0, "ENDSEC", 0, "EOF"].join("\r\n");

const plate = '<rect id="plate" x="1" y="2" width="40" height="20"/>';
const drawings: [name: string, text: string][] = [
  ["plate.svg", svg(plate, 'width="100mm" viewBox="0 0 1000 500"')],
  ["used.svg", svg(`<defs>${plate}</defs><use xlink:href="#plate" x="3" transform="scale(2 1)"/>`)],
  ["prefixed.svg", `<s:svg xmlns:s="http://www.w3.org/2000/svg"><s:g id="a"><s:path d="M0 0h9v9z"/></s:g></s:svg>`],
  ["noise.svg", svg(`<!-- <g> --><style><![CDATA[ a > b ]]></style><g title="&lt;&#65;&gt;">${plate}</g>`)],
  ["several.svg", svg(`<circle r="30"/><path d="M0 0C0 40 60 40 60 0S120 -40 120 0z"/>${plate}`)],
  ["lines.dxf", dxf(...[0, "LINE", 10, 0, 20, 0, 11, 9, 21, 0], ...[0, "LINE", 10, 9, 20, 0, 11, 4, 21, 8])],
  ["words.svg", svg("<text>hello</text>")],
  ["page.svg", "<html><body/></html>"],
  ["endless.svg", svg('<g id="a"><use href="#a"/><use href="#a"/></g>')],
  ["deep.svg", svg(`${"<g>".repeat(3000)}${"</g>".repeat(3000)}`)],
  ["binary.dxf", "AutoCAD Binary DXF\r\n\x1a\0"],
  ["nonsense.dxf", "nonsense"],
];
it.each(drawings)("the program makes the same outlines of %s, or refuses it in the same words", async (name, text) => {
  const [drawing, task] = [join(folder, name), join(folder, "task.json")],
    poses = [0, 30, 60, 90].map((x, i) => ({x, y: (x * x) / 90, theta_deg: 7 * i * i})); // 90 √2 across
  writeFileSync(drawing, text);
  writeFileSync(
    task,
    JSON.stringify({linkwright: 1, length_unit: "mm", task: {kind: "motion", mechanism: "four_bar", poses}}),
  );
  const outline = (shape: number) =>
    spawnSync(program, ["outline", drawing, task, "--shape", String(shape)], {encoding: "utf8"});
  const shapes = await read(name, text);
  if (typeof shapes === "string") {
    const {status, stderr} = outline(1);
    expect([status, stderr]).toEqual([2, expect.stringContaining(shapes.replace(/\.$/, ""))]);
  } else
    for (const [i, shape] of shapes.entries())
      expect((JSON.parse(outline(i + 1).stdout) as {view: object}).view).toEqual({outline: shape.outline});
});

describe("a file", () => {
  it("that is no XML is refused, and one of many bytes before it is read", async () => {
    expect(await read("a.svg", "<svg")).toMatch(/it is no XML\.$/);
    expect(await read("a.svg", " ".repeat(16e6 + 1))).toMatch(/^this is too large/);
  });
  it("has its shapes in the unit of the task", async () => {
    const inches = dxf(...[0, "CIRCLE", 10, 0, 20, 0, 40, 1]).replace(
      "0\r\nSECTION",
      ["0", "SECTION", 2, "HEADER", 9, "$INSUNITS", 70, 1, 0, "ENDSEC", 0, "SECTION"].join("\r\n"),
    );
    const [in_mm] = await shapes_of("a.dxf", inches),
      [in_inches] = (await read("a.dxf", inches, "英寸")) as OutlineShape[];
    expect([in_mm!.width, in_inches!.width].map((value) => Number(value.toFixed(6)))).toEqual([50.8, 2]);
  });
});

it("what the program exports comes back: the bars in each position, true to size", async () => {
  const [result, drawing, picture] = ["result.json", "out.dxf", "out.svg"].map((name) => join(folder, name));
  execFileSync(program, ["solve", join(root, "examples/landing_gear.json"), "-o", result!], {stdio: "ignore"});
  execFileSync(program, ["export", result!, "--format", "dxf", "-o", drawing!]);
  execFileSync(program, ["export", result!, "--format", "svg", "-o", picture!]);
  type Dyad = {center_point: Point; circle_point: Point};
  const [best] = (JSON.parse(readFileSync(result!, "utf8")) as {linkages: {input: Dyad; output: Dyad}[]}).linkages,
    shapes = await shapes_of("out.dxf", readFileSync(drawing!, "utf8"));
  const bars = shapes.filter(({outline, closed}) => outline.length === 4 && !closed),
    {input, output} = best!;
  const frame_length = Math.hypot(
    input.center_point[0] - output.center_point[0],
    input.center_point[1] - output.center_point[1],
  );
  expect(bars).toHaveLength(3); // the first is drawn in full
  for (const {outline} of bars) {
    const [first, , , last] = outline as [Point, Point, Point, Point];
    expect(Math.hypot(first[0] - last[0], first[1] - last[1])).toBeCloseTo(frame_length, 6);
  }
  expect((await shapes_of("out.svg", readFileSync(picture!, "utf8")))[0]!.frame).toBe(false);
});

it("presets are simple shapes of about the size asked for", () => {
  for (const name of preset_names) {
    const points = preset(name, 150),
      xs = points.map((p) => p[0]),
      ys = points.map((p) => p[1]);
    expect(points.length).toBeGreaterThanOrEqual(4);
    expect(Math.max(Math.max(...xs) - Math.min(...xs), Math.max(...ys) - Math.min(...ys))).toBeGreaterThan(120);
  }
});
