// The instant of the linkage in hand: shown on demand, of the linkage as it stands, kept between visits.
import {beforeEach, expect, test} from "vitest";
import {
  click,
  download,
  file_menu,
  get,
  is_there,
  open_settled,
  press,
  reload,
  text,
  until,
  until_settled,
  until_there,
  workbench,
} from "../../tests/page/support";
const inflection = () => get("drawing.instant_inflection").getAttribute("d")!;
const tool = () =>
  [...document.querySelectorAll("[role=menuitemcheckbox]")].find((item) => /inflection circle/.test(item.textContent!));

beforeEach(open_settled);

test("the instant is switched on in the tools, follows the drive, and is kept", async () => {
  expect(is_there("drawing.instant")).toBe(false);
  await click("drawing.tools");
  await click(tool()!);
  await until_there("drawing.instant");
  expect(inflection()).toMatch(/^M.+L/);
  expect(text("drawing.instant_legend")).toContain("Ball's point");
  const before = inflection();
  workbench.set_angle(12);
  await until(() => inflection() !== before);
  expect(JSON.parse(localStorage.getItem("linkwright.preferences")!).instant).toBe(true);
  await reload();
  await until_there("drawing.instant");
  expect(inflection()).toMatch(/^M.+L/);
});

test("a key shows and hides it, and the moving pivots lie on the circling-point curve", async () => {
  await press("i");
  await until_there("drawing.instant");
  expect(inflection()).toMatch(/^M/);
  const pivots = [...get("drawing.instant").querySelectorAll("rect")].map((mark) => [
    Number(mark.getAttribute("x")) + 4,
    Number(mark.getAttribute("y")) + 4,
  ]);
  const path = get("drawing.instant_circling").getAttribute("d")!,
    vertices = [...path.matchAll(/[ML](\S+) (\S+?)(?=[ML]|$)/g)].map(([, x, y]) => [Number(x), Number(y)]);
  expect(pivots.length).toBeGreaterThanOrEqual(2);
  for (const [px, py] of pivots)
    expect(Math.min(...vertices.map(([x, y]) => Math.hypot(x! - px!, y! - py!)))).toBeLessThan(20); // a few vertices apart
  await press("i");
  expect(is_there("drawing.instant")).toBe(false);
});

test("six-bars have none", async () => {
  await press("i");
  await until_there("drawing.instant");
  await file_menu("file.examples");
  await click("example.wheel_loader");
  await until_settled();
  await click("drawing.tools");
  expect(tool()).toBeUndefined();
  expect(is_there("drawing.instant")).toBe(false);
});

test("what is shown of it is in the drawing as a file", async () => {
  const svg = async () => {
    await click("export.title");
    await until_there("export.svg");
    const {bytes} = await download(() => click("export.svg"));
    await press("Escape");
    return bytes.toString();
  };
  const without = await svg();
  await press("i");
  await until_there("drawing.instant");
  const curve = get("drawing.instant_circling").getAttribute("d")!;
  expect(without).not.toContain(curve);
  expect(await svg()).toContain(curve);
  await press("i");
  expect(await svg()).toBe(without);
});
