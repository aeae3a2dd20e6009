// A linkage that one has is opened, driven, changed and taken away; nothing is sought.
import {expect, test} from "vitest";
import {
  begin,
  click,
  download,
  faults,
  file_menu,
  is_there,
  open_files,
  open_settled,
  press,
  reload,
  text,
  toasts,
  type_into,
  until,
  until_there,
  value_of,
  workbench,
} from "../../../tests/page/support";
import {examples, run_program} from "../../../tests/program";
import {readFileSync} from "node:fs";
import {join} from "node:path";

const crank_rocker = readFileSync(join(examples, "linkages/crank_rocker.json"));
const until_driven = () => until(() => workbench.is_current && workbench.hand?.drive && workbench.questions.settled());
async function open_linkage(name: string, content: string | Buffer): Promise<void> {
  await open_settled();
  await open_files(name, content);
  await until_driven();
}
const rad_per_s = (told: string) => Number(/(−?[\d.]+) rad\/s/.exec(told)![1]!.replace("−", "-"));

test("a file with lengths is opened as a linkage, and told with speeds", async () => {
  await open_linkage("crank_rocker.json", crank_rocker);
  expect(toasts()).toContain("“crank_rocker.json” opened.");
  expect(text("task.kind")).toContain("Linkage · four-bar");
  expect(text("num.type")).toContain("Crank-rocker");
  expect(is_there("req.title")).toBe(false);
  expect(is_there("num.best")).toBe(false);
  const {full_turn, states, width} = workbench.hand!.drive!;
  expect(full_turn).toBe(true);

  await type_into("linkage.rpm", "120");
  await until_driven();
  expect(text("linkage.rate.input")).toContain("12.57 rad/s");
  expect(text("linkage.rate.input")).toContain("0 rad/s²");
  expect(text("linkage.rate.point")).toContain("/s²");
  // The output's is the velocity ratio of the drive's table times the input's.
  const rows = [...Array(states.length / width).keys()].map((row) => row * width),
    here = rows.find((row) => Math.abs(states[row]! - workbench.angle) < 1e-9)!;
  expect(rad_per_s(text("linkage.rate.output"))).toBeCloseTo(4 * Math.PI * states[here + 11]!, 2);

  await click("drive.play");
  const before = workbench.angle;
  await until(() => workbench.angle !== before);
  await click("drive.play");
});

test("its numbers are typed, what does not close is refused, and it is saved as the program reads it", async () => {
  const coupler = () => workbench.hand!.lengths!.coupler;
  await open_linkage("crank_rocker.json", crank_rocker);
  await type_into("linkage.lengths.coupler", "3.2");
  await until_driven();
  expect(coupler()).toBeCloseTo(3.2, 9);
  await type_into("linkage.lengths.coupler", "30");
  await until_there("task.fault");
  expect(faults()).toContain("do not close");
  expect(coupler()).toBeCloseTo(3.2, 9);
  await press("Escape");
  const {bytes} = await download(() => file_menu("file.save"));
  expect(run_program("analyze", bytes.toString())).toMatch(/crank-rocker/i);
  await press("Control+z");
  await until_driven();
  expect(coupler()).toBeCloseTo(3, 9);
});

test("planar linkages by their pivots are exported as machines and drawings", async () => {
  const pivots = {
    input_fixed: [0, 0],
    input_moving: [-20, 35],
    output_moving: [60, 85],
    output_fixed: [100, 0],
    point: [25, 110],
  };
  await open_linkage("p.json", JSON.stringify({length_unit: "mm", pivots}));
  await expect_exports();
});

test("spherical linkages are opened, too, and exported", async () => {
  const angles_deg = {ground: 80, input: 30, coupler: 70, output: 60};
  await open_linkage("s.json", JSON.stringify({mechanism: "spherical_four_bar", angles_deg}));
  await expect_exports();
});
async function expect_exports(): Promise<void> {
  await click("export.title");
  await until_there("export.urdf");
  for (const format of ["urdf", "mjcf", "json", "svg"])
    expect((await download(() => click(`export.${format}`))).name).toMatch(/\.(urdf|xml|json|svg)$/);
  expect(text("export.step")).toContain("linkwright export");
  await press("Escape");
}

test("a new task can be a linkage, and a reload keeps it", async () => {
  await open_settled();
  await begin("linkage");
  await until_driven();
  expect(workbench.problem.task.kind).toBe("linkage");
  await type_into("linkage.pivots.point.x", "40");
  await reload();
  await until_driven();
  expect(value_of("linkage.pivots.point.x")).toBe("40");
  expect(text("linkage.rate.point")).toContain("mm/s²");
});
