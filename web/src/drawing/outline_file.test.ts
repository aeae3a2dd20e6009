import {DOMParser as XmlParser} from "@xmldom/xmldom";
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from "node:fs";
import {join} from "node:path";
import {execFileSync, spawnSync} from "node:child_process";
import {tmpdir} from "node:os";
import {beforeAll, afterAll, describe, expect, it, vi} from "vitest";
import type {Point} from "../contract/messages";
import en from "../texts/en.json";
import {body_of, outlines_in, unit_factor, type Shapes} from "./outline_file";
import {preset, preset_names} from "./outline_presets";
import {simplified, type Shape} from "./outlines/shapes";
import type {Refusal} from "./outlines/strokes";

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
beforeAll(() => vi.stubGlobal("DOMParser", BrowserLikeParser));
afterAll(() => vi.unstubAllGlobals());

/** A DXF group to each pair. */
type Groups = readonly (number | string)[];
const section = (name: string, ...groups: Groups) => [0, "SECTION", 2, name, ...groups, 0, "ENDSEC"];
const file = (...sections: Groups) => [...sections, 0, "EOF"].join("\r\n");
const drawing = (...entities: Groups) => file(...section("ENTITIES", ...entities));
const line = ([x0, y0]: Point, [x1, y1]: Point): Groups => [0, "LINE", 8, "0", 10, x0, 20, y0, 11, x1, 21, y1];
const arc = (x: number, y: number, r: number, from: number, to: number): Groups => [
  ...[0, "ARC", 8, "0", 10, x, 20, y, 40, r, 50, from, 51, to],
];
/** A vertex: x, y, bulge. */
const lwpolyline = (vertices: readonly (readonly number[])[], closed = true, ...more: Groups): Groups => [
  ...[0, "LWPOLYLINE", 8, "0", 90, vertices.length, 70, closed ? 1 : 0, ...more],
  ...vertices.flatMap(([x = 0, y = 0, bulge]) => [10, x, 20, y, ...(bulge === undefined ? [] : [42, bulge])]),
];
const rectangle = (x: number, y: number, w: number, h: number): Groups =>
  lwpolyline([
    [x, y],
    [x + w, y],
    [x + w, y + h],
    [x, y + h],
  ]);
const svg = (inside: string, attributes = "") =>
  `<?xml version="1.0"?><svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" ${attributes}>${inside}</svg>`;

/** All that is read here: the program reads it, too. */
const files_read = new Map<string, Shapes | Refusal>();
async function read_and_kept(name: string, text: string): Promise<Shapes | Refusal> {
  const read = await outlines_in(name, text);
  if (text.length < 1e5) files_read.set(`${name.slice(-3)}|${text}`, read);
  return read;
}
async function found(text: string, name = "part.dxf"): Promise<Shapes> {
  const shapes = await read_and_kept(name, text);
  if (typeof shapes === "string") throw new Error(`refused: ${shapes}`);
  return shapes;
}
async function only(text: string, name?: string): Promise<Shape> {
  const {shapes} = await found(text, name);
  expect(shapes).toHaveLength(1);
  return shapes[0]!;
}
const refusal = async (text: string, name = "part.dxf"): Promise<Refusal | Shapes> => read_and_kept(name, text);
function area(points: readonly Point[]): number {
  return Math.abs(
    points.reduce((sum, [x, y], i) => {
      const [nx, ny] = points[(i + 1) % points.length]!;
      return sum + (x * ny - nx * y) / 2;
    }, 0),
  );
}
const of_many = (entities: readonly Groups[]) =>
  [0, "SECTION", 2, "ENTITIES", entities.flat(), 0, "ENDSEC", 0, "EOF"].flat(2).join("\n");
