// What the engine of the page answers to each request, of one example whose answers are known.
import {readFileSync, writeFileSync} from "node:fs";
import {join} from "node:path";
import {describe, expect, test} from "vitest";
import {tau_of_places} from "../src/engine/axis";
import {state_width, whole, type Linkage, type Picked} from "../src/contract/messages";
import {load_thumbnails, stored_start} from "../src/engine/stored";
import {first_example} from "../src/gallery/gallery";
import {halo_reach, roomy_squares} from "../src/state/halo_follower";
import {engine_text} from "../src/state/problem";
import {read_problem} from "../src/state/problem_shape";
import {poses_of} from "../src/state/task";
import {round_of, rounds_of} from "../src/kinds/six_bar/search.svelte";
import {ask, explored, coarse} from "./asked_engine";
import {scratch, tailgate} from "./compared";
import {root, run} from "./program";

describe("the tailgate", () => {
  const at = {problem: tailgate, tau: [1.3125, 1.1125]} as const;
  const with_angle = (degrees: number) => tailgate.replace('angle_deg": 30', `angle_deg": ${degrees}`);

  test("has its known linkage", () => {
    const {linkage} = ask("linkage", at);
    expect(linkage.type).toBe("triple_rocker_output");
    expect(linkage.min_transmission_angle_deg).toBeCloseTo(73.5, 1);
    expect(linkage.link_ratio).toBeCloseTo(4.7, 1);
    expect(linkage.longest).toBeCloseTo(256, 0);
    expect(Object.values(linkage.lengths!).map((x) => x.toFixed(2))).toEqual(["65.03", "211.05", "53.92", "255.90"]);
  });
  test("passes its positions exactly and in order", () => {
    const {states, ticks, task} = ask("linkage", at).linkage.drive!;
    const poses = JSON.parse(tailgate.replace(/^\s*\/\/.*$/gm, "")).task.poses;
    let last = -1;
    for (const [i, tick] of ticks.entries()) {
      expect(tick.reached).toBe(true);
      expect(tick.state).toBeGreaterThan(last);
      last = tick.state;
      const [x, y, theta] = states.subarray(tick.state * state_width + 5);
      expect(Math.hypot(x! - poses[i].x, y! - poses[i].y)).toBeLessThan(1e-9);
      expect(theta).toBeCloseTo(poses[i].theta_deg, 9);
    }
    expect(task).toEqual([ticks[0]!.state, ticks[3]!.state]);
  });
  test("exchanges its grounded links with its drivers", () => {
    const {linkage} = ask("linkage", at),
      mirrored = ask("linkage", {problem: tailgate, tau: [1.1125, 1.3125]}).linkage;
    expect(mirrored.lengths!.input).toBe(linkage.lengths!.output);
    expect(mirrored.type).toBe(linkage.swapped!.type);
  });
  test("says which value would leave something, and keeps its word", () => {
    const {census} = explored(with_angle(89)).map!;
    expect(census.meeting).toBe(0);
    const {requirement, value, leaves} = census.relax[0]!;
    expect(requirement).toBe("min_transmission_angle_deg");
    expect(explored(with_angle(value as number)).map!.census.meeting).toBe(leaves);
  });
  test("leads to the box that would do, and names what leaves nothing only together, as the program does", () => {
    const asking = (requirements: object) => {
      const problem = JSON.parse(tailgate.replace(/^\s*\/\/.*$/gm, ""));
      return JSON.stringify({...problem, requirements: {...problem.requirements, ...requirements}});
    };
    const solved = (text: string) => {
      const file = join(scratch, "asking.json");
      writeFileSync(file, text);
      return JSON.parse(run("solve", file, "-o", "-"));
    };
    const box = {x: [150, 160], y: [300, 320]},
      narrow = asking({ground_pivots_within: box});
    const {relax, missed_boxes} = explored(narrow, "min_transmission_angle_deg", 400).map!.census,
      result = solved(narrow);
    expect(relax).toEqual(result.relax);
    expect(
      explored(asking({[relax[0]!.requirement]: relax[0]!.value}), "min_transmission_angle_deg", 400).map!.census
        .meeting,
    ).toBe(relax[0]!.leaves);
    expect(missed_boxes).toHaveLength(1);
    const {nearest, beyond} = missed_boxes[0]!;
    expect([nearest[0] - beyond[0], nearest[1] - beyond[1]].map((v) => Number(v.toFixed(9)))).toEqual([150, 320]);
    expect(result.reason).toContain(
      "The centre-point curve does not enter ground_pivots_within; nearest is (141.9, 320.6)",
    );

    const two = asking({ground_pivots_within: box, max_length: 50}),
      {relax_together} = explored(two, "min_transmission_angle_deg", 400).map!.census;
    expect(relax_together!.requirements).toEqual(["max_length", "ground_pivots_within"]);
    expect(relax_together).toEqual(solved(two).relax_together);
  });
  test("keeps its map still where the curve splits", () => {
    const moved = (x: number) => tailgate.replace('{"x": -220, "y": 220', `{"x": ${-220 + x}, "y": 220`);
    const frame = (x: number, order: "nearest" | "fresh") =>
      ask("explore", {problem: moved(x), samples: 200, window: whole, property: "link_ratio", order});
    const one = frame(-0.412, "fresh"),
      other = frame(-0.373, "nearest");
    expect(one.task.curves.kappa! < 0).toBe(true);
    expect(other.task.curves.kappa! > 0).toBe(true);
    const changed = one.map!.type.filter(
      (type, i) => type !== other.map!.type[i] || one.map!.defects[i] !== other.map!.defects[i],
    );
    expect(changed.length / 200 ** 2).toBeLessThan(0.1);
    const forced = ask("explore", {
      problem: moved(-0.373),
      samples: 200,
      window: whole,
      property: "link_ratio",
      order: other.task.axes.input.order,
    });
    expect(forced.map!.type).toEqual(other.map!.type);
  });
  test("brings with a map what is picked there: its place stays, τ follows", () => {
    const explore = (problem: string, picked: Picked | null, live = false) =>
      ask("explore", {problem, samples: coarse, window: whole, property: "link_ratio", order: "nearest", picked, live});
    const [before, after] = [-0.412, -0.373].map((x) => tailgate.replace('{"x": -220', `{"x": ${-220 + x}`)); // the curve splits
    const {axes} = explore(before!, null).task,
      place = [0.7, 0.4] as const,
      tau = tau_of_places(axes, place)!,
      asked = {problem: before!, tau};
    const {linkage, live} = explore(before!, {tau, place: null}, true);
    expect([linkage, live!.input]).toEqual([ask("linkage", asked).linkage, ask("live", asked).input]);
    const there = explore(after!, {tau, place}),
      moved = tau_of_places(there.task.axes, place)!;
    expect(moved).not.toEqual(tau);
    expect(there.linkage).toEqual(ask("linkage", {problem: after!, tau: moved}).linkage);
    expect(there.live).toBeNull();
    expect(explore(after!, {tau: [9, 9], place: null}).linkage).toBeNull(); // none of its axes
    expect(explore(after!, null).linkage).toBeNull();
  });
  test("says where its third position may go", () => {
    const {counts, offsets, steps} = ask("halo", {
      problem: tailgate,
      part: 2,
      mode: "move",
      reach: 40,
      steps: 13,
      samples: 60,
    });
    expect(steps).toBe(13);
    expect([offsets[0], offsets[6], offsets[12]]).toEqual([-40, 0, 40]);
    const center = counts[6 * 13 + 6];
    expect(center).toBe(explored(tailgate, "link_ratio", 60).map!.census.meeting);
    expect(counts[6 * 13 + 12]).toBe(0); // at +40 in x
    // What the tour asks for: the last position goes far without all being lost.
    const poses = poses_of(first_example!.problem.task);
    const room = poses.map((_, part) =>
      roomy_squares(
        ask("halo", {problem: tailgate, part, mode: "move", reach: halo_reach(poses), steps: 13, samples: 60}).counts,
      ),
    );
    expect(Math.max(...room)).toBe(room[3]);
    expect(room[3]).toBeGreaterThan(13 ** 2 / 3);
    const turned = ask("halo", {problem: tailgate, part: 2, mode: "turn", reach: 5, steps: 5, samples: 60});
    expect(turned.counts.length).toBe(5);
    expect(turned.counts[2]).toBe(center);
  });
  test("is improved, verified, traced and written", () => {
    const {tau, improved} = ask("improve", at);
    expect(improved).toBe(true);
    const angle = (linkage: Linkage) => linkage.min_transmission_angle_deg!;
    expect(angle(ask("linkage", {problem: tailgate, tau}).linkage)).toBeGreaterThan(angle(ask("linkage", at).linkage));
    expect(ask("verify", {problem: tailgate, tau}).verified).toBe(true);
    expect(ask("trace", {...at, point: [10, 20]}).points.length % 2).toBe(0);
    for (const format of ["svg", "dxf", "csv", "json", "result"] as const) {
      const {text, extension} = ask("export", {...at, format});
      expect(text.length).toBeGreaterThan(1000);
      expect(extension.startsWith(".")).toBe(true);
    }
    const linkage = join(scratch, "linkage.json");
    writeFileSync(linkage, ask("export", {...at, format: "json"}).text);
    expect(run("analyze", linkage)).toContain("Triple rocker");
  });
  test("has the best linkages that the program finds", () => {
    const file = join(scratch, "best.json");
    writeFileSync(file, tailgate);
    const result = JSON.parse(run("solve", file, "-o", "-"));
    const {linkages} = ask("best", {problem: tailgate, most: 10});
    expect(linkages.map(({type}) => type)).toEqual(result.linkages.map((linkage: {type: string}) => linkage.type));
    for (const [i, {tau}] of linkages.entries()) {
      expect(tau[0]).toBeCloseTo(result.linkages[i].input.coordinate, 6);
      expect(tau[1]).toBeCloseTo(result.linkages[i].output.coordinate, 6);
    }
  });
  test("finds the six-bars that the program finds for the same file", () => {
    const file = join(root, "examples/loader_bucket.json"),
      result = JSON.parse(run("solve", file, "-o", "-"));
    const problem = read_problem(JSON.parse(readFileSync(file, "utf8").replace(/^ *\/\/.*$/gm, "")))!,
      last = rounds_of(problem).at(-1)!;
    const {linkages} = ask("best", {problem: engine_text(round_of(problem, last)), most: problem.options?.best ?? 10});
    type Found = {min_transmission_angle_deg: number; chain?: {a: readonly number[]}};
    const numbers = (found: Found) => [found.min_transmission_angle_deg, ...found.chain!.a];
    const same = (one: Found, other: Found) =>
      numbers(one).every((number, k) => Math.abs(number - numbers(other)[k]!) < 5e-7);
    expect(linkages).toHaveLength(result.linkages.length);
    expect(same(linkages[0]!, result.linkages[0])).toBe(true);
    // Last digits differ between the two builds, and a climb may end on another hill.
    const shared = linkages.filter((found) => result.linkages.some((other: Found) => same(found, other)));
    expect(shared.length).toBeGreaterThanOrEqual(0.8 * linkages.length);
  });
  test("is stored for the page to begin with", async () => {
    const stored = stored_start(),
      live = explored(tailgate, stored.map.property, stored.map.samples);
    expect(stored.task.axes.input).toEqual(live.task.axes.input);
    expect(stored.map.type).toEqual(live.map!.type);
    expect(stored.map.fails).toEqual(live.map!.fails);
    expect(stored.task.curves.center.length).toBe(3 * stored.task.curves.tau.length);
    for (const [i, x] of live.task.curves.center.entries())
      expect(Math.abs(stored.task.curves.center[i]! - x)).toBeLessThanOrEqual(1e-7 * Math.abs(x));
    const {linkage} = ask("linkage", {problem: tailgate, tau: stored.linkage.tau});
    for (const [i, x] of linkage.drive!.states.entries())
      expect(Math.abs(stored.linkage.drive!.states[i]! - x)).toBeLessThanOrEqual(1e-7 * Math.abs(x));
    const thumbnail = await load_thumbnails();
    expect(thumbnail("landing_gear")!.linkage!.pivots.length).toBe(4);
    expect(thumbnail("landing_gear")!.type.length).toBe(64 ** 2);
    expect(thumbnail("nothing")).toBeNull();
  });
});
