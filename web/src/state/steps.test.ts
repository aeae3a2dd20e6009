import fc from "fast-check";
import {describe, expect, it} from "vitest";
import * as arbitrary from "./arbitrary";
import {from_problem, to_problem, type TaskDocument} from "./document";
import {most_pins, with_view} from "./problem";
import {read_problem} from "./problem_shape";
import {read_steps, steps_text} from "./steps";
import {new_problem} from "../kinds/motion/kind";

/** As it is written: without members that are undefined. */
const written = <T>(value: T): T => JSON.parse(JSON.stringify(value));

describe("every state", () => {
  it("comes back from a file as it was", () => {
    fc.assert(
      fc.property(arbitrary.document, (document) => {
        const file = written(to_problem(document)),
          again = from_problem(read_problem(file)!);
        const placeless = {...document, picked: document.picked && {...document.picked, place: null}}; // it follows from τ
        expect(written(again)).toEqual(written(placeless));
        expect(written(to_problem(again))).toEqual(file);
      }),
      {numRuns: 300, seed: 1},
    );
  });
  it("comes back from the browser's store with all its steps", () => {
    fc.assert(
      fc.property(arbitrary.steps, (steps) => {
        expect(written(read_steps(steps_text(steps, 7)))).toEqual(written({...steps, at: 7}));
      }),
      {numRuns: 100, seed: 1},
    );
  });
});

describe("what is stored", () => {
  const image = `data:image/png;base64,${"A".repeat(10_000)}`;
  const document: TaskDocument = from_problem(
    with_view(new_problem(), {background: {image, x: 0, y: 0, width: 1, aspect: 1}}),
  );
  const step = (i: number): TaskDocument => ({...document, picked: {tau: [i, 0], place: null}});
  const steps = {past: Array.from({length: 700}, (_, i) => step(i)), present: step(700), future: [step(701)]};

  it("has what steps have in common once, and of more than enough steps the last", () => {
    const text = steps_text(steps, 0);
    expect(text.length).toBeLessThan(130_000);
    const read = read_steps(text)!;
    expect([read.past.length, read.past[0]!.picked!.tau[0], read.present.picked!.tau[0], read.future.length]).toEqual([
      500, 200, 700, 1,
    ]);
    expect(read.past[499]!.problem.view!.background!.image).toBe(image);
    expect(read.past[0]!.problem.task).toBe(read.past[499]!.problem.task); // and once in memory: a table may be long
  });
  it("is read step by step: what is damaged is left out", () => {
    const value = JSON.parse(steps_text({...steps, past: steps.past.slice(-3)}, 0));
    value.past[1] = {problem: {task: 9999}};
    value.past.push(null, 3, {problem: "x", view: 1, pins: {}});
    value.future = "none";
    const read = read_steps(JSON.stringify(value))!;
    expect([read.past.map(({picked}) => picked!.tau[0]), read.present.picked!.tau[0], read.future]).toEqual([
      [697, 699],
      700,
      [],
    ]);
  });
  it("is read where an older page has written it", () => {
    expect(read_steps(JSON.stringify({version: 1, problem: new_problem()}))).toEqual({
      past: [],
      present: from_problem(new_problem()),
      future: [],
      at: 0,
    });
  });
  it("keeps as many pins as can be made", () => {
    const [pin] = fc.sample(
      arbitrary.pins.filter((pins) => pins.length > 0),
      {numRuns: 1, seed: 1},
    )[0]!;
    const pins = Array.from({length: most_pins}, (_, i) => ({...pin!, name: `pin ${i}`}));
    expect(read_steps(steps_text({past: [], present: {...document, pins}, future: []}, 0))!.present.pins).toHaveLength(
      most_pins,
    );
  });
});