/** Where it lies, at three decimals. */
function box({points}: Shape): number[] {
  const xs = points.map(([x]) => x),
    ys = points.map(([, y]) => y);
  return [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)].map((v) => Number(v.toFixed(3)) + 0);
}
const rounded = (points: readonly Point[]) =>
  points.map(([x, y]) => [Number(x.toFixed(6)) + 0, Number(y.toFixed(6)) + 0]);

describe("DXF", () => {
  it("gives the corners of polylines, new and old", async () => {
    const corners = [
      [0, 0],
      [80, 0],
      [80, 20],
      [0, 20],
    ];
    expect((await only(drawing(...lwpolyline(corners)))).points).toEqual(corners);
    const vertex = ([x = 0, y = 0]: number[]): Groups => [0, "VERTEX", 8, "0", 10, x, 20, y];
    const old = [0, "POLYLINE", 66, 1, 10, 0, 20, 0, 70, 1, ...corners.flatMap(vertex), 0, "SEQEND"];
    const shape = await only(drawing(...old));
    expect([shape.points, shape.closed]).toEqual([corners, true]);
  });
  it("draws bulges as arcs, to either side", async () => {
    // A slot 40 long between centres, of radius 10, counterclockwise: half circles at both ends.
    const slot = await only(drawing(...lwpolyline([[0, -10], [40, -10, 1], [40, 10], [0, 10, 1]]))); // prettier-ignore
    expect(box(slot)).toEqual([-10, 50, -10, 10]);
    expect(area(slot.points)).toBeCloseTo(800 + 100 * Math.PI, -1);
    for (const [x, y] of slot.points) if (x > 40) expect(Math.hypot(x - 40, y)).toBeCloseTo(10, 9);
    const notched = await only(drawing(...lwpolyline([[0, 0], [40, 0, -0.5], [40, 40], [0, 40]]))); // prettier-ignore
    expect(box(notched)).toEqual([0, 40, 0, 40]);
    expect(area(notched.points)).toBeCloseTo(1600 - 279.6, -1);
  });
  it("draws circles, ellipses and arcs within a thousandth of their size", async () => {
    const circle = await only(drawing(0, "CIRCLE", 10, 5, 20, 6, 40, 100));
    expect(circle.closed).toBe(true);
    const error = Math.max(
      ...circle.points.map(([x, y], i) => {
        const [nx, ny] = circle.points[(i + 1) % circle.points.length]!;
        return Math.abs(Math.hypot((x + nx) / 2 - 5, (y + ny) / 2 - 6) - 100);
      }),
    );
    expect(error).toBeLessThan(0.2);
    const ellipse = await only(drawing(0, "ELLIPSE", 10, 0, 20, 0, 11, 0, 21, 50, 40, 0.4, 41, 0, 42, 2 * Math.PI));
    expect(box(ellipse)).toEqual([-20, 20, -50, 50]);
    expect(area(ellipse.points)).toBeCloseTo(Math.PI * 50 * 20, -2);
    const half = await only(drawing(...arc(0, 0, 10, 270, 90)));
    expect([box(half), half.closed]).toEqual([[0, 10, -10, 10], false]);
  });
  it("draws rational splines: nine control points are a circle", async () => {
    const weight = Math.SQRT1_2,
      at = [[1, 0], [1, 1], [0, 1], [-1, 1], [-1, 0], [-1, -1], [0, -1], [1, -1], [1, 0]]; // prettier-ignore
    const knots = [0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4].flatMap((knot) => [40, knot]);
    const controls = at.flatMap(([x = 0, y = 0]) => [10, 7 * x, 20, 7 * y]),
      weights = at.flatMap((_, i) => [41, i % 2 ? weight : 1]);
    const spline = await only(drawing(0, "SPLINE", 70, 4, 71, 2, 72, 12, 73, 9, ...knots, ...weights, ...controls));
    for (const [x, y] of spline.points) expect(Math.hypot(x, y)).toBeCloseTo(7, 9);
    expect([spline.closed, box(spline)]).toEqual([true, [-7, 7, -7, 7]]);
  });
  it("joins lines and arcs end to end, whichever way they run", async () => {
    const pieces = [
      ...line([40, 10], [0, 10]),
      ...line([0, -10], [40, -10]),
      ...arc(40, 0, 10, -90, 90),
      ...arc(0, 0, 10, 90, 270),
    ];
    const slot = await only(drawing(...pieces));
    expect([slot.closed, box(slot)]).toEqual([true, [-10, 50, -10, 10]]);
    const triangle = await only(drawing(...line([0, 0], [10, 0]), ...line([5, 8], [10, 0]), ...line([5, 8], [0, 0])));
    expect(rounded(triangle.points)).toHaveLength(3);
  });
  it("finds loops beyond places where more than two lines meet, and leaves polylines that meet there apart", async () => {
    const with_rib = [line([0, 0], [10, 0]), line([10, 0], [10, 8]), line([10, 8], [0, 8]), line([0, 8], [0, 0])];
    const {shapes} = await found(drawing(...with_rib.flat(), ...line([0, 0], [10, 8])));
    expect(shapes.filter(({closed}) => closed).map(box)).toEqual([[0, 10, 0, 8]]);
    const three = [1, 2, 3].flatMap((y) => lwpolyline([[0, 0], [5, y], [10, 0]], false)); // prettier-ignore
    expect((await found(drawing(...three))).shapes.filter(({closed}) => !closed)).toHaveLength(3);
  });
  it("keeps the contour of a flat pattern whole where fold lines meet it, whatever the order", async () => {
    const corners: Point[] = [
      ...([[19, 16], [20, 17], [150, 17], [151, 16], [150, 15], [150, 0], [170, 0], [170, 15], [169, 16]] as Point[]), // prettier-ignore
      ...([[170, 17], [170, 104], [0, 104], [0, 17], [1, 16], [0, 15], [0, 0], [20, 0], [20, 15]] as Point[]), // prettier-ignore
    ];
    const cuts = corners.map((corner, i) => line(corner, corners[(i + 1) % corners.length]!)),
      folds = [line([1, 16], [19, 16]), line([151, 16], [169, 16])],
      lines = [...folds, ...cuts];
    for (const order of [lines, lines.toReversed(), [...lines.slice(7), ...lines.slice(0, 7)]]) {
      const {shapes} = await found(drawing(...order.flat()));
      expect([shapes[0]!.closed, box(shapes[0]!)]).toEqual([true, [0, 170, 0, 104]]);
      expect(shapes[0]!.points).toHaveLength(corners.length);
    }
  });
  it("places blocks: base point, scale, rotation, rows, blocks in blocks, mirrored ones", async () => {
    const block = (name: string, x: number, y: number, ...entities: Groups): Groups => [
      ...[0, "BLOCK", 2, name, 10, x, 20, y, 30, 0, ...entities, 0, "ENDBLK"],
    ];
    const blocks = section(
      "BLOCKS",
      ...block("plate", 1, 1, ...rectangle(1, 1, 4, 2)),
      ...block("outer", 0, 0, 0, "INSERT", 2, "plate", 10, 10, 20, 0, 50, 90),
    );
    const with_insert = (...insert: Groups) => file(...blocks, ...section("ENTITIES", 0, "INSERT", ...insert));
    expect(box(await only(with_insert(2, "plate", 10, 100, 20, 50)))).toEqual([100, 104, 50, 52]);
    expect(box(await only(with_insert(2, "plate", 10, 0, 20, 0, 41, 2, 42, 3, 50, 90)))).toEqual([-6, 0, 0, 8]);
    expect(box(await only(with_insert(2, "outer", 10, 0, 20, 5)))).toEqual([8, 10, 5, 9]);
    expect(box(await only(with_insert(2, "plate", 10, 1, 20, 0, 230, -1)))).toEqual([-5, -1, 0, 2]);
    const array = await found(with_insert(2, "plate", 10, 0, 20, 0, 70, 3, 71, 2, 44, 10, 45, 20));
    expect(array.shapes.map(box)).toContainEqual([20, 24, 20, 22]);
    expect(array.shapes).toHaveLength(6);
  });
  it("knows the file's unit", async () => {
    const inches = file(...section("HEADER", 9, "$INSUNITS", 70, 1), ...section("ENTITIES", ...rectangle(0, 0, 4, 2)));
    const {unit_mm, shapes} = await found(inches);
    expect(unit_factor(unit_mm, "mm")).toBe(25.4);
    for (const name of ["in", "Inches", '"', "in.", "英寸"]) expect(unit_factor(unit_mm, name), name).toBe(1);
    for (const name of ["MM", "millimeter", "millimetres"]) expect(unit_factor(unit_mm, name), name).toBe(25.4);
    expect(unit_factor(unit_mm, "furlong")).toBe(1);
    expect(body_of(shapes[0]!, unit_factor(unit_mm, "cm"), 10)[2]).toEqual([10.16, 5.08]);
  });
  it("leaves out what is hidden or on paper only", async () => {
    const hidden = [...rectangle(0, 0, 900, 800), 60, 1, ...rectangle(0, 0, 700, 600), 67, 1];
    expect(box(await only(drawing(...hidden, ...rectangle(0, 0, 4, 2))))).toEqual([0, 4, 0, 2]);
  });
});

