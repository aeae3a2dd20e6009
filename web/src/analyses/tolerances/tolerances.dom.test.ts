// Tolerances: the row that gives them, and what they open.
import {beforeEach, expect, test} from "vitest";
import {
  click,
  field,
  is_there,
  open_settled,
  press,
  reload,
  type_into,
  until,
  until_settled,
  workbench,
} from "../../../tests/page/support";
import {example, solve} from "../../../tests/program";
const given = () => workbench.problem.tolerances ?? null;

beforeEach(open_settled);

test("are given in a row, colour the map, and stay", async () => {
  expect(is_there("req.row.max_tolerance_error")).toBe(false);
  await click("tolerance.add");
  expect(given()).toEqual({length: 0.5});
  await type_into("tolerance.all", "0.4");
  await click("tolerance.each");
  await type_into("tolerance.coupler", "0.1");
  expect(given()).toEqual({length: {input: 0.4, coupler: 0.1, output: 0.4, ground_pivots: 0.4, point: 0.4}});
  expect(field("tolerance.all").placeholder).toBe("differ");
  await press("Control+z");
  expect(given()).toEqual({length: 0.4});

  await click("region.menu");
  expect(is_there("region.color.yield")).toBe(false);
  await click("region.color.tolerance_error");
  await until(() => workbench.map?.property === "tolerance_error");
  await until_settled();
  const [first] = solve({...example("tailgate"), tolerances: {length: 0.4}}).linkages;
  expect(workbench.hand!.tolerance!.error).toBeCloseTo(first.tolerance.error, 6);

  await reload();
  expect(given()).toEqual({length: 0.4});
  await click("tolerance.remove");
  expect(given()).toBeNull();
  expect(workbench.coloring).toBe("type");
});
