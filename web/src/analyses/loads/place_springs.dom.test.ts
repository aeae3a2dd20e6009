// Springs that are looked for, from the card: boxes on the drawing, what the engine answers, taken or stopped.
import {beforeEach, expect, test, vi} from "vitest";
import {
  all,
  choose,
  click,
  get,
  is_there,
  open_files,
  open_settled,
  press,
  text,
  type_into,
  until,
  until_settled,
  until_there,
  value_of,
  workbench,
} from "../../../tests/page/support";
import {example} from "../../../tests/program";
import type {PlacedSpring, Replies, Requests, Tidings} from "../../contract/messages";
import {EngineClient, Refusal, type Job, type Run} from "../../engine/client";
import {strut, struts, stud} from "./example";
import {place_study_of} from "./place_study.svelte";

const found: PlacedSpring = {
  title: "Tailgate",
  length_unit: "mm",
  spring: {...strut, from: stud("ground", 140, 100), F1: 320, F2: 430},
  max_hand_force: 76.0884,
  at_stations: 76.05,
  lower_bound: null,
  proven: false,
  places: 20736,
  boxes: 0,
};
interface Search {
  asked: Requests["place_spring"];
  tell(tidings: Tidings["place_spring"]): void;
  answer(reply: Replies["place_spring"]): void;
  refuse(reason: Error): void;
}
/** What is asked of the engine, which answers when it is told to; maps of studs at once. */
let searches: Search[] = [];
let maps: Requests["stud_map"][] = [];
function answer_by_hand(): void {
  const {run, follow} = EngineClient.prototype;
  [searches, maps] = [[], []];
  vi.spyOn(EngineClient.prototype, "run").mockImplementation(function (
    this: EngineClient,
    job: Job<never>,
    how?: Run<never>,
  ) {
    const asked = job as Job<"place_spring">;
    if (asked.kind !== "place_spring") return run.call(this, job, how as never);
    return new Promise((resolve, reject) => {
      how?.signal?.addEventListener("abort", () => reject(new Error("stopped")));
      searches.push({
        asked,
        tell: how!.progress as Search["tell"],
        answer: resolve as Search["answer"],
        refuse: reject,
      });
    });
  } as EngineClient["run"]);
  vi.spyOn(EngineClient.prototype, "follow").mockImplementation(function (
    this: EngineClient,
    kind: never,
    request: never,
  ) {
    if (kind !== ("stud_map" as never)) return follow.call(this, kind, request);
    maps.push(request);
    return Promise.resolve({map: {columns: 2, rows: 1, force: [76, null]}});
  } as EngineClient["follow"]);
}
async function open_place(): Promise<void> {
  answer_by_hand();
  await open_files("struts.json", JSON.stringify({...example("tailgate"), loads: struts}));
  await until(() => workbench.problem.loads?.springs);
  await until_settled();
  await click("loads.tab");
  await until_there("loads.place");
  await click("loads.place");
}
const springs = () => workbench.problem.loads!.springs!;
const boxes_of = ({asked}: Search) => JSON.parse(asked.boxes) as Record<string, unknown>;

beforeEach(open_settled);

test("what is found is shown as it comes, and taken as one step", async () => {
  await open_place();
  await click("loads.place_start");
  const search = searches[0]!;
  expect(boxes_of(search)).toMatchObject({linkwright: 1, spring: {kind: "gas", name: "strut", count: 2}, max_F1: 1200});
  expect(text("loads.place_result")).toBe("Looking for the best places.");
  search.tell({found});
  await until(() => text("loads.place_result").endsWith("not proved yet."));
  expect(text("loads.place_result")).toBe("76.1 N in the hand; best of 20 736 places, not proved yet.");
  expect(is_there("drawing.place_found")).toBe(true);
  search.answer({placed: {...found, lower_bound: 72.3, proven: true}});
  await until_there("loads.place_start");
  expect(text("loads.place_result")).toBe("76.1 N in the hand; nothing below 72.3 N, proved (4.9 %).");

  const box = value_of("loads.place_ground_x_low");
  await click("loads.place_take");
  expect(springs()).toEqual([found.spring]);
  expect(text("loads.place_take")).toBe("Taken");
  expect(value_of("loads.place_ground_x_low")).toBe(box);
  expect(text("loads.place_result")).not.toContain("Of other boxes");
  await click("edit.undo");
  expect(springs()).toEqual([strut]);
  await type_into("loads.place_max_F1", "900");
  expect(text("loads.place_result")).toContain("Of other boxes");
});