describe("SVG", () => {
  const read = (inside: string, attributes?: string) => found(svg(inside, attributes), "part.svg");
  const one = (inside: string, attributes?: string) => only(svg(inside, attributes), "part.svg");

  it("gives the corners of straight paths, y up", async () => {
    const shape = await one('<path d="M10 20h30v-10L10,10z"/>');
    expect(rounded(shape.points)).toEqual([
      [10, -20],
      [40, -20],
      [40, -10],
      [10, -10],
    ]);
    expect(shape.closed).toBe(true);
    const relative = await one('<path d="m1e1,0 5,5 -5.5.5"/>');
    expect([rounded(relative.points)[2], relative.closed]).toEqual([[9.5, -5.5], false]);
  });
  it("applies transforms of nested groups, inner frames and uses", async () => {
    const plate = '<rect id="plate" x="1" y="2" width="4" height="2"/>';
    expect(box(await one(`<g transform="translate(10 0)"><g transform="scale(2)">${plate}</g></g>`))).toEqual([
      12, 20, -8, -4,
    ]);
    expect(box(await one(`<g transform="rotate(90)"><g transform="translate(1,1)">${plate}</g></g>`))).toEqual([
      -5, -3, -6, -2,
    ]);
    expect(box(await one(`<svg x="100" width="50" height="50" viewBox="0 0 10 10">${plate}</svg>`))).toEqual([
      105, 125, -20, -10,
    ]);
    expect(box(await one(`<defs>${plate}</defs><use xlink:href="#plate" x="3" transform="scale(10 1)"/>`))).toEqual([
      40, 80, -4, -2,
    ]);
  });
  it("draws béziers, arcs and round corners within a thousandth of their size", async () => {
    const round = await one('<rect width="40" height="20" rx="10"/>');
    expect(area(round.points)).toBeCloseTo(40 * 20 - (4 - Math.PI) * 100, -1);
    expect(box(round)).toEqual([0, 40, -20, 0]);
    const circle = await one('<circle cx="3" cy="4" r="50" transform="scale(2 1)"/>');
    expect(box(circle)).toEqual([-94, 106, -54, 46]);
    const bezier = await one('<path d="M0 0C0 40 60 40 60 0S120 -40 120 0z"/>');
    expect(box(bezier)).toEqual([0, 120, -30, 30]);
    expect(box(await one('<path d="M0 0A30 20 0 0 1 60 0Z"/>'))).toEqual([0, 60, 0, 20]);
  });
  it("takes every part of a path, and what is drawn only", async () => {
    const ring = await read('<path d="M0 0h40v40h-40zM10 10v20h20v-20z"/>');
    expect(ring.shapes.map(box)).toEqual([
      [0, 40, -40, 0],
      [10, 30, -30, -10],
    ]);
    const hidden =
      '<clipPath><rect width="9" height="9"/></clipPath><g display="none"><rect width="8" height="8"/></g>' +
      '<rect style="fill:red;display:none" width="7" height="7"/>';
    expect(box(await one(`${hidden}<polygon points="0,0 4,0 4,2"/>`))).toEqual([0, 4, -2, 0]);
  });
  it("knows millimetres and inches", async () => {
    const of = async (attributes: string) => (await read('<rect width="4" height="2"/>', attributes)).unit_mm;
    expect(await of('width="210mm" height="297mm" viewBox="0 0 2100 2970"')).toBeCloseTo(0.1);
    expect(await of('width="8.5in" viewBox="0 0 850 1100"')).toBeCloseTo(0.254);
    expect(await of('width="100mm"')).toBeCloseTo(25.4 / 96);
    expect(await of('width="100" viewBox="0 0 10 10"')).toBeNull();
  });
});

