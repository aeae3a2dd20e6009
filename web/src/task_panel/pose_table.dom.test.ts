// The table of positions.
import {beforeEach, expect, test} from "vitest";
import {
  click,
  faults,
  focus,
  focused,
  get,
  is_there,
  open_settled,
  paste_into,
  poses_of_page,
  press,
  text,
  type_into,
  until,
  until_settled,
  value_of,
  workbench,
} from "../../tests/page/support";
beforeEach(open_settled);

test("takes arithmetic, units and steps; Enter goes down; undo goes back", async () => {
  const before = poses_of_page();
  await type_into("task.x.3", "=-440/2+5");
  expect(poses_of_page()[2]!.x).toBe(-215);
  expect(focused()).toBe("task.x.4");
  await type_into("task.theta_deg.2", "-0,5rad");
  expect(poses_of_page()[1]!.theta_deg).toBeCloseTo((-0.5 * 180) / Math.PI, 12);
  await type_into("task.y.2", "80 mm", "Tab");
  expect(poses_of_page()[1]!.y).toBe(80);
  for (let steps = 0; steps < 3; ++steps) await press("Control+z");
  expect(poses_of_page()).toEqual(before);

  await focus("task.x.4");
  for (const key of ["ArrowUp", "Shift+ArrowUp", "Alt+ArrowDown"]) await press(key);
  expect(poses_of_page()[3]!.x).toBe(-209.1);
  await press("Control+z"); // steps within a second are one
  expect(poses_of_page()).toEqual(before);
});

test("says what is wrong and keeps the last good value", async () => {
  const before = poses_of_page();
  await type_into("task.y.2", "12elve", "Tab"); // a letter alone is handed on to the page
  expect(get("task.y.2").getAttribute("aria-invalid")).toBe("true");
  expect(faults()).toContain(
    "must be a number between −1 000 000 000 and 1 000 000 000. The last valid value is kept.",
  );
  expect(poses_of_page()).toEqual(before);
  await focus("task.y.2");
  await press("Escape");
  expect(is_there("task.fault")).toBe(false);
  expect(value_of("task.y.2")).toBe("75");
  await type_into("task.y.2", "1e10", "Tab");
  expect(is_there("task.fault")).toBe(true);
  await type_into("task.y.2", "75", "Tab");
  expect(is_there("task.fault")).toBe(false);
});

test("marks what the engine refuses, here the same pose twice", async () => {
  const before = poses_of_page();
  await paste_into("task.x.2", "0\t0\t0");
  await until(() => is_there("task.fault"));
  expect(faults()).toContain("Position 2 is the same as an earlier one.");
  expect(get("task.x.2").getAttribute("aria-invalid")).toBe("true");
  expect(poses_of_page()).toEqual(before);
});

test("takes a pasted block as one step", async () => {
  const before = poses_of_page();
  await paste_into("task.x.1", "x\ty\tθ\r\n0\t0\t0\r\n-120,5\t80\t-25\r\n-210\t225,25\t-50\r\n-220\t440\t-80\r\n");
  expect(poses_of_page()).toEqual([
    {x: 0, y: 0, theta_deg: 0},
    {x: -120.5, y: 80, theta_deg: -25},
    {x: -210, y: 225.25, theta_deg: -50},
    {x: -220, y: 440, theta_deg: -80},
  ]);
  await press("Control+z");
  expect(poses_of_page()).toEqual(before);
  await paste_into("task.y.3", "221; -53\n451; -83");
  expect(poses_of_page().slice(2)).toEqual([
    {x: -220, y: 221, theta_deg: -53},
    {x: -220, y: 451, theta_deg: -83},
  ]);
  await press("Control+z");
  await paste_into("task.x.1", "1\t2\t3\n4\tfive\t6");
  expect(faults()).toBe("Row 2, column 2: “five” is not a number. Nothing was pasted.");
  expect(poses_of_page()).toEqual(before);
});

test("reorders by keys, doubles, adds and removes", async () => {
  const before = poses_of_page(),
    [a, b, c, d] = before;
  await focus("task.reorder.1");
  await press("Alt+ArrowDown");
  expect(poses_of_page()).toEqual([b, a, c, d]);
  expect(focused()).toBe("task.reorder.2");
  await press("Control+z");
  expect(poses_of_page()).toEqual(before);

  await click("task.add");
  expect(poses_of_page()[4]).toEqual({x: -220, y: 680, theta_deg: -112});
  await click("task.add");
  expect(text("task.missing")).toContain("6 positions");
  for (const row of [6, 5]) {
    await click(`task.menu.${row}`);
    await click("task.remove");
  }
  expect(poses_of_page()).toEqual(before);
});

