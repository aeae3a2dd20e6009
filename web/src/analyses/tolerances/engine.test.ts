// Tolerances as the engine of the page takes them.
import {describe, expect, test} from "vitest";
import {criteria_of} from "../analysis_dispatch";
import {suggested_limit, suggested_tolerances} from "./editing";
import {sampled_cells} from "../../region/sampled";
import {first_example} from "../../gallery/gallery";
import {engine_text} from "../../state/problem";
import {incompleteness, properties_of, kind_of, requirements_of, task_kinds} from "../../kinds/kind_dispatch";
import {ask, explored} from "../../../tests/asked_engine";

describe("yields", () => {
  const problem = engine_text({
    ...first_example!.problem,
    tolerances: {length: 0.5, limit: {position: 2}, samples: 1000},
  });
  const values = () => explored(problem, "yield", 60).map!;

  test("are sampled in the order in which the map tells them apart", () => {
    explored(problem, "yield", 60);
    const {done, total} = ask("yields", {problem, cells: 40}),
      some = values();
    expect(done).toBe(40);
    expect(total).toBe(some.census.meeting);
    const sampled = sampled_cells(some, done, 0);
    while (ask("yields", {problem, cells: 1000}).done < total);
    const all = values().value;
    expect(sampled_cells(some, total, 0).reduce((sum, is) => sum + is, 0)).toBe(total);
    const changed = [...all.keys()].filter((cell) => all[cell] !== some.value[cell]);
    expect(changed.length).toBeGreaterThan(total / 10);
    expect(changed.filter((cell) => sampled[cell])).toEqual([]);
  });
});

describe("suggested tolerances", () => {
  const beginnings = task_kinds
    .flatMap((kind) => (kind.analysed?.tolerances ? kind.beginnings : []))
    .map(({id, make}) => ({id, problem: make()}))
    .filter(({problem}) => incompleteness(problem) === null);

  test.each(beginnings)("and the limit are what the engine takes, requirements and all: $id", ({problem}) => {
    const made = {...problem, tolerances: suggested_tolerances(problem.task)},
      asked = {...made, tolerances: {...made.tolerances, limit: suggested_limit(made)}};
    const keys = requirements_of(problem.task),
      required = {...asked, requirements: {...asked.requirements, max_tolerance_error: 1e6, min_yield: 0.01}};
    const known = Object.entries(criteria_of(kind_of(problem.task)).requirements).flatMap(([key, {is_of}]) =>
      (is_of?.(problem.task) ?? true) ? key : [],
    );
    expect([...keys].filter((key) => known.includes(key)).sort()).toEqual(known.sort());
    expect(keys).toEqual(expect.arrayContaining(["max_tolerance_error", "min_yield"]));
    expect(properties_of(asked)).toEqual(expect.arrayContaining(["tolerance_error", "yield"]));
    for (const objective of ["tolerance_error", "yield"] as const) {
      const text = engine_text({...required, options: {...required.options, objective}}),
        {map} = explored(text, "tolerance_error", 20);
      expect(Object.keys(map!.census.only)).toEqual([...keys]);
    }
  });
});