describe("the choice of a shape", () => {
  it("puts the frame of the sheet last, and its border, and open chains after parts", async () => {
    const sheet = [...rectangle(0, 0, 420, 297), ...rectangle(20, 10, 390, 277)],
      part = [...rectangle(100, 100, 80, 50), 0, "CIRCLE", 10, 120, 20, 120, 40, 5];
    const chain = [...line([200, 20], [300, 20]), ...line([300, 20], [300, 90])];
    const {shapes} = await found(drawing(...sheet, ...chain, ...part));
    expect(
      shapes.map(({width, height, frame, closed}) => [Math.round(width), Math.round(height), frame, closed]),
    ).toEqual([
      [80, 50, false, true],
      [10, 10, false, true],
      [100, 70, false, false],
      [420, 297, true, true],
      [390, 277, true, true],
    ]);
  });
  it("takes a plate with holes for a part, and the edge of an SVG's sheet for a frame", async () => {
    const plate = await found(drawing(...rectangle(0, 0, 80, 20), 0, "CIRCLE", 10, 10, 20, 10, 40, 3));
    expect(plate.shapes.map(({frame}) => frame)).toEqual([false, false]);
    const page = svg(
      '<rect x="5" y="5" width="990" height="490"/><polygon points="100,100 300,100 200,200"/>',
      'viewBox="0 0 1000 500"',
    );
    expect((await found(page, "a.svg")).shapes.map(({frame, width}) => [frame, width])).toEqual([
      [false, 200],
      [true, 990],
    ]);
    expect((await only(drawing(...rectangle(0, 0, 297, 210)))).frame).toBe(false);
  });
  it("shows what is drawn twice once", async () => {
    expect((await found(drawing(...rectangle(0, 0, 8, 2), ...rectangle(0, 0, 8, 2)))).shapes).toHaveLength(1);
  });
});

