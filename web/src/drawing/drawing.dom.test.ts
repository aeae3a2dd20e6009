// The drawing by keys, and outlines out of files.
import {beforeEach, expect, test} from "vitest";
import {
  all,
  choose_file,
  click,
  focus,
  focused,
  get,
  is_there,
  open_settled,
  poses_of_page,
  press,
  text,
  texts,
  toasts,
  until,
  until_there,
  workbench,
} from "../../tests/page/support";
const outline = () => workbench.problem.view?.outline ?? [];
const plate = '<g transform="translate(40 20)"><path id="plate" d="M0 0h80a20 20 0 0 1 20 20v30h-100z"/></g>';
const page_of = (inside: string) =>
  `<svg xmlns="http://www.w3.org/2000/svg" width="210mm" height="297mm" viewBox="0 0 210 297">${inside}</svg>`;
async function open_outline(): Promise<void> {
  await click("drawing.tools");
  await click(all("task.outline").at(-1)!);
}
const give = (name: string, content: string) => choose_file(name, content, () => click("drawing.outline_file"));

beforeEach(open_settled);

test("handles are moved by the arrow keys, and Tab goes from one to the next", async () => {
  const step = workbench.grid_step,
    second = () => poses_of_page()[1]!;
  await focus("drawing.disc_2");
  await press("ArrowRight");
  await press("ArrowRight");
  expect(second().x).toBeCloseTo(-125 + 2 * step, 9);
  await press("Shift+ArrowUp");
  expect(second().y).toBeCloseTo(75 + 10 * step, 9);
  while (workbench.can_undo) await press("Control+z");
  expect(second()).toMatchObject({x: -125, y: 75});
  await focus("drawing.disc_2");
  await press("Tab");
  expect(focused()).toBe("drawing.knob_2");
  await press("Alt+ArrowLeft");
  expect(second().theta_deg).toBeCloseTo(-24.9, 9);
  await press("Shift+Tab");
  expect(focused()).toBe("drawing.disc_2");
  expect(workbench.selected_pose).toBe(1);
});

test("without WebGL the flat view stays and a sentence says so", async () => {
  workbench.solid = true;
  await until(() => !workbench.solid && workbench.toasts.some(({key}) => key === "state.no_webgl"));
  expect(is_there("drawing.canvas")).toBe(true);
});

test("two positions that are the same are refused in words, the map gone with the marks on it", async () => {
  const with_poses = (poses: object[]) =>
    workbench.edit((problem) => ({...problem, task: {...problem.task, poses} as typeof problem.task}));
  const three = poses_of_page().slice(0, 3);
  with_poses(three);
  await until(() => !is_there("region.crosshair_row"));
  with_poses([...three, three[2]!]);
  await until(() => /Position 4 is the same as an earlier one/.test(text("region.notice")));
});

test("an outline is asked for where the drawing has several shapes, and is not the sheet's frame", async () => {
  await open_outline();
  const before = outline(),
    several = page_of(
      `<rect x="5" y="5" width="200" height="287"/>${plate}<circle cx="70" cy="40" r="8"/><circle cx="100" cy="200" r="30"/>`,
    );
  await give("part.svg", several);
  await until_there("outline.choice");
  const radios = [...get("outline.choice").querySelectorAll<HTMLInputElement>("input[type=radio]")];
  expect(radios.map(({checked}) => checked)).toEqual([true, false, false, false]);
  expect(document.activeElement).toBe(radios[0]);
  expect(texts("[data-testid='outline.choice'] label").at(-1)).toContain("frame of the sheet");
  await press("Escape");
  expect(is_there("outline.choice")).toBe(false);
  expect(outline()).toEqual(before);

  await give("part.svg", several);
  await click("outline.use");
  expect(is_there("outline.choice")).toBe(false);
  const across = outline().map(([x]) => x);
  expect(Math.max(...across) - Math.min(...across)).toBeCloseTo(100, 6);
  await press("Control+z");
  expect(outline()).toEqual(before);
});

test("an outline is taken without a question where there is one, and refused with a reason", async () => {
  await open_outline();
  await give("plate.svg", page_of(plate));
  await until(() => outline().length > 6);
  for (const [name, content, reason] of [
    ["words.svg", page_of("<text>words</text>"), "no shape with three or more corners"],
    ["broken.svg", "<svg", "cannot be read"],
    ["part.dxf", "AutoCAD Binary DXF\r\n\x1a\0", "ASCII DXF"],
    ["part.svg", page_of('<g id="a"><use href="#a"/><use href="#a"/></g>'), "too large"],
  ] as const) {
    await give(name, content);
    await until(() => toasts().includes(reason));
  }
});
