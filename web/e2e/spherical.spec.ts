// The sphere: a newcomer folds a wing, by hand and on the map, and takes the links away to print them.
import type {Page} from "@playwright/test";
import {readFileSync} from "node:fs";
import type {SphericalTask} from "../src/tasks/spherical/task";
import {
  drag,
  expect,
  expect_accessible,
  file_menu,
  keep_screenshot,
  map_hash,
  middle_of,
  open_workbench,
  read_state,
  test,
  type_into,
  until_mapped,
  until_settled,
} from "./support";

const task = (page: Page) => read_state(page, ({problem}) => problem.task as SphericalTask);
const nose = (page: Page) => page.getByTestId("spherical.stage").getAttribute("data-nose");

async function open_wing(page: Page): Promise<void> {
  await page.addInitScript(() =>
    localStorage.setItem("linkwright.preferences", JSON.stringify({language: "en", theme: "light", toured: true})),
  );
  await open_workbench(page);
  await file_menu(page, "file.examples");
  await page.getByTestId("example.folding_wing").click();
  await expect(page.getByTestId("spherical.stage")).toBeVisible();
  await until_settled(page);
}
test("a newcomer folds the wing: a ring, the map, a linkage without defects, its motion, its links as STL", async ({
  page,
}) => {
  await open_wing(page);
  expect(await read_state(page, ({census}) => census!.meeting)).toBeGreaterThan(0);
  const before = await map_hash(page),
    first = await task(page);
  await page.getByTestId("spherical.mark.3").click();
  const knob = page.getByTestId("spherical.view.ring.z"),
    from = await middle_of(knob);
  await drag(page, from, {x: from.x + 24, y: from.y - 14}, 30);
  await until_settled(page);
  const turned = await task(page);
  expect(turned.orientations[2]).not.toEqual(first.orientations[2]);
  expect(Object.keys(turned.orientations[2]!)).toEqual(Object.keys(first.orientations[2]!)); // as it was typed
  expect(turned.orientations.toSpliced(2, 1)).toEqual(first.orientations.toSpliced(2, 1));
  expect(await map_hash(page)).not.toBe(before);
  await page.keyboard.press("Control+z");
  await until_settled(page);
  expect(await task(page)).toEqual(first);

  await page.getByTestId("num.best").click();
  await until_settled(page);
  await expect(page.getByTestId("num.verdict")).toContainText("✓");
  await expect(page.getByTestId("num.verified")).toBeAttached();
  const stood = await nose(page);
  await page.getByTestId("drive.play").click();
  await expect.poll(() => nose(page)).not.toBe(stood);
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByTestId("num.stl").click()]);
  expect(download.suggestedFilename()).toMatch(/^folding-wing.*\.stl$/);
  const data = readFileSync(await download.path());
  expect(data.length).toBe(84 + 50 * data.readUInt32LE(80));
  expect(data.readUInt32LE(80)).toBeGreaterThan(1000);
  await keep_screenshot(page, "spherical");
});

test("orientations are typed in any form, added, moved, given rates and removed", async ({page}) => {
  await open_wing(page);
  await page.getByTestId("spherical.open.2").click();
  await type_into(page, "spherical.2.euler_deg.2", "33");
  await expect.poll(async () => (await task(page)).orientations[1]).toMatchObject({euler_deg: [-5, 10, 33]});
  await page.getByTestId("spherical.2.form").selectOption("quaternion");
  await expect.poll(async () => Object.keys((await task(page)).orientations[1]!)).toEqual(["quaternion"]);
  await page.getByTestId("spherical.menu.2").click();
  await page.getByTestId("spherical.add_rate").click();
  await expect.poll(async () => (await task(page)).orientations[1]).toMatchObject({angular_velocity: [0, 0, 1]});
  await page.getByTestId("spherical.2.remove_rate.1").click();
  await page.getByTestId("spherical.menu.2").click();
  await page.getByTestId("spherical.remove").click();
  expect((await task(page)).orientations).toHaveLength(3);
  await expect(page.getByTestId("task.missing")).toContainText("give both fixed");
  await page.getByTestId("spherical.given.fixed_axes").click();
  expect((await task(page)).given).toMatchObject({fixed_axes: [[0, 0, 1], expect.anything()]});
});

test("an orientation that is added stands a little away from the last, in its form", async ({page}) => {
  await open_wing(page);
  await page.getByTestId("spherical.add").click();
  await expect.poll(async () => (await task(page)).orientations.length).toBe(5);
  expect((await task(page)).orientations[4]).toMatchObject({sequence: "xyz"});
  await until_mapped(page);
  await page.keyboard.press("Control+z");
  await expect.poll(async () => (await task(page)).orientations.length).toBe(4);
});

test("a cone is drawn about the axes, dragged by its handles and dropped", async ({page}) => {
  await open_wing(page);
  const half = () => read_state(page, ({problem}) => problem.requirements?.fixed_axes_within?.half_angle_deg ?? null);
  const opened = await half();
  expect(opened).not.toBeNull();
  const rim = await middle_of(page.getByTestId("spherical.view.grip.fixed_axes_within.rim")),
    axis = await middle_of(page.getByTestId("spherical.view.grip.fixed_axes_within.axis"));
  await drag(page, rim, {x: (2 * rim.x + axis.x) / 3, y: (2 * rim.y + axis.y) / 3}, 8);
  await expect.poll(half).toBeLessThan(opened!);
  await page.keyboard.press("Control+z");
  await expect.poll(half).toBe(opened);
  await page.getByTestId("fixed_axes_within.drop").click();
  await expect(page.getByTestId("spherical.view.grip.fixed_axes_within.rim")).toHaveCount(0);
  await page.getByTestId("moving_axes_within.begin").click();
  await expect(page.getByTestId("spherical.view.grip.moving_axes_within.axis")).toBeVisible();
});