test("a new one is added to those that there are", async () => {
  await open_place();
  await choose("loads.place_which", "new");
  await click("loads.place_start");
  const name = (boxes_of(searches[0]!).spring as {name: string}).name;
  expect(name).toBe("spring");
  searches[0]!.answer({placed: {...found, spring: {...found.spring!, name}}});
  await until_there("loads.place_take");
  await click("loads.place_take");
  expect(springs()).toEqual([strut, {...found.spring, name}]);
  expect(value_of("loads.place_which")).toBe("1");
});

test("a search that is stopped keeps what it has found; why there is nothing is told", async () => {
  await open_place();
  await click("loads.place_start");
  searches[0]!.tell({found});
  await until_there("loads.place_take");
  await click("loads.place_stop");
  expect(text("loads.place_result")).toMatch(/not proved to be the best\.$/);
  await click("loads.place_start");
  const why_not = {code: "nothing_fits", message: ""}; // as the engine says it
  searches[1]!.answer({placed: {...found, spring: null, max_hand_force: null, proven: true, why_not}});
  await until(() => text("loads.place_result").startsWith("No spring "));
  expect(is_there("loads.place_take")).toBe(false);
  await click("loads.place_start");
  searches[2]!.answer({placed: null});
  await until(() => text("loads.place_result").startsWith("No forces can be told"));
});

test("mistakes are told at their fields", async () => {
  await open_place();
  await click("loads.place_more");
  await type_into("loads.place_end_margin", "1");
  await click("loads.place_start");
  expect(boxes_of(searches[0]!)).toMatchObject({end_margin: 1});
  const mistake = (code: string, place: string) => ({code, place, values: {}, message: `of ${place}`});
  searches[0]!.refuse(
    new Refusal([
      mistake("small_margin", "end_margin"),
      mistake("low_above_high", "body.x"),
      mistake("new", "elsewhere"),
    ]),
  );
  await until_there("loads.place_end_margin_fault");
  expect(text("loads.place_end_margin_fault")).toMatch(/^at least as much/);
  expect(text("loads.place_body_fault")).toBe("the first number is the smaller one");
  expect(text("loads.card")).toContain("of elsewhere");
  expect(is_there("loads.place_result")).toBe(false);
});

test("boxes are on the drawing, to be moved by their corners, and the map of a stud in one of them", async () => {
  await open_place();
  expect(all("drawing.place_ground")).toHaveLength(1);
  const right = () => Number(value_of("loads.place_ground_x_high")),
    [before, left] = [right(), value_of("loads.place_ground_x_low")];
  get("drawing.place_ground_ne").focus();
  await press("ArrowRight");
  expect(right()).toBeGreaterThan(before);
  expect(value_of("loads.place_ground_x_low")).toBe(left);
  get("drawing.place_body_all").focus();
  await press("ArrowUp");
  expect(is_there("drawing.place_map")).toBe(false);
  await choose("loads.place_map", "body");
  await until_there("drawing.place_map");
  expect(maps.at(-1)).toMatchObject({stud: "body", columns: 24, rows: 24});
  expect(get("drawing.place_map").querySelectorAll("path")).toHaveLength(1);
  expect(text("loads.place_scale")).toBe("76 N 76 N or more");
  const asked = maps.length;
  await type_into("loads.place_ground_x_low", "0");
  await until(() => maps.length > asked);
  expect(JSON.parse(maps.at(-1)!.boxes)).toMatchObject({ground: {x: [0, right()]}});

  workbench.set_angle(20);
  await click("loads.place"); // folded
  await until(() => !is_there("drawing.place_ground") && !is_there("drawing.place_map"));
  expect(place_study_of(workbench).shown).toBe(false);
  await click("loads.place");
  expect(right()).toBeGreaterThan(before);
});
