import {readFileSync} from "node:fs";
import {expect, it} from "vitest";
import type {Problem} from "../../state/problem";
import {bench, settled} from "../../state/workbench_bench";
import {desk_of} from "./desk.svelte";

const wing = JSON.parse(
  readFileSync(new URL("../../../../examples/folding_wing.json", import.meta.url), "utf8").replace(/^\/\/.*$/gm, ""),
) as Problem;

it("adds one orientation however fast it is asked twice, beside the last and in its form", async () => {
  const b = bench(wing),
    desk = desk_of(b.workbench);
  await settled(b);
  await Promise.all([desk.add(), desk.add()]);
  const orientations = desk.task!.orientations;
  expect(orientations).toHaveLength(5);
  expect(orientations[4]).toMatchObject({sequence: "xyz"});
  expect(orientations[4]).not.toEqual(orientations[3]);
  b.workbench.undo();
  expect(desk.task!.orientations).toHaveLength(4);
});
