// Walk-through 18: what is taken away, as far as it is no picture.
import {beforeEach, expect, test} from "vitest";
import {
  click,
  download,
  field,
  get,
  is_there,
  open_settled,
  press,
  text,
  type_into,
  until,
  until_there,
  workbench,
} from "../../tests/page/support";
import {analyze, solve} from "../../tests/program";
import {execFileSync} from "node:child_process";
import {mkdtempSync, rmSync, writeFileSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";

const exported = (format: string) => download(() => click(`export.${format}`));
async function open_exports(): Promise<void> {
  await click("export.title");
  await until_there("export.dialog");
}
function in_file<T>(name: string, bytes: Buffer, use: (path: string) => T): T {
  const folder = mkdtempSync(join(tmpdir(), "linkwright-export-"));
  try {
    writeFileSync(join(folder, name), bytes);
    return use(join(folder, name));
  } finally {
    rmSync(folder, {recursive: true});
  }
}
const read_dxf = `
import ezdxf, json, sys
drawing = ezdxf.readfile(sys.argv[1])
circles = {}
for circle in drawing.modelspace().query("CIRCLE"):
    circles.setdefault(circle.dxf.layer, []).append([circle.dxf.center.x, circle.dxf.center.y])
print(json.dumps({"layers": sorted(l.dxf.name for l in drawing.layers), "units": drawing.units, "circles": circles, "errors": len(drawing.audit().errors)}))
`;
const drawing_in = ({name, bytes}: {name: string; bytes: Buffer}) =>
  in_file(name, bytes, (path) =>
    JSON.parse(execFileSync("/usr/bin/python3", ["-c", read_dxf, path], {encoding: "utf8"})),
  );
const links = ["ground", "input", "coupler", "output"] as const;

beforeEach(open_settled);

test("DXF: layers, millimetres, and pins as far apart as the numbers say", async () => {
  await open_exports();
  const file = await exported("dxf"),
    {lengths, type} = workbench.picked_linkage!;
  expect(file.name).toBe(`tailgate-hinge-${type}.dxf`);
  expect(text("export.status")).toContain(file.name);
  const drawing = drawing_in(file);
  expect(drawing.errors).toBe(0);
  expect(drawing.units).toBe(4); // mm
  expect(drawing.layers).toEqual(
    expect.arrayContaining(["COUPLER", "COUPLER_CURVE", "GROUND", "INPUT", "OUTPUT", "POSITIONS"]),
  );
  for (const link of links) {
    const [[x0, y0], [x1, y1]] = drawing.circles[link.toUpperCase()];
    expect(Math.abs(Math.hypot(x1 - x0, y1 - y0) - lengths![link]), link).toBeLessThan(1e-6);
  }
});

test("plates and pins: what collides is told, sizes are given, and files come for printing and cutting", async () => {
  await open_exports();
  await until(() => text("export.plates.report").includes("collide"));
  await click(get("export.plates.fold").querySelector("summary")!);
  expect(is_there("export.plates.radius")).toBe(false);
  expect(field("export.plates.clearance").placeholder).toMatch(/^[\d.]+$/);
  const narrow = await exported("3mf");
  await type_into("export.plates.clearance", "0.4");
  const wide = await exported("3mf");
  expect(wide.name).toMatch(/^tailgate-hinge-.*\.3mf$/);
  expect(wide.bytes.subarray(0, 2).toString()).toBe("PK");
  expect(wide.bytes.equals(narrow.bytes)).toBe(false);
  const {bytes} = await exported("stl");
  expect(bytes.length).toBe(84 + 50 * bytes.readUInt32LE(80));
  const plates = await exported("plates");
  expect(plates.name).toMatch(/-plates\.dxf$/);
  expect(drawing_in(plates).errors).toBe(0);
  await type_into("export.plates.pin", "5000");
  await until(() => text("export.plates.report").includes("beside this linkage it is a length from"));
  expect(field("export.stl").disabled).toBe(true);
});

test("SVG is well-formed, CSV begins at position 1 and has a row at each, JSON is read by the program", async () => {
  await open_exports();
  const svg = await exported("svg");
  in_file(svg.name, svg.bytes, (path) => execFileSync("xmllint", ["--noout", "--nonet", path]));
  expect(svg.bytes.toString()).toContain("<svg");

  const csv = (await exported("csv")).bytes.toString().trimEnd().split("\n");
  expect(csv[0]).toMatch(
    /^driver_turn_from_position_1_deg,input_angle_from_x_deg,.*,body_x,body_y,body_theta_deg,.*,position,position_error,orientation_error_deg$/,
  );
  const column = csv[0]!.split(",").indexOf("position"),
    rows = csv.slice(1).map((line) => line.split(","));
  expect(rows.map((row) => row[column]).filter(Boolean)).toEqual(["1", "2", "3", "4"]);
  expect([rows[0]![0], rows[0]![column]]).toEqual(["0", "1"]);
  expect(rows.every((row) => row.length === csv[0]!.split(",").length)).toBe(true);

  const analysis = analyze((await exported("json")).bytes.toString()),
    {lengths, type} = workbench.picked_linkage!;
  expect(analysis.type).toBe(type);
  for (const link of links) expect(analysis.lengths[link]).toBeCloseTo(lengths![link], 9);
  expect(JSON.parse((await exported("result")).bytes.toString()).status).toBe("solved");
  expect(solve(JSON.parse((await exported("problem")).bytes.toString())).status).toBe("solved");
});

test("a pin is exported under its name", async () => {
  await click("pin.add");
  await open_exports();
  await click(document.querySelector("[data-pin='A']")!);
  expect((await exported("dxf")).name).toBe("tailgate-hinge-A.dxf");
  await press("Escape");
  expect(is_there("export.dialog")).toBe(false);
});

test("a dialog that is closed before the linkage is known as plates is not told of it", async () => {
  for (let i = 0; i < 3; ++i) {
    await open_exports();
    await press("Escape");
    expect(is_there("export.dialog")).toBe(false);
    await until(() => !workbench.driver_client!.busy); // its answer comes, and the page complains of nothing
  }
});

test("where the browser has no encoder, films are not offered, and the reason is", async () => {
  expect(globalThis).not.toHaveProperty("VideoEncoder");
  await open_exports();
  for (const kind of ["mp4", "webm"]) {
    await until(() => field(`export.${kind}`).disabled);
    expect(text(`export.${kind}`)).toContain("cannot encode video");
  }
  expect(field("export.gif").disabled).toBe(false);
});
