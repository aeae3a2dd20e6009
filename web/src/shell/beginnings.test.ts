// What a new task begins with does what it requires itself, by the engine's count.
import {expect, it} from "vitest";
import {bench, until} from "../state/workbench_bench";
import {incompleteness, seeks_linkages} from "../kinds/kind_dispatch";
import {beginnings} from "./new_task";

const asked = beginnings
  .map(({id, make}) => ({id, problem: make()}))
  .filter(({problem}) => seeks_linkages(problem.task) && !incompleteness(problem));

it.each(asked)("$id meets its own requirements", async ({problem}) => {
  const {workbench} = bench(problem);
  await until(() => workbench.census);
  expect(workbench.census!.meeting).toBeGreaterThan(0);
});
