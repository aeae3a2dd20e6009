import type {SixBarTask} from "../src/kinds/six_bar/task";
import {
  drag,
  expect,
  expect_accessible,
  file_menu,
  keep_screenshot,
  map_pixel,
  middle_of,
  open_workbench,
  played_poses,
  read_state,
  test,
  until_fine,
  until_settled,
  type Pixel,
} from "./support";
import type {Page} from "@playwright/test";

async function open_loader(page: Page): Promise<void> {
  await open_workbench(page);
  await file_menu(page, "file.examples");
  await page.getByTestId("example.wheel_loader").click();
  await until_settled(page);
}
/** The map's hash of what it shows. */
function counts(page: Page): Promise<string> {
  return read_state(
    page,
    ({map}) =>
      `${map!.census.meeting} ${map!.census.defect_free} ${map!.fails.join("").length} ${map!.value.reduce((sum, value) => sum + value, 0)}`,
  );
}
/** A cell that meets everything and is not the one in hand. */
function passing_place(page: Page): Promise<readonly [number, number]> {
  return read_state(page, ({map, picked}) => {
    const cells = [...map!.fails.keys()].filter((i) => map!.fails[i] === 0);
    const place = (i: number) =>
      [(Math.floor(i / map!.columns) + 0.5) / map!.rows, ((i % map!.columns) + 0.5) / map!.columns] as const;
    return place(
      cells.findLast((i) => Math.hypot(place(i)[0] - picked!.place![0], place(i)[1] - picked!.place![1]) > 0.05) ??
        cells[0]!,
    );
  });
}

test("a six-bar is found on its map, driven, and its chain moved", async ({page}) => {
  test.slow();
  await open_loader(page);
  await expect(page.getByTestId("chip.title")).toContainText("six-bars");
  expect(await read_state(page, ({census}) => census!.meeting)).toBeGreaterThan(20);
  expect(await read_state(page, ({task}) => task!.symmetric)).toBe(false);

  // A passing cell.
  const {x, y}: Pixel = await map_pixel(page, await passing_place(page));
  await page.mouse.click(x, y);
  await expect(page.getByTestId("region.card")).toContainText("Watt I");
  await page.mouse.move(5, 400);
  await until_settled(page);
  expect(
    await read_state(page, ({hand}) => [hand!.fails, hand!.six_bar!.topology, hand!.six_bar!.lengths.length]),
  ).toEqual([0, "watt_1", 10]);
  await expect(page.getByTestId("num.type")).toHaveText("Watt I");
  await expect(page.getByTestId("num.verified")).toBeVisible();
  await expect(page.getByTestId("drawing.linkage")).toHaveAttribute("data-fails", "false");

  // Its bodies and hinges have names, on the drawing too.
  await expect(page.getByTestId("num.title")).toContainText(/floating link b–d.*c₄ · \w/s);
  await expect(page.getByTestId("drawing.joint_c4")).toContainText("c₄");
  await expect(page.getByTestId("drawing.linkage")).toContainText("guided body");

  // Played, it passes all four positions in order.
  await page.locator("[data-speed='4']").click();
  await page.getByTestId("drive.repeat").click(); // over and over
  await page.getByTestId("drive.repeat").click(); // once
  await read_state(page, (workbench) => void (workbench.stage = 0));
  expect(await played_poses(page)).toEqual([1, 2, 3]); // from the first on
  await keep_screenshot(page, "six_bar");

  // Hinge b dragged: the map follows, one undo takes it back.
  await until_fine(page);
  const before = await counts(page),
    handle = page.getByTestId("drawing.chain_b"),
    from = await middle_of(handle);
  await drag(page, from, {x: from.x + 24, y: from.y - 12}, 6, async () => {
    await expect(page.getByTestId("six_bar.reach")).toHaveCount(5);
  });
  await until_settled(page);
  expect(await read_state(page, ({problem}) => (problem.task as SixBarTask).chain!.b)).not.toEqual([288.6, 1029.9]);
  expect(await counts(page)).not.toBe(before);
  await page.keyboard.press("Control+z");
  await until_fine(page);
  expect(await counts(page)).toBe(before);
  expect(await read_state(page, ({problem}) => (problem.task as SixBarTask).chain!.b)).toEqual([288.6, 1029.9]);

  // An end of link 4 slides along its curve, and the map's crosshair with it.
  const tau = await read_state(page, ({picked}) => picked!.tau),
    end = await middle_of(page.getByTestId("drawing.pivot_input_center"));
  await drag(page, end, {x: end.x + 12, y: end.y + 8}, 6);
  const slid = await read_state(page, ({picked}) => picked!.tau);
  expect(slid[0]).not.toBe(tau[0]);
  expect(slid[1]).toBe(tau[1]);
  await page.keyboard.press("Control+z");

  // While something is held, what is left of six-bars shows where it may go.
  const halo = page.getByTestId("drawing.halo");
  for (const name of ["drawing.chain_d", "drawing.disc_4"]) {
    const from = await middle_of(page.getByTestId(name).first());
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await page.mouse.move(from.x + 5, from.y, {steps: 2});
    await expect(halo).toBeVisible();
    const squares = await halo.locator("rect").evaluateAll((all) => all.map((r) => r.getAttribute("data-offset")));
    expect(squares.length).toBeGreaterThan(1); // few places: the requirements of the bucket are tight
    expect(squares.length).toBeLessThan(13 * 13);
    await keep_screenshot(page, `six_bar_halo_${name.slice(-1)}`);
    await page.keyboard.press("Escape");
    await page.mouse.up();
    await expect(halo).toBeHidden();
    await until_settled(page);
  }

  // Other bodies to join are chosen from pictures.
  await page.getByTestId("six_bar.topology").click();
  await expect_accessible(page, "[data-testid='task.title']");
  await page.keyboard.press("Escape");
});
