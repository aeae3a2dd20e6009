// The numbers of the linkage in hand.
import {beforeEach, expect, test} from "vitest";
import {
  click,
  copied,
  download,
  is_there,
  open_settled,
  text,
  toasts,
  type_into,
  until,
  until_settled,
  until_there,
  workbench,
} from "../../tests/page/support";
import {example, solve} from "../../tests/program";
import type {TauPair} from "../contract/messages";

async function pick(tau: TauPair): Promise<void> {
  workbench.pick(tau);
  await until(() => workbench.picked_linkage?.tau.join() === tau.join());
  await until_settled();
}
const angle = (value: number) => `${value.toFixed(1)}°`;
const point = (of: number[]) => of.map((value) => value.toFixed(1).replace("-", "−")).join(", ");

beforeEach(open_settled);

test("are those of the program", async () => {
  const {linkages} = solve(example("tailgate"));
  for (const found of linkages.slice(0, 4)) {
    await pick([found.input.coordinate, found.output.coordinate]);
    const {lengths} = workbench.hand!;
    for (const link of ["ground", "input", "coupler", "output"] as const) {
      expect(lengths![link] / found.lengths[link]).toBeCloseTo(1, 11);
      expect(text(`num.${link}`)).toBe(`${found.lengths[link].toFixed(2)} mm`);
    }
    expect(text("num.min_task")).toBe(angle(found.min_transmission_angle_deg));
    expect(text("num.ratio")).toBe(found.link_ratio.toFixed(2));
    expect(text("num.sweep")).toBe(`${angle(found.driver_sweep_deg)} ${found.drive === "cw" ? "↻" : "↺"}`);
    expect(text("num.input_center")).toBe(point(found.input.center_point));
    expect(text("num.output_circle")).toBe(point(found.output.circle_point));
    expect(text("num.verdict")).toBe("✓ No defects, verified by simulation");
    expect(is_there("num.verified")).toBe(true);
    if (found.min_transmission_angle_full_turn_deg !== null)
      expect(text("num.min_turn")).toBe(angle(found.min_transmission_angle_full_turn_deg));
    if (found.swapped.min_transmission_angle_deg !== null)
      expect(text("num.swapped")).toContain(`γ ${angle(found.swapped.min_transmission_angle_deg)}`);
  }
});

test("are copied as a row, and saved as DXF", async () => {
  await pick([1.3125, 1.1125]);
  expect(text("num.type")).toBe("Triple rocker, output longest");
  expect(text("num.min_task")).toBe("73.5°");
  await click("num.copy_lengths");
  const row = (await copied()).split("\t").map(Number);
  [65.03, 211.05, 53.92, 255.9].forEach((length, i) => expect(row[i]).toBeCloseTo(length, 2));
  await click("num.copy.input_center");
  expect((await copied()).split("\t").map((value) => Number(value).toFixed(1))).toEqual(["179.0", "348.5"]);

  const {name, bytes} = await download(() => click("num.dxf"));
  expect(name).toMatch(/^tailgate-hinge.*\.dxf$/);
  expect(bytes.toString()).toContain("EOF");
});

test("say which requirement is not met once the old linkage is kept against it", async () => {
  await pick([1.3125, 1.1125]);
  await type_into("req.max_length", "250");
  await until_settled();
  expect(toasts()).toContain("no longer met the requirements; this is the best that does");
  expect(is_there("num.missed")).toBe(false);
  await click("toast.state.keep_old");
  await until_settled();
  expect(text("num.missed")).toBe("Not met: longest link (250 mm at most)");
});

test("say what fails, and so does who takes it away", async () => {
  const {defects, type, input_tau, output_tau, columns} = workbench.map!,
    cell = defects.findIndex((bits, i) => bits === 1 && type[i]! < 8);
  await pick([input_tau[Math.floor(cell / columns)]!, output_tau[cell % columns]!]);
  expect(text("num.verdict")).toBe("✕ Order defect");
  expect(text("num.reason")).toMatch(/Order defect: this linkage reaches the positions as [1-4](-[1-4]){3}\./);
  expect(text("num.min_task")).toBe("–");
  expect(is_there("num.verified")).toBe(false);
  await click("export.title");
  await until_there("export.mind");
  expect(text("export.mind")).toMatch(/^Before you build it: Order defect: this linkage reaches the positions as /);
});
