import {describe, expect, it} from "vitest";
import type {Linkage, Point} from "../../contract/messages";
import type {Chain} from "./task";
import type {SixBar} from "./replies";
import {body_point, placed} from "../../state/problem";
import type {Problem} from "../../state/problem";
import {poses_of} from "../../state/task";
import {incompleteness} from "../kind_dispatch";
import {six_bar as mechanism} from "./figure";
import {
  default_box,
  elbow_of,
  elbows,
  guided_hinges,
  row_of,
  rows,
  with_hinge,
  with_other_elbow,
  with_six_bar,
} from "./chain";
import {six_bar_kind} from "./kind";
import {round_of, rounds_of} from "./search.svelte";

const chain: Chain = {a: [0, 0], b: [5, 5], d: [10, 0]};
const problem = six_bar_kind.beginnings[0]!.make();

describe("the chain", () => {
  it("has its elbow on the left or on the right of the line from a to d", () => {
    expect(elbow_of(chain)).toBe(1);
    expect(elbow_of({...chain, b: [5, -5]})).toBe(-1);
    expect(elbows(chain)).toEqual([1, 1, 1, 1]);
    expect(elbows({...chain, elbow: [1, 0, -1, 1]})).toEqual([1, 1, -1, 1]);
  });
  it("is folded the other way in one position, and back", () => {
    const folded = with_other_elbow(chain, 2);
    expect(folded.elbow).toEqual([1, 1, -1, 1]);
    expect(with_other_elbow(folded, 2)).toEqual(chain);
  });
  it("turns all its elbows over where b crosses the line", () => {
    const folded = with_other_elbow(chain, 2);
    expect(with_hinge(folded, "b", [5, -5]).elbow).toEqual([-1, -1, 1, -1]);
    expect(with_hinge(folded, "b", [4, 1]).elbow).toEqual(folded.elbow);
    expect(with_hinge(chain, "b", [5, -5])).not.toHaveProperty("elbow");
  });
  it("has its last hinge on the body", () => {
    const [first, second] = guided_hinges(
      with_six_bar(problem, {
        poses: [
          {x: 0, y: 0, theta_deg: 0},
          {x: 1, y: 2, theta_deg: 90},
        ],
        chain,
      }),
    );
    expect(first).toEqual([10, 0]);
    expect(second![0]).toBeCloseTo(1, 12);
    expect(second![1]).toBeCloseTo(12, 12);
  });
  it("is missing in a task that is searched, and needs four positions", () => {
    const state = (change: Partial<Parameters<typeof with_six_bar>[1]>) =>
      incompleteness(with_six_bar(problem, change))?.state ?? null;
    expect(state({})).toBeNull();
    expect(state({chain: undefined})).toBe("no_chain");
    expect(state({poses: poses_of(problem.task).slice(1)})).toBe("too_few");
    expect(state({poses: []})).toBe("empty");
  });
});

describe("the added links", () => {
  it("are the eleven rows of four kinds of six-bars", () => {
    expect(new Set(rows.map(({added}) => added.join())).size).toBe(11);
    expect(new Set(rows.map(({topology}) => topology))).toEqual(
      new Set(["watt_1", "stephenson_1", "stephenson_2", "stephenson_3"]),
    );
    expect(row_of(["2-0", "3-4"])).toBe(rows[2]);
    expect(row_of(["0-1", "0-3"])).toBeNull();
  });
});

describe("what carries an added link's end", () => {
  // Bodies: 2 has b, d and z4; link 4 is c4-z4 with c4 on the ground.
  const at: Point[] = [
    [0, 0],
    [5, 5],
    [10, 0],
    [3, -4],
    [8, 8],
    [1, 1],
    [12, 3],
  ];
  const six_bar = {
    joints: at.map((point, i) => ({name: String(i), ground: i === 0 || i === 3, at: point})),
    bodies: [
      [0, 3],
      [0, 1, 5],
      [1, 2, 4],
      [2, 6],
      [3, 4],
      [5, 6],
    ],
  } as unknown as SixBar;
  const moved = (point: Point) => placed(body_point(point, {x: 0, y: 0, theta_deg: 0}), {x: 7, y: -2, theta_deg: 33});
  const carrier = (side: "input" | "output", end: "center" | "circle") =>
    mechanism.carrier(
      {six_bar} as Linkage,
      side,
      end,
      {
        pose: {x: 0, y: 0, theta_deg: 0},
        turned_deg: 0,
        joints: at.map(moved),
        ends: {input: {center: null, circle: null}, output: {center: null, circle: null}},
      },
      {x: 0, y: 0, theta_deg: 0},
    );
  it("is nothing on the ground", () => expect(carrier("input", "center")).toBeNull());
  it("is the other body of the hinge", () => {
    for (const [side, end, joint] of [
      ["input", "circle", 4],
      ["output", "center", 5],
      ["output", "circle", 6],
    ] as const) {
      const {first, now} = carrier(side, end)!,
        there = placed(body_point(at[joint]!, first), now),
        wanted = moved(at[joint]!);
      expect(there[0]).toBeCloseTo(wanted[0], 9);
      expect(there[1]).toBeCloseTo(wanted[1], 9);
    }
  });
});

describe("a search", () => {
  const asked: Problem = {...problem, options: {seed: 5, effort: 2300, box: {x: [0, 1], y: [2, 3]}}};
  it("goes by rounds of more and more chains, the last of which is what the file asks", () => {
    expect(rounds_of(asked)).toEqual([575, 2300]);
    expect(rounds_of({...problem, options: {effort: 800}})).toEqual([800]);
    const {seed, effort} = round_of(asked, 2300).options!;
    expect([seed, effort]).toEqual([5, 2300]);
    expect(round_of(asked, 575).options!.box).toEqual({x: [0, 1], y: [2, 3]});
    expect(round_of(asked, 575).task).not.toHaveProperty("chain", expect.anything());
    expect(round_of({...problem, options: {}}, 1).options!.box).toEqual(default_box(problem));
  });
  it("tries little more than what is asked before the last round", () => {
    for (const effort of [1, 1000, 1001, 200_000, 1_000_000]) {
      const rounds = rounds_of({...problem, options: {effort}});
      expect(rounds.at(-1)).toBe(effort);
      expect(rounds.slice(0, -1).reduce((sum, chains) => sum + chains, 0)).toBeLessThan(effort / 2);
    }
  });
});
