import {afterEach, describe, expect, test} from "vitest";
import type {PlacedSpring} from "../../contract/messages";
import {preferences} from "../../state/preferences.svelte";
import type {Problem} from "../../state/problem";
import {example} from "../../../tests/program";
import {strut, struts} from "./example";
import {
  boxes_text,
  choices_of,
  level_of,
  levels,
  proof_text,
  scale_of,
  usual_wanted,
  with_placed,
  without_chosen,
} from "./placing";

const problem: Problem = {...example("tailgate"), loads: struts};
afterEach(() => void (preferences.language = "en"));

describe("what is looked for", () => {
  test("is like the spring that there is, about its studs, and holds open what is required", () => {
    const wanted = usual_wanted({...problem, requirements: {min_hold_open: 13}}, 0)!;
    expect(wanted).toMatchObject({
      name: "strut",
      count: 2,
      ratio: 1.313,
      friction: 25,
      max_F1: 1200,
      min_hold_open: 13,
    });
    const {x, y} = wanted.ground;
    expect([(x[0] + x[1]) / 2, (y[0] + y[1]) / 2]).toEqual(strut.from.at);
    expect(x[1] - x[0]).toBeCloseTo(y[1] - y[0], 6);
    expect(JSON.parse(boxes_text(wanted))).toEqual({
      linkwright: 1,
      spring: {kind: "gas", name: "strut", count: 2, F2_over_F1: 1.313, friction: 25, measured_at: 5},
      ground: wanted.ground,
      body: wanted.body,
      max_F1: 1200,
      min_hold_open: 13,
    });
  });
  test("may be a new one, whose name no other has", () => {
    const {loads: _, ...bare} = problem;
    expect(usual_wanted(bare, "new")).toBeNull();
    expect(choices_of(struts)).toEqual([0, "new"]);
    expect(usual_wanted(problem, "new")!.name).toBe("spring");
    expect(without_chosen(problem, 0).loads).not.toHaveProperty("springs");
    expect(without_chosen(problem, "new")).toBe(problem);
  });
  test("takes its place in the list, or is one more", () => {
    const other = {...strut, F1: 300};
    expect(with_placed(struts, 0, other).springs).toEqual([other]);
    expect(with_placed(struts, "new", other).springs).toEqual([strut, other]);
  });
});

describe("what was found", () => {
  const placed: PlacedSpring = {
    title: "",
    length_unit: "mm",
    spring: strut,
    max_hand_force: 76.0884,
    at_stations: 76.05,
    lower_bound: null,
    proven: false,
    places: 65536,
    boxes: 0,
  };
  const told = (of: PlacedSpring, is_looking: boolean) => proof_text(of, is_looking).replace(/\s/g, " ");
  test("is told with what is proved", () => {
    expect(told(placed, true)).toBe("76.1 N in the hand; best of 65 536 places, not proved yet.");
    expect(told({...placed, lower_bound: 60.2}, false)).toBe(
      "76.1 N in the hand; best of 65 536 places, nothing below 60.2 N, not proved to be the best.",
    );
    const proven = {...placed, lower_bound: 72.3, proven: true};
    expect(told(proven, false)).toBe("76.1 N in the hand; nothing below 72.3 N, proved (4.9 %).");
    expect(told({...proven, at_stations: 70, lower_bound: 70}, false)).toBe(
      "76.1 N in the hand, 70 N without the friction of pins; nothing below 70 N, proved (0 %).",
    );
    preferences.language = "zh";
    expect(told(proven, false)).toBe("手力 76.1 N；不可能低于 72.3 N，已证明（4.9 %）。");
  });
  test("or why there is nothing", () => {
    const nothing = (values?: {proven: number}) =>
      proof_text(
        {...placed, spring: null, max_hand_force: null, why_not: {code: "nothing_fits", values, message: ""}},
        false,
      );
    expect(nothing({proven: 1})).toMatch(/^No spring was found .* meets the demands\. There is none\.$/);
    expect(nothing({proven: 0})).toMatch(/There may yet be one\.$/);
    expect(nothing()).toMatch(/meets the demands\.$/);
    const why_not = {code: "unheard_of", values: {}, message: "As the engine says it."};
    expect(proof_text({...placed, spring: null, why_not}, false)).toBe("As the engine says it.");
  });
});

test("a map has its colours where most of its cells are", () => {
  const force = [null, ...Array.from({length: 10}, (_, i) => 70 + i), 1e4],
    scale = scale_of(force)!;
  expect(scale).toEqual({low: 70, high: 79});
  expect([level_of(70, scale), level_of(1e4, scale)]).toEqual([0, levels - 1]);
  expect(scale_of([null])).toBeNull();
  expect(level_of(5, scale_of([5])!)).toBe(0);
});
