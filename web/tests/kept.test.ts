// What the page kept and linked to before its contract was generated, whatever it was, is read as it was meant. The file was
// written by the page of 26 November 2026: documents drawn at random as src/state/arbitrary.ts does, in its own words and, beside
// them, plainly.
import {readFileSync} from "node:fs";
import {expect, it} from "vitest";
import {read_fragment} from "../src/shell/share";
import {to_problem, type TaskDocument} from "../src/state/document";
import {read_steps} from "../src/state/steps";

interface Told {
  problem: {task: {kind: string; mechanism: string}};
  place: unknown;
}
interface Kept {
  work: string;
  link: string;
  past: Told[];
  present: Told;
  future: Told[];
  shared: object;
}
const all = JSON.parse(readFileSync(new URL("kept_2026_11_26.json", import.meta.url), "utf8")) as Kept[];
const told = (document: TaskDocument) => ({problem: to_problem(document), place: document.picked?.place ?? null});
/** As files have it. */
const plain = (value: unknown): unknown => JSON.parse(JSON.stringify(value));

it("is of every kind", () => {
  const kinds = new Set(all.map(({present: {problem}}) => `${problem.task.kind} ${problem.task.mechanism}`));
  expect(kinds.size).toBe(9);
});
it.each(all.map((kept, at) => [`${kept.present.problem.task.kind} ${at}`, kept] as const))(
  "is read with its steps: %s",
  (_, {work, past, present, future}) => {
    const read = read_steps(work)!;
    expect(plain([read.past.map(told), told(read.present), read.future.map(told)])).toEqual([past, present, future]);
  },
);
it.each(all.map((kept, at) => [`${kept.present.problem.task.kind} ${at}`, kept] as const))(
  "is found in a link: %s",
  (_, {link, shared}) => {
    const read = read_fragment(link) as {text: string};
    expect(JSON.parse(read.text)).toEqual(shared);
  },
);
