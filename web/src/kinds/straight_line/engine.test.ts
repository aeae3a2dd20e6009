// The engine as it is built for the page: every case has a map, and what is told of its linkages agrees with itself.
import {describe, expect, it} from "vitest";
import {whole, type MapAnswer, type TauPair} from "../../contract/messages";
import {ask} from "../../../tests/asked_engine";
import {solve} from "../../../tests/program";
import {examples} from "../../gallery/gallery";
import {row_state} from "../../state/drive";
import {engine_text, with_task, type Problem} from "../../state/problem";
import type {Interval} from "../../state/task";
import {ranges_of} from "./axes";
import {forms, with_form} from "./cases";
import {straight_line_kind} from "./kind";
import {counted, driven_place, place_at, profile_plot, speed_plot} from "./profile";
import type {StraightLineTask} from "./task";

const mapped = examples.filter(({name}) => name.startsWith("straight_") && name !== "straight_search");
const explore = (problem: Problem, samples = 60) =>
  ask("explore", {
    problem: engine_text(problem),
    samples,
    window: whole,
    property: "stroke_over_longest",
    order: "fresh",
  });
/** The cell with the longest usable length that meets everything. */
function best_cell(map: MapAnswer): TauPair | null {
  let best = -1;
  for (let cell = 0; cell < map.value.length; ++cell)
    if (map.fails[cell] === 0 && (best < 0 || map.value[cell]! > map.value[best]!)) best = cell;
  return best < 0 ? null : [map.input_tau[Math.floor(best / map.columns)]!, map.output_tau[best % map.columns]!];
}

const [, begun] = straight_line_kind.beginnings,
  start = {...begun!.make(), requirements: {max_length: null}};
describe.each(forms.filter(({id}) => id !== "search").map((form) => ({id: form.id, form})))(
  "the case $id",
  ({form}) => {
    const begun = with_form(start.task as StraightLineTask, form),
      // Where the pole is a given pivot few others go with it.
      near = form.id === "pole_at_given_pivot" ? {ground_pivots: {input: [100, 0], output: [75, 30]} as const} : {};
    const problem = with_task(start, {...begun, ...near});
    it("has linkages whose points run as the map says", () => {
      const {task, map} = explore(problem);
      expect(task.status).toBe("solved");
      const tau = best_cell(map!)!,
        {linkage} = ask("linkage", {problem: engine_text(problem), tau}),
        line = linkage.straight_line!;
      expect(linkage.fails).toBe(0);
      expect(line.case).toBe(form.case);
      if (!form.contacts && form.id !== "symmetric_lambda")
        expect(line.contact_points).toBeGreaterThanOrEqual(form.contact);
      // By the drive's table the point is where the profile has it.
      const {drive} = linkage,
        [first, last] = drive!.task,
        direction = (problem.task as StraightLineTask).line.direction_deg;
      expect(drive!.ticks.length).toBeGreaterThanOrEqual(2);
      if (first < 0 || last < 0) return; // through a dead point of the input
      const ends = [first, last].map((row) => row_state(drive!, row).input_deg),
        usable = counted(linkage, problem)!;
      if (!form.contacts) {
        const places = ends.map((angle) => driven_place(drive!, line, direction, angle));
        expect(places[0]![0]).toBeCloseTo(usable.from_s, 4);
        expect(places[1]![0]).toBeCloseTo(usable.to_s, 4);
      }
      const middle = (ends[0]! + ends[1]!) / 2,
        [s, e] = driven_place(drive!, line, direction, middle),
        told = place_at(line, middle)!;
      expect(Math.abs(told[0] - s)).toBeLessThan(0.01 * usable.length);
      expect(Math.abs(told[1] - e)).toBeLessThan(0.1 * line.deviation);
    });
  },
);

