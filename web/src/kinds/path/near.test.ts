import {describe, expect, it} from "vitest";
import type {Problem} from "../../state/problem";
import {incompleteness} from "./missing";
import type {Linkage} from "../../contract/messages";
import type {PathFit} from "../../contract/result";
import {between_ends, effort_of, path_map_of, with_effort, with_quick_fit} from "./near";
import {plot_of} from "./near_plot";
import {
  path_task,
  smoothed_points,
  with_between,
  with_bolted,
  with_clicked,
  with_closed,
  with_form,
  with_near_points,
  with_path_map,
  with_point_number,
  with_points,
  with_tolerance,
} from "./points";
import {path_kind} from "./kind";
import {is_near, pivots_of, type PathPoint, type PathTask} from "./task";

const round = (count: number): PathPoint[] =>
  Array.from({length: count}, (_, i) => {
    const angle = (2 * Math.PI * i) / count;
    return {x: Number((10 * Math.cos(angle)).toFixed(3)), y: Number((7 * Math.sin(angle)).toFixed(3))};
  });
const problem = (more: Partial<PathTask>, rest: Partial<Problem> = {}): Problem => ({
  linkwright: 1,
  ...rest,
  task: {kind: "path", mechanism: "four_bar", points: round(8), ...more} as PathTask,
});
const task = (of: Problem) => path_task(of)!;

describe("a path is near its points", () => {
  it.each([
    ["closed", {closed: true, points: round(4)}, true],
    ["with a tolerance", {tolerance: 1, points: round(4)}, true],
    ["that keeps to the polygon", {between: "polyline" as const, points: round(4)}, true],
    ["that is free between", {between: "free" as const, points: round(4)}, true],
    ["with a weight", {points: [...round(3), {x: 0, y: 0, weight: 2}]}, true],
    ["with a tolerance of a point", {points: [...round(3), {x: 0, y: 0, tolerance: 2}]}, true],
    ["of six points", {points: round(6)}, true],
    ["of five points", {points: round(5)}, false],
    ["of six points about a pivot", {points: round(6), given: {ground_pivots: {input: [1, 1] as const}}}, false],
    ["of six with an angle", {points: [...round(5), {x: 0, y: 0, theta_deg: 1}]}, false],
  ])("%s", (_, more, near) => {
    expect(is_near(task(problem(more)))).toBe(near);
  });
  it("stays so with however few points, whatever else is taken away, and says what is missing", () => {
    const few = with_points(problem({}), (points) => points.slice(0, 4));
    expect([task(few).between, is_near(task(few)), incompleteness(task(few))]).toEqual(["free", true, null]);
    for (const given of [with_closed(few, true), with_between(few, true), with_tolerance(few, 0.5)])
      expect(task(with_tolerance(with_between(with_closed(given, false), false), null))).toEqual(task(few));
    const none = with_points(few, () => []);
    expect(incompleteness(task(none))).toEqual({state: "too_few", text: "state.path_few_near", n: 3});
    expect(task(with_clicked(none, [3, 4])!).points).toEqual([{x: 3, y: 4}]);
    const one = problem({closed: true, points: Array.from({length: 5}, () => ({x: 1, y: 1}))});
    expect(incompleteness(task(one))!.n).toBe(2);
    const exact = problem({points: round(4), given: {ground_pivots: {input: [1, 1]}}});
    expect(task(with_points(exact, (points) => points.slice(1)))).not.toHaveProperty("between");
  });
});

describe("its form", () => {
  it("takes away what goes with points that are passed exactly, and gives it back to none", () => {
    const timed = problem({points: round(4).map((point, i) => ({...point, input_deg: 30 * i}))}),
      near = with_form(timed, "near", null);
    expect(task(near)).toEqual({kind: "path", mechanism: "four_bar", between: "free", points: round(4)});
    const full = with_point_number(with_tolerance(with_closed(near, true), 2), 1, "weight", 3);
    expect(task(full).points[1]).toEqual({...round(4)[1], weight: 3});
    const back = with_form(with_effort(full, "deep"), "pivots", null);
    expect(Object.keys(task(back)).sort()).toEqual(["given", "kind", "mechanism", "points"]);
    expect(task(back).points).toEqual(round(4));
    expect(back.options?.fit).toBeUndefined();
  });
  it("takes an objective away that goes with it alone", () => {
    const by_error = problem({closed: true}, {options: {objective: "path_error", best: 3}});
    expect(with_form(by_error, "angles", null).options).toEqual({best: 3});
    expect(with_closed(by_error, false).options).toEqual({objective: "path_error", best: 3});
    const bounded = problem({closed: true}, {requirements: {max_path_error: 2, max_length: 900}});
    expect(with_form(bounded, "angles", null).requirements).toEqual({max_length: 900});
    expect(with_closed(bounded, false).requirements).toEqual({max_path_error: 2, max_length: 900});
  });
  it("is read and written whole", () => {
    const whole = {...task(problem({closed: true, tolerance: 0.5, between: "polyline"}))};
    const points = [{x: 0, y: 0, weight: 2, tolerance: 0.1}, ...round(3)];
    expect(path_kind.read({...whole, points} as never)).toEqual({...whole, points});
    expect(path_kind.read({...whole, closed: "yes", tolerance: "1"} as never)).not.toHaveProperty("closed");
  });
});

