import {describe, expect, it} from "vitest";
import type {Problem} from "../../state/problem";
import type {AnglePair, FunctionTask} from "./task";
import type {Workbench} from "../../state/workbench.svelte";
import {objectives_of, properties_of} from "../kind_dispatch";
import {snapped_mark} from "./dial_handles";
import {function_kind} from "./kind";
import {
  edit_angles,
  rates_of,
  rows_of,
  unstretched,
  with_free,
  with_ground_pivot,
  with_named,
  with_pair,
  with_pairs,
  with_rates,
} from "./pairs";

const pairs: AnglePair[] = [
  {input_deg: 0, output_deg: 10},
  {input_deg: 20, output_deg: 30},
  {input_deg: 40, output_deg: 45},
  {input_deg: 60, output_deg: 50},
];
const named = {expression: "x^2", x: [0, 1], input_range_deg: [0, 60], output_range_deg: [0, 90], points: 4} as const;
const task: FunctionTask = {kind: "function", mechanism: "four_bar", function: named};
const problem: Problem = {linkwright: 1, task, options: {objective: "structural_error"}};

it("many megabytes of rows are read to the last digit before anyone notices", () => {
  const rows = Array.from({length: 200_000}, (_, i) => [i / 7, Math.sin(i) / 3e4] as const);
  for (const between of ["\t", ", "]) {
    const text = rows.map(([x, y]) => `${x}${between}${y}`).join("\n"),
      start = performance.now(),
      read = rows_of(text);
    expect(performance.now() - start).toBeLessThan(2000); // a tenth of it on a quiet machine; it took ten times as long
    expect([read?.length, read?.[123_456]], between).toEqual([200_000, rows[123_456]]);
  }
});

describe("pairs", () => {
  it("take the place of a named function, whose error is no objective then", () => {
    const changed = with_pair(problem, pairs, 1, {output_deg: 31});
    expect(changed.task).toEqual({
      kind: "function",
      mechanism: "four_bar",
      pairs: pairs.map((pair, i) => (i === 1 ? {...pair, output_deg: 31} : pair)),
    });
    expect(JSON.parse(JSON.stringify(changed)).options).toEqual({});
    const back = with_named(changed, named);
    expect(back.task).toEqual(task);
    expect(objectives_of(changed)).not.toContain("structural_error");
    expect(objectives_of({task})[0]).toBe("structural_error");
  });
  it("leave a number free only while they are four", () => {
    const free = with_free(problem, {number: "output_scale", range: [0.5, 2]});
    expect(properties_of(free)).not.toContain("max_structural_error_deg");
    expect(function_kind.map_of(free.task as FunctionTask)).not.toBe(function_kind.map_of(task));
    expect(with_named(free, {...named, points: 5}).task).not.toHaveProperty("free");
    expect(with_pairs(free, pairs).task).toHaveProperty("free");
    expect(with_pairs(free, [...pairs, {input_deg: 80, output_deg: 60}]).task).not.toHaveProperty("free");
    expect(with_pairs(free, [with_rates(pairs[0]!, [1]), ...pairs.slice(1)]).task).not.toHaveProperty("free");
    expect(with_free(free, null).task).toEqual(task);
  });
  it("say so where they take the free number away", () => {
    const said: string[] = [];
    const bench = {
      problem: with_free(with_pairs(problem, pairs), {number: "output_scale"}),
      say: (key: string) => said.push(key),
      edit(change: (of: Problem) => Problem) {
        this.problem = change(this.problem);
      },
    };
    const edit = (list: AnglePair[]) => edit_angles(bench as unknown as Workbench, (of) => with_pairs(of, list));
    edit(pairs.map((pair) => ({...pair, output_deg: pair.output_deg + 1})));
    expect(said).toEqual([]);
    edit([...pairs, {input_deg: 80, output_deg: 60}]);
    expect(said).toEqual(["function.free_dropped"]);
  });
  it("keep the other ground pivot", () => {
    const moved = with_ground_pivot(problem, {input: [0, 0], output: [100, 0]}, "output", [90, 20]);
    expect((moved.task as FunctionTask).ground_pivots).toEqual({input: [0, 0], output: [90, 20]});
  });
  it("have rates by the input angle, whatever they were given by", () => {
    const [pair] = pairs;
    expect(rates_of(with_rates(pair!, [0.5, -2]))).toEqual([0.5, -2]);
    expect(with_rates(with_rates(pair!, [1]), [])).toEqual(pair);
    // φ = t², ψ = t⁴ = φ² at t = 1, derivatives by t
    expect(
      rates_of({
        ...pair!,
        derivatives: [
          {input: 2, output: 4},
          {input: 2, output: 12},
        ],
      }),
    ).toEqual([2, 2]);
    // φ = t², ψ = t⁸ = φ⁴ there, derivatives by t
    const four = {
      ...pair!,
      derivatives: [
        {input: 2, output: 8},
        {input: 2, output: 56},
        {input: 0, output: 336},
        {input: 0, output: 1680},
      ],
    };
    expect(rates_of(four)).toEqual([4, 12, 24, 24]);
    expect(rates_of(with_rates(pair!, [0.5, -2, 3, 4]))).toEqual([0.5, -2, 3, 4]);
    expect(function_kind.pattern(with_pairs(problem, [with_rates(pair!, [1]), pairs[1]!]).task as FunctionTask)).toBe(
      "PP-P",
    );
    expect(function_kind.pattern(task)).toBe("P-P-P-P");
  });
  it("are read off a stretched dial", () => {
    const shown = pairs.map(({input_deg, output_deg}) => [input_deg, 10 + 2 * (output_deg - 10)] as const);
    expect(unstretched(pairs, shown, 2, 90)).toBe(50);
  });
  it("come in rows of two numbers", () => {
    expect(rows_of("φ\tψ\n0\t1,5\n20\t3")).toEqual([
      [0, 1.5],
      [20, 3],
    ]);
    expect(rows_of("0;1,5\r\n=2*10;3\r\n")).toEqual([
      [0, 1.5],
      [20, 3],
    ]);
    expect(rows_of("1e99 2")).toBeNull();
    expect(rows_of("1 2 3\n4 5 6")).toBeNull();
    expect(rows_of("hello")).toBeNull();
  });
  it("snap to whole degrees, or as the keys say", () => {
    const keys = {shift: false, alt: false, fine: false};
    expect(snapped_mark(200.4, true, keys)).toBe(200);
    expect(snapped_mark(200.44, true, {...keys, fine: true})).toBe(200.4);
    expect(snapped_mark(200.4, true, {...keys, shift: true})).toBe(195);
    expect(snapped_mark(200.4444, false, keys)).toBe(200.444);
  });
});
