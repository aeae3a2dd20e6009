// What the engine exports is what the page opens.
import {beforeAll, describe, expect, it} from "vitest";
import {load_module} from "../engine/node";
import type {Session} from "../engine/module";
import {examples, first_example} from "../gallery/gallery";
import {engine_text, type Problem} from "../state/problem";
import {read_problem} from "../state/problem_shape";
import {told} from "./own_files";

let session: Session;
beforeAll(async () => void (session = new (await load_module()).Session()));

interface Best {
  tau: [number, number];
}
function exported(problem: Problem, format: string): {tau: [number, number]; text: string} {
  expect(session.set_problem(engine_text(problem))).toBe(true);
  const {tau} = (JSON.parse(session.best(1)) as {linkages: Best[]}).linkages[0]!;
  return {tau, text: session.exported(...tau, format)};
}
const opened = (text: string) => {
  const found = told("x.json", text.slice(0, 4096), text);
  return {kind: found.kind, problem: "text" in found ? read_problem(JSON.parse(session.read(found.text))) : null};
};

describe("an export that is opened", () => {
  it("as a result has its task, with the linkage in hand", () => {
    for (const name of ["tailgate", "log_generator", "latch"]) {
      const {problem} = examples.find((example) => example.name === name) ?? first_example,
        {tau, text} = exported(problem, "result");
      const {kind, problem: read} = opened(text);
      expect([name, kind, read?.view?.picked, read?.view?.pins]).toEqual([name, "result", tau, undefined]);
      expect(read?.task).toEqual(problem.task);
    }
  });
  it("as a result of several linkages has them pinned", () => {
    const {text} = exported(first_example.problem, "result"),
      file = JSON.parse(text);
    file.linkages.push(file.linkages[0], {mechanism: "four_bar"});
    const {problem} = opened(JSON.stringify(file));
    expect(problem!.view!.pins!.map(({name, type, longest}) => [name, type, Math.round(longest!)])).toEqual([
      ["A", "triple_rocker_input", 252],
      ["B", "triple_rocker_input", 252],
    ]);
  });
  it("as a result of several spherical linkages has them pinned by their axes", () => {
    for (const name of ["wrist_orthosis", "universal_joint_like"]) {
      const {text} = exported(examples.find((example) => example.name === name)!.problem, "result"),
        file = JSON.parse(text);
      file.linkages.push(file.linkages[0]);
      const [pin] = opened(JSON.stringify(file)).problem!.view!.pins!,
        {input, output} = file.linkages[0];
      expect(pin!.pivots, name).toEqual({
        input_fixed: input.fixed_axis,
        input_moving: input.moving_axis,
        output_fixed: output.fixed_axis,
        output_moving: output.moving_axis,
      });
    }
  });
  it("as a linkage has its positions for a task", () => {
    const {tau, text} = exported(first_example.problem, "json"),
      {kind, problem} = opened(text);
    expect([kind, problem!.view!.picked, problem!.length_unit]).toEqual(["linkage", tau, "mm"]);
    expect(problem!.task).toEqual(first_example.problem.task);
  });
  it("as a linkage that does not hold its task is opened as one", () => {
    for (const name of ["log_generator", "wheel_loader", "wrist_orthosis"]) {
      const {problem: sought} = examples.find((example) => example.name === name)!,
        {kind, problem} = opened(exported(sought, "json").text);
      expect([kind, problem?.task.kind, problem?.task.mechanism]).toEqual([
        "lone_linkage",
        "linkage",
        sought.task.mechanism,
      ]);
      expect(session.set_problem(engine_text(problem!))).toBe(true);
      const found = session.linkage(0, 0),
        {travel, rates} = JSON.parse(found.linkage);
      expect(found.states.length, name).toBeGreaterThan(100 * (travel.width ?? 13));
      expect(rates.rows.length).toBe(found.states.length / (travel.width ?? 13));
    }
  });
  it("is a linkage with comments, by its lengths, pivots, axes or angles", () => {
    const files = [
      '// of a book\n{"lengths": {"ground": 3.5, "input": 1, "coupler": 3, "output": 2.5}}',
      '{"pivots": {"input_center": [0, 0], "input_circle": [0, 1], "output_center": [4, 0], "output_circle": [5, 3]}}',
      '{"mechanism": "spherical_four_bar", "angles_deg": {"ground": 90, "input": 30, "coupler": 80, "output": 70}}',
    ];
    for (const file of files) expect(opened(file).problem?.task.kind, file).toBe("linkage");
    const found = told("x.json", "", '{"lengths": {"ground": 9, "input": 1, "coupler": 1, "output": 1}}');
    expect("text" in found && session.read(found.text)).toBe("");
    expect(JSON.parse(session.mistakes())[0]).toMatchObject({code: "cannot_be_assembled", place: "task.file.lengths"});
  });
  it("as a drawing or a table is said to be one, by what is in it or by its name", () => {
    for (const [format, kind] of [
      ["dxf", "drawing"],
      ["svg", "drawing"],
    ] as const) {
      const {text} = exported(first_example.problem, format);
      expect(told("renamed.txt", text.slice(0, 4096), text), format).toEqual({kind});
    }
    expect(told("motion.csv", "phi,x", "phi,x")).toEqual({kind: "table"});
    expect(told("poses.txt", "0 0 0\n60 35 22", "0 0 0\n60 35 22")).toEqual({kind: "table"});
    expect(told("a", "\x89PNG\r\n", null)).toEqual({kind: "drawing"});
    expect(told("hinge.txt", "ISO-10303-21;\nHEADER;", "ISO-10303-21;\nHEADER;")).toEqual({kind: "solid"});
    expect(told("part.STL", "\0\0", null)).toEqual({kind: "solid"});
    expect(told("sheet", "%PDF-1.7", null)).toEqual({kind: "other"});
    expect(told("poses.xlsx", "PK", null)).toEqual({kind: "other"});
    expect(told("a", "GIF89a", null)).toEqual({kind: "film"});
    expect(told("a.webm", "\x1a\x45\xdf\xa3", null)).toEqual({kind: "film"});
    expect(told("a", "\0\0\n\x20ftypisom", null)).toEqual({kind: "film"});
  });
  it("that is none of these is read as a problem", () => {
    const text = JSON.stringify(first_example.problem);
    expect(told("task.json", text, text)).toEqual({kind: "problem", text});
    expect(told("task.csv", text, text)).toEqual({kind: "problem", text});
    expect(told("task.txt", text, text)).toEqual({kind: "problem", text});
    expect(told("broken.json", '{"linkages":', '{"linkages":')).toEqual({kind: "problem", text: '{"linkages":'});
  });
});