describe.each(mapped)("$name", ({problem}) => {
  it("has linkages that meet what it requires, the best of them exactly", () => {
    const {map} = explore(problem, 200);
    expect(map!.census.meeting).toBeGreaterThan(0);
    const text = engine_text(problem),
      {linkages} = ask("best", {problem: text, most: 1}),
      {linkage} = ask("linkage", {problem: text, tau: linkages[0]!.tau});
    expect(linkage.fails).toBe(0);
    expect(ask("verify", {problem: text, tau: linkage.tau}).verified).toBe(true);
    const profile = profile_plot(linkage)!;
    expect(profile.values[0]).toHaveLength(profile.values[1]!.length);
    const {deviation, strip_middle} = linkage.straight_line!;
    expect(profile.band).toEqual([strip_middle - deviation, strip_middle + deviation]);
    expect(speed_plot(linkage)!.y[1]).toBeGreaterThan(0);
    for (const format of ["svg", "dxf", "csv", "json", "result"] as const)
      expect(ask("export", {problem: text, tau: linkage.tau, format}).text.length).toBeGreaterThan(100);
    JSON.parse(ask("export", {problem: text, tau: linkage.tau, format: "result"}).text);
  });
});

/** What the program lists. */
function listed(problem: Problem, region_samples = 40) {
  return solve({...problem, options: {...problem.options, region_samples, best: 3}}).linkages;
}
describe.each(mapped)("$name, as the program lists it", ({problem}) => {
  it("is told the same of its linkages", () => {
    const {task} = explore(problem, 20),
      {input, output} = ranges_of(task.axes);
    for (const wanted of listed(problem)) {
      const share = ([low, high]: Interval, at: number) => (at - low) / (high - low),
        tau = [wanted.layer + share(input!, wanted.place[0]), output ? share(output, wanted.place[1]) : 0.5] as const;
      const {linkage} = ask("linkage", {problem: engine_text(problem), tau}),
        line = linkage.straight_line!;
      expect(linkage.type).toBe(wanted.type);
      for (const link of ["ground", "input", "coupler", "output"] as const)
        expect(Math.abs(linkage.lengths![link] / wanted.lengths[link] - 1)).toBeLessThan(1e-6);
      expect(line.contact_points).toBe(wanted.contact_points);
      expect(Math.abs(line.usable.length / wanted.usable.length - 1)).toBeLessThan(1e-4);
      expect(linkage.min_transmission_angle_deg).toBeCloseTo(wanted.min_transmission_angle_deg, 2);
    }
  });
});

describe("the strip where it lies best", () => {
  const [, begun] = straight_line_kind.beginnings,
    made = begun!.make(),
    problem: Problem = {...made, options: {...made.options, measure: "strip"}};
  const shares = (most: number) =>
    ask("best", {problem: engine_text(problem), most}).linkages.map(({stroke_over_longest: share}) => share!);
  it("has one best, whoever is asked", () => {
    const [best] = shares(1),
      [first] = shares(10);
    expect(best).toBe(first);
    const [theirs] = listed(problem, 400);
    expect(Math.abs(theirs.stroke_over_longest / best! - 1)).toBeLessThan(1e-4);
  });
  it("holds the path over all that is usable", () => {
    const text = engine_text(problem);
    for (const {tau} of ask("best", {problem: text, most: 5}).linkages) {
      const {linkage} = ask("linkage", {problem: text, tau}),
        line = linkage.straight_line!,
        [low, high] = profile_plot(linkage)!.band!,
        off = line.profile
          .filter(([s]) => s >= line.over_usable.s_from && s <= line.over_usable.s_to)
          .map(([, e]) => e);
      expect(off.length).toBeGreaterThan(20);
      expect(Math.max(...off)).toBeLessThanOrEqual(high + 1e-6 * line.deviation);
      expect(Math.min(...off)).toBeGreaterThanOrEqual(low - 1e-6 * line.deviation);
    }
  });
});

it("has a layer to each linkage of a place", () => {
  const {task, map} = explore(examples.find(({name}) => name === "straight_stage")!.problem, 40);
  expect(task.axes.input.branches.map(({name}) => name)).toEqual(["AB", "AD", "BD"]);
  expect([map!.rows, map!.columns]).toEqual([69, 23]);
});