describe("its map", () => {
  it("runs over the curves where nothing else is said", () => {
    const plain = problem({closed: true}),
      mapped = with_path_map(plain, "pivots");
    expect(task(mapped).map).toBe("pivots");
    expect([plain, mapped].map((of) => path_map_of(task(of)))).toEqual(["curves", "pivots"]);
    expect(path_kind.map_of(task(mapped))).not.toBe(path_kind.map_of(task(plain)));
    expect(task(with_path_map(mapped, "curves"))).toEqual(task(plain));
    expect(task(with_form(mapped, "angles", null))).not.toHaveProperty("map");
  });
  it("is none of places where a pivot stands already", () => {
    const mapped = with_path_map(problem({closed: true}), "pivots"),
      hand = {input: {center: [12.34567, 5]}, output: {center: [30, 1]}} as unknown as Linkage,
      bolted = with_bolted(mapped, "input", true, hand);
    expect(task(bolted)).not.toHaveProperty("map");
    expect(task(bolted).given).toEqual({ground_pivots: {input: [12.35, 5]}});
    const both = with_bolted(bolted, "output", true, hand);
    expect(task(both).given).toEqual({ground_pivots: {input: [12.35, 5], output: [30, 1]}});
    expect(is_near(task(both))).toBe(true);
    expect(task(with_bolted(both, "input", false, hand)).given).toEqual({ground_pivots: {output: [30, 1]}});
    expect(task(with_near_points(bolted, [[0, 0], [1, 0], [1, 1]], true)).given).toEqual(task(bolted).given); // prettier-ignore
    expect(task(with_bolted(with_bolted(both, "input", false, null), "output", false, null))).not.toHaveProperty(
      "given",
    );
  });
  it("puts a pivot beside the points where no linkage is in hand", () => {
    const [x, y] = pivots_of(task(with_bolted(problem({closed: true}), "input", true, null))).input!;
    expect(round(8).every((p) => Math.hypot(p.x - x, p.y - y) > 0.5)).toBe(true);
  });
});
describe("its distances", () => {
  const at = [0.2, 1, 0.5].map((distance, i) => ({point: i + 1, distance, input_deg: 0, x: 0, y: 0}));
  const fit = {at, outside: [2]} as unknown as PathFit;
  it("are bars from the edge that stands for none, the tolerance among them", () => {
    const {bars, top, limit} = plot_of(fit, {tolerance: 0.8}, 90, 100);
    expect(top).toBeCloseTo(1.15, 12);
    expect(bars.map(({y}) => y)).toEqual([0.2, 1, 0.5].map((distance) => 100 * (1 - distance / top)));
    expect(bars.map(({outside}) => outside)).toEqual([false, true, false]);
    expect(bars.map(({x}) => x)).toEqual([0, 30, 60]);
    expect(limit).toBeCloseTo(100 * (1 - 0.8 / 1.15), 12);
  });
  it("leave a tolerance out that is far above them, and stand where all are 0", () => {
    expect(plot_of(fit, {tolerance: 50}, 90, 100).limit).toBeNull();
    const exact = {at: at.map((one) => ({...one, distance: 0})), outside: []} as unknown as PathFit;
    expect(plot_of(exact, {}, 90, 100).bars.every(({y}) => y === 100)).toBe(true);
  });
});

describe("what is asked", () => {
  it("is quick while a hand moves", () => {
    const asked = problem({closed: true}, {options: {best: 3, fit: {effort: "deep", measure: "least_largest"}}});
    expect(with_quick_fit(asked).options).toEqual({best: 3, fit: {effort: "quick", measure: "least_largest"}});
    const exact = problem({points: round(4)});
    expect(with_quick_fit(exact)).toBe(exact);
  });
  it("is standard where nothing is said", () => {
    const asked = problem({closed: true});
    expect(effort_of(asked)).toBe("standard");
    expect(with_effort(with_effort(asked, "deep"), "standard").options).toEqual({});
  });
});

it("points are added between the ends of a closed path, drawn anew, and made smooth with what they have", () => {
  expect(between_ends([{x: 0, y: 0}, {x: 5, y: 5}, {x: 2, y: 4}])).toEqual({x: 1, y: 2}); // prettier-ignore
  expect(between_ends([{x: 0, y: 0}])).toBeNull();
  const given = problem({given: {ground_pivots: {input: [1, 1]}}}),
    near = with_near_points(given, [[0, 0], [1, 0], [1, 1]], true); // prettier-ignore
  expect(task(near)).toEqual({
    kind: "path",
    mechanism: "four_bar",
    closed: true,
    points: [{x: 0, y: 0}, {x: 1, y: 0}, {x: 1, y: 1}], // prettier-ignore
  });
  const spiked = problem({closed: true, points: [{x: 30, y: 0, weight: 2}, ...round(12).slice(1)]}),
    smooth = task(smoothed_points(spiked)).points;
  expect(smooth[0]!.weight).toBe(2);
  expect(smooth[0]!.x).toBeLessThan(25);
  expect(smooth).toHaveLength(12);
});
