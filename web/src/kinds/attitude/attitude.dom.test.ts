// The attitude of a body: shown in every form, turned by keys and turn by turn, taken away.
import {beforeEach, expect, test} from "vitest";
import {
  all,
  begin,
  choose,
  click,
  copied,
  download,
  faults,
  file_menu,
  get,
  go_to,
  is_there,
  open_settled,
  press,
  reload,
  text,
  type_into,
  until,
  until_there,
  value_of,
  workbench,
} from "../../../tests/page/support";
import {attitude_report} from "../../../tests/program";
import {link_of} from "../../shell/share";

interface Turned {
  kind: string;
  orientation: Record<string, unknown>;
}
const task = () => workbench.problem.task as unknown as Turned;
const matrix = () => get("attitude.panel").querySelector("table.matrix")!.textContent!;

beforeEach(async () => {
  await open_settled();
  await begin("attitude");
  await until(() => is_there("attitude.quaternion") && text("attitude.quaternion").includes("0.719022"));
});

test("three turns are played one after the other, and the lock is announced", async () => {
  await click("attitude.tab.turns");
  await click("attitude.stop.0");
  await until(() => matrix().includes("1.00000"));
  await click("attitude.play");
  await until(() => value_of("attitude.scrub") === "3");
  await until(() => matrix().includes("0.39052"));
  expect(is_there("orientation.locked")).toBe(false);
  await type_into("attitude.turn.1", "0");
  await until(() => all("orientation.locked").some((note) => note.textContent!.includes("t₁ + t₃ = 75.0000°")));
  expect(text("attitude.gauge")).toContain("locked");
  await choose("attitude.sequence", "xyz");
  await until(() => !text("attitude.gauge").includes("locked"));
  await click("attitude.extrinsic");
  await until(() => get("attitude.extrinsic").getAttribute("aria-pressed") === "true");
});

test("a cone, a screw and an angular velocity have their numbers", async () => {
  await click("attitude.tab.rotation");
  await until(() => text("attitude.one_turn").includes("88.0524°"));
  expect(text("attitude.image")).toBe("(0.390519, 0.808972, 0.439385)");
  await click("attitude.tab.screw");
  await until(() => text("attitude.screw").includes("41.89322 mm"));
  for (const k of [0, 1, 2]) await type_into(`attitude.second.${k}`, "0");
  await until(() => text("attitude.screw").includes("rotation about one axis"));
  await click("attitude.make_first");
  await until(() => text("attitude.screw").includes("nothing moves"));
  await click("attitude.tab.rates");
  await until(() => text("attitude.omega").includes("1.45125 rad/s"));
});

test("what is no orientation is refused with a sentence, and the last one stays", async () => {
  await choose("attitude.orientation.form", "axis");
  await until(() => Object.keys(task().orientation).sort().join() === "angle_deg,axis");
  await choose("attitude.orientation.form", "matrix");
  await until_there("attitude.orientation.matrix.0");
  await type_into("attitude.orientation.matrix.0", "2");
  await until(() => faults().includes("rotation"));
  expect(text("attitude.matrix")).toContain("0.390519");
  await click("attitude.tab.screw");
  await click("attitude.first");
  await choose("attitude.from.form", "quaternion");
  await until_there("attitude.from.quaternion.0");
  await type_into("attitude.from.quaternion.0", "0");
  await until(() => faults().includes("all four components are zero"));
  await press("Tab");
  expect(faults()).toContain("all four components are zero"); // the sentence stays
});

test("half a turn has its Rodrigues vector at infinity", async () => {
  await choose("attitude.orientation.form", "axis");
  await until_there("attitude.orientation.axis.3");
  await type_into("attitude.orientation.axis.3", "180");
  await until(() => text("attitude.panel").includes("infinity"));
});

test("it is taken away: reports as the program writes them, and a representation", async () => {
  await click("export.title");
  const taken = (format: string) => download(() => click(`export.task.${format}`));
  const {name, bytes} = await taken("convert"),
    report = JSON.parse(bytes.toString());
  expect(name).toBe("linkage-convert.json");
  const orientation = {euler_deg: [40, 50, 35], sequence: "zxz"},
    program = attitude_report("convert", {orientation, vectors: [[1, 0, 0]]});
  expect(Object.keys(report).sort()).toEqual(Object.keys(program).sort());
  for (const [k, component] of program.quaternion.entries()) expect(report.quaternion[k]).toBeCloseTo(component, 14);
  expect(JSON.parse((await taken("screw")).bytes.toString()).screw.slide).toBeCloseTo(41.89322, 4);
  expect(JSON.parse((await taken("rates")).bytes.toString()).fixed.velocity).toHaveLength(3);
  expect(is_there("export.csv")).toBe(false);
  await press("Escape");
  const copies = all("attitude.copy").map((button) => button.getAttribute("aria-label")!),
    at = copies.findIndex((name) => /quaternion/i.test(name));
  await click(all("attitude.copy")[at]!);
  expect(JSON.parse(await copied())).toEqual(report.quaternion);
});

test("it is kept, shared by a link, and speaks Chinese", async () => {
  await type_into("attitude.orientation.euler_deg.0", "12.5");
  await reload();
  await until_there("attitude.panel");
  expect(task().orientation.euler_deg).toEqual([12.5, 50, 35]);
  const {hash} = new URL(link_of(workbench.whole_problem, location.href)!);
  await file_menu("file.examples");
  await click("example.tailgate");
  await until(() => task().kind === "motion");
  await go_to(hash);
  await until(() => task().kind !== "motion");
  expect(task().orientation.euler_deg).toEqual([12.5, 50, 35]);
  await until_there("attitude.tab.turns");
  await click("view.language");
  await until(() => text("attitude.tab.turns") === "三次转动");
  expect(text("attitude.panel")).toContain("方向余弦矩阵");
  await press("Control+z");
  await until(() => task().kind === "motion");
});