test("a linkage is pinned, compared, kept in a link and a file, and taken away", async ({page}) => {
  await open_wing(page);
  await page.getByTestId("num.best").click();
  await until_settled(page);
  await page.getByTestId("pin.add").click();
  await page.getByTestId("pin.compare").click();
  await expect(page.getByTestId("pin.column")).toHaveCount(1);
  await page.keyboard.press("Escape");
  const kept = () =>
    read_state(page, ({problem, picked, pins}) =>
      JSON.stringify([problem.task, picked?.tau, pins.map(({tau}) => tau)]),
    );
  const before = await kept();

  await page.getByRole("button", {name: "Export", exact: true}).click();
  await expect(page.getByTestId("export.plates.report")).toContainText("nothing collides");
  await expect(page.getByTestId("export.missing")).toContainText("no plane");
  await expect(page.getByTestId("export.csv")).toContainText("quaternion");
  const taken = async (format: string) => {
    const [download] = await Promise.all([page.waitForEvent("download"), page.getByTestId(`export.${format}`).click()]);
    return readFileSync(await download.path());
  };
  expect((await taken("svg")).toString()).toContain("<svg");
  expect((await taken("csv")).toString()).toContain("quaternion_w");
  expect((await taken("png")).readUInt32BE(16)).toBeGreaterThan(800); // the sphere as it is on screen
  const file = await taken("problem");
  await page.keyboard.press("Escape");

  await read_state(page, (workbench) => workbench.drag((problem) => ({...problem, title: "Another"})));
  await page.getByTestId("file.menu").click();
  const [chooser] = await Promise.all([page.waitForEvent("filechooser"), page.getByTestId("file.open").click()]);
  await chooser.setFiles({name: "wing.json", mimeType: "application/json", buffer: file});
  await until_settled(page);
  await expect.poll(kept).toBe(before);
});

test("links that collide are told before they are saved", async ({page}) => {
  await open_wing(page);
  await read_state(page, (workbench) => {
    workbench.edit((problem) => ({...problem, requirements: {...problem.requirements, min_link_angle_deg: 0}}));
    workbench.pick([1.3632489968250148, 0.8795044523844786]); // short links, hub by hub
  });
  await until_settled(page);
  await page.getByTestId("num.stl").click();
  await expect(page.getByTestId("export.plates.report")).toContainText("has collisions");
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByTestId("export.stl").click()]);
  expect(download.suggestedFilename()).toMatch(/\.stl$/);
});

test("five orientations leave a few axes, and a cell with a picture to each pair", async ({page}) => {
  await open_wing(page);
  await read_state(page, (workbench) =>
    workbench.edit((problem) => {
      const {orientations} = problem.task as SphericalTask,
        last = {euler_deg: [-60, 12, 75], sequence: "xyz"} as const;
      return {...problem, task: {...problem.task, orientations: [...orientations, last]} as SphericalTask};
    }),
  );
  await until_mapped(page);
  await expect(page.getByTestId("task.pattern")).toHaveText("P-P-P-P-P");
  expect(await read_state(page, ({census}) => census!.pairs)).toBe(2);
  for (const cell of ["1_2", "2_1"])
    await expect(page.getByTestId(`region.board.${cell}`).locator("path").first()).toBeAttached();
});

test("a body is chosen, or taken from an STL file", async ({page}) => {
  await open_wing(page);
  const body = () => read_state(page, ({problem}) => problem.view?.body ?? null);
  await page.getByTestId("spherical.body").selectOption("dish");
  await expect.poll(body).toEqual({shape: "dish"});
  const facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 10 0 0\nvertex 0 20 5\nendloop\nendfacet\n";
  await page.getByTestId("spherical.body_file").setInputFiles({
    name: "flap.stl",
    mimeType: "model/stl",
    buffer: Buffer.from(`solid flap\n${facet}endsolid flap\n`),
  });
  await expect.poll(body).toMatchObject({shape: "own", name: "flap.stl"});
  await page
    .getByTestId("spherical.body_file")
    .setInputFiles({name: "empty.stl", mimeType: "model/stl", buffer: Buffer.from("solid none\nendsolid none\n")});
  await expect(page.getByTestId("toast.title")).toContainText("empty.stl was not taken");
});

test("is accessible, in the dark too", async ({page}) => {
  await open_wing(page);
  await page.getByTestId("spherical.mark.2").click();
  await expect_accessible(page);
  await read_state(page, () => void (document.documentElement.dataset.theme = "dark"));
  await expect_accessible(page);
});

test.describe("on a phone", () => {
  test.use({viewport: {width: 390, height: 844}, hasTouch: true, isMobile: true});
  test("sphere and map are in sight together; a linkage is picked and its links taken", async ({page}) => {
    await open_wing(page);
    for (const place of ["spherical.stage", "region.map"]) {
      const box = (await page.getByTestId(place).boundingBox())!;
      expect(box.x, place).toBeGreaterThanOrEqual(-1);
      expect(box.x + box.width, place).toBeLessThanOrEqual(391);
      expect(box.height, place).toBeGreaterThan(150);
    }
    await page.getByTestId("tab.numbers").click();
    const [download] = await Promise.all([page.waitForEvent("download"), page.getByTestId("num.stl").click()]);
    expect(download.suggestedFilename()).toMatch(/\.stl$/);
  });
});