describe("the body", () => {
  const shape = async (x: number, y: number) => only(drawing(...rectangle(x, y, 80, 20)));
  it("is moved to its origin and sized when far off", async () => {
    expect(body_of(await shape(0, 0), 1, 100)).toEqual([
      [0, 0],
      [80, 0],
      [80, 20],
      [0, 20],
    ]);
    expect(body_of(await shape(9000, 0), 1, 100)).toEqual([
      [-40, -10],
      [40, -10],
      [40, 10],
      [-40, 10],
    ]);
    expect(body_of(await shape(0, 0), 1, 8000)[1]).toEqual([8000, 0]);
  });
  it("has no more corners than a body may have, and keeps its form", () => {
    const wave = Array.from({length: 3000}, (_, i): Point => {
      const angle = (2 * Math.PI * i) / 3000,
        r = 100 + 10 * Math.sin(5 * angle);
      return [r * Math.cos(angle), r * Math.sin(angle)];
    });
    const corners = simplified(wave);
    expect(corners.length).toBeLessThanOrEqual(200);
    expect(Math.abs(area(corners) / area(wave) - 1)).toBeLessThan(0.002);
  });
});

describe("files that are no use", () => {
  it("are refused with the reason", async () => {
    expect(await refusal("nonsense")).toBe("unreadable");
    expect(await refusal("")).toBe("unreadable");
    expect(await refusal("AutoCAD Binary DXF\r\n\x1a\0")).toBe("binary");
    expect(await refusal(drawing(0, "TEXT", 1, "a"))).toBe("none");
    expect(await refusal(drawing(...line([0, 0], [1, 0])))).toBe("none");
    expect(await refusal("<svg", "a.svg")).toBe("unreadable");
    expect(await refusal("<html><body/></html>", "a.svg")).toBe("unreadable");
    expect(await refusal(svg("<text>hello</text>"), "a.svg")).toBe("none");
    expect(await refusal(svg('<path d="nonsense"/><rect width="-4" height="1e999"/>'), "a.svg")).toBe("none");
  });
  it("are refused when their numbers are none", async () => {
    expect(await refusal(drawing(...lwpolyline([[NaN, 0], [1, NaN], [2, 2]])))).toBe("none"); // prettier-ignore
    expect(await refusal(drawing(0, "CIRCLE", 10, "x", 20, 0, 40, "Infinity"))).toBe("none");
    expect(await refusal(drawing(0, "CIRCLE"))).toBe("none");
    expect(await refusal(drawing(0, "SPLINE", 71, 3, 40, 1, 40, 0, 10, 1, 20, 1))).toBe("none");
    expect(await refusal(drawing(...rectangle(0, 0, 1e300, 1e300)))).toBe("none");
  });
  it("are refused when they never end", async () => {
    const use = '<g id="a"><use href="#a"/><use href="#a"/></g>';
    expect(await refusal(svg(use), "a.svg")).toBe("huge");
    expect(await refusal(svg(`${"<g>".repeat(500)}${"</g>".repeat(500)}`), "a.svg")).toBe("huge");
    const doubled = Array.from({length: 30}, (_, i) => [
      ...[0, "BLOCK", 2, `b${i}`, 10, 0, 20, 0, ...(i ? [] : rectangle(0, 0, 4, 2))],
      ...(i ? [0, "INSERT", 2, `b${i - 1}`, 0, "INSERT", 2, `b${i - 1}`, 10, 5] : []),
      ...[0, "ENDBLK"],
    ]).flat();
    const inserted = (blocks: Groups, ...insert: Groups) =>
      file(...section("BLOCKS", ...blocks), ...section("ENTITIES", 0, "INSERT", ...insert));
    expect(await refusal(inserted(doubled, 2, "b15"))).toBe("huge");
    expect(await refusal(inserted(doubled, 2, "b29"))).toBe("huge");
    const itself = [0, "BLOCK", 2, "b", 10, 0, 20, 0, 0, "INSERT", 2, "b", 0, "ENDBLK"];
    expect(await refusal(inserted(itself, 2, "b"))).toBe("huge");
    const empty = [0, "BLOCK", 2, "b", 10, 0, 20, 0, 0, "ENDBLK"];
    expect(await refusal(inserted(empty, 2, "b", 70, 1e9, 71, 1e9))).toBe("huge");
  });
  it("are refused, or read, in a moment when they are large", async () => {
    const circles = (n: number) => of_many(Array.from({length: n}, (_, i) => [0, "CIRCLE", 10, i, 20, 0, 40, 9]));
    const star = of_many(Array.from({length: 40_000}, (_, i) => line([0, 0], [i + 1, 1])));
    const zigzag = `<path d="M0 0${Array.from({length: 110_000}, (_, i) => `L${i % 2} ${i}`).join("")}z"/>`;
    const start = performance.now();
    expect(await refusal(circles(100_000))).toBe("huge");
    expect(await refusal(star)).toBe("none");
    expect(await refusal(svg(zigzag), "a.svg")).toBe("huge");
    const long = await found(svg(zigzag.replace(/(L[^L]*){50000}/, "")), "a.svg");
    expect(simplified(long.shapes[0]!.points).length).toBeLessThanOrEqual(200);
    expect(performance.now() - start).toBeLessThan(60_000); // seconds, not minutes, on any machine
  });
});