test("another reference position gives the same linkage, seen from elsewhere", async () => {
  const [a, , , d] = poses_of_page();
  await click("task.menu.3");
  await click("task.make_reference");
  const moved = poses_of_page();
  expect(moved[2]).toEqual({x: 0, y: 0, theta_deg: 0});
  expect(Math.hypot(moved[3]!.x - moved[0]!.x, moved[3]!.y - moved[0]!.y)).toBeCloseTo(
    Math.hypot(d!.x - a!.x, d!.y - a!.y),
    9,
  );
  await until_settled();
  const lengths = workbench.hand!.lengths!;
  workbench.undo();
  await until_settled();
  const original = workbench.hand!.lengths!;
  // Found again by its place, from a map whose own linkage may just have been followed.
  for (const link of ["ground", "input", "coupler", "output"] as const)
    expect(lengths[link] / original[link]).toBeCloseTo(1, 6);
});

test("holds directions and curvatures of travel", async () => {
  const before = poses_of_page();
  await click("task.menu.2");
  await click("task.tangent");
  expect(text("task.pattern")).toBe("P-PP-P-P");
  await type_into("task.direction_deg.2", "120");
  const {x, y} = poses_of_page()[1]!.derivatives![0]!;
  expect(x).toBeCloseTo(Math.cos((120 * Math.PI) / 180), 12);
  expect(y).toBeCloseTo(Math.sin((120 * Math.PI) / 180), 12);
  await click("task.menu.2");
  await click("task.curvature");
  expect(text("task.pattern")).toBe("P-PPP-P-P");
  await click("task.menu.2");
  await click("task.next_derivative");
  await type_into("task.curvature.2.3", "0.002");
  await type_into("task.direction_deg.2", "60"); // keeps what stands below it
  expect(value_of("task.curvature.2.3")).toBe("0.002");
  expect(text("task.pattern")).toBe("P-PPPP-P-P");
  await click("task.remove_derivative.2.2");
  expect(text("task.pattern")).toBe("P-PP-P-P");
  await click("task.remove_derivative.2.1");
  expect(poses_of_page()).toEqual(before);
});

test("what the engine has refused stands as it was typed until it is taken back", async () => {
  await type_into("task.y.3", "75");
  await type_into("task.theta_deg.3", "-25");
  await until_settled();
  await type_into("task.x.3", "-125"); // now as position 2
  await until(() => is_there("task.fault"));
  expect(value_of("task.x.3")).toBe("-125");
  expect(poses_of_page()[2]!.x).toBe(-220);
  workbench.zoom({input: [0, 0.5], output: [0, 0.5]}); // another answer of the engine
  await until_settled();
  expect(value_of("task.x.3")).toBe("-125");
  expect(is_there("task.fault")).toBe(true);
  await focus("task.x.3");
  await press("Escape");
  expect(value_of("task.x.3")).toBe("-220");
  expect(is_there("task.fault")).toBe(false);
});

test("Tab goes from number to number, row to row; the row's menu opens by a key and moves the row", async () => {
  const numbers = ["60", "35", "22", "160", "120", "58", "190", "240", "95"];
  await focus("task.x.2");
  for (const [i, number] of numbers.entries())
    await type_into(focused()!, number, i < numbers.length - 1 ? "Tab" : "Enter");
  const typed = [
    {x: 0, y: 0, theta_deg: 0},
    {x: 60, y: 35, theta_deg: 22},
    {x: 160, y: 120, theta_deg: 58},
    {x: 190, y: 240, theta_deg: 95},
  ];
  expect(poses_of_page()).toEqual(typed);
  await focus("task.theta_deg.3");
  await press("Shift+Tab");
  expect(focused()).toBe("task.y.3");

  await press("Shift+F10");
  expect(is_there("task.move_up")).toBe(true);
  await click("task.move_up");
  expect(poses_of_page()).toEqual([typed[0], typed[2], typed[1], typed[3]]);
  expect(focused()).toBe("task.y.3");
});

test("more rows than are taken are refused, and said", async () => {
  const before = poses_of_page(),
    rows = (n: number) => Array.from({length: n}, (_, i) => `${i}\t${i}\t${i}`).join("\n");
  await paste_into("task.x.1", rows(5000));
  expect(faults()).toContain("5 000 rows are more than the 100 that are taken.");
  expect(poses_of_page()).toEqual(before);
  await paste_into("task.x.1", rows(90));
  expect(text("task.pattern")).toBe("P-P-…-P");
});