it("the program makes the same outlines of all these files, and refuses the same ones in the same words", () => {
  const folder = mkdtempSync(join(tmpdir(), "linkwright-")),
    task = join(folder, "task.json"),
    poses = [0, 30, 60, 90].map((x, i) => ({x, y: (x * x) / 90, theta_deg: 7 * i * i})); // 90 √2 across
  writeFileSync(
    task,
    JSON.stringify({linkwright: 1, length_unit: "mm", task: {kind: "motion", mechanism: "four_bar", poses}}),
  );
  try {
    expect(files_read.size).toBeGreaterThan(50);
    let k = 0;
    for (const [file, read] of files_read) {
      const [name, text] = [join(folder, `part_${++k}.${file.slice(0, 3)}`), file.slice(4)];
      writeFileSync(name, text);
      const outline = (shape: number) =>
        spawnSync(program, ["outline", name, task, "--shape", String(shape)], {encoding: "utf8"});
      if (typeof read === "string") {
        const {status, stderr} = outline(1);
        expect([status, stderr]).toEqual([
          2,
          expect.stringContaining(en[`drawing.outline_${read}`].split(/” |\./)[1]!),
        ]);
      } else
        read.shapes.forEach((shape, i) => {
          const {stdout} = outline(i + 1),
            {outline: corners} = (JSON.parse(stdout) as {view: {outline: Point[]}}).view,
            expected = body_of(shape, unit_factor(read.unit_mm, "mm"), 0.3 * 90 * Math.SQRT2);
          expect(corners, text).toHaveLength(expected.length);
          for (const [j, [x, y]] of corners.entries())
            expect(Math.hypot(x - expected[j]![0], y - expected[j]![1])).toBeLessThan(1e-6);
        });
    }
  } finally {
    rmSync(folder, {recursive: true});
  }
}, 120_000);

it("what the program exports comes back: the bars in each position, true to size", async () => {
  const folder = mkdtempSync(join(tmpdir(), "linkwright-"));
  try {
    const [result, dxf, picture] = ["result.json", "out.dxf", "out.svg"].map((name) => join(folder, name));
    execFileSync(program, ["solve", join(root, "examples/landing_gear.json"), "-o", result!], {stdio: "ignore"});
    execFileSync(program, ["export", result!, "--format", "dxf", "-o", dxf!]);
    execFileSync(program, ["export", result!, "--format", "svg", "-o", picture!]);
    type Dyad = {center_point: Point; circle_point: Point};
    const [best] = (JSON.parse(readFileSync(result!, "utf8")) as {linkages: {input: Dyad; output: Dyad}[]}).linkages,
      {shapes, unit_mm} = await found(readFileSync(dxf!, "utf8"));
    expect(unit_mm).toBe(1);
    const bars = shapes.filter(({points, closed}) => points.length === 4 && !closed).map(({points}) => rounded(points)),
      [fixed_input, fixed_output] = rounded([best!.input.center_point, best!.output.center_point]);
    expect(bars).toHaveLength(3); // the first is drawn in full
    for (const [first, , , last] of bars) expect([first, last]).toEqual([fixed_input, fixed_output]);
    const shown = await found(readFileSync(picture!, "utf8"), "out.svg");
    expect(shown.shapes[0]!.frame).toBe(false);
  } finally {
    rmSync(folder, {recursive: true});
  }
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
