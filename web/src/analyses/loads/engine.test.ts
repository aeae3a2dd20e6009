// Loads as the engine of the page takes them.
import {describe, expect, test} from "vitest";
import {criteria_of} from "../analysis_dispatch";
import {degenerate, type Box, type Replies, type TauPair} from "../../contract/messages";
import type {LoadsReply} from "../../contract/replies";
import {engine_text, type Problem} from "../../state/problem";
import {
  incompleteness,
  kind_of,
  objectives_of,
  properties_of,
  requirements_of,
  task_kinds,
} from "../../kinds/kind_dispatch";
import {ask, explored, reply} from "../../../tests/asked_engine";
import {criteria} from "./criteria";
import {effort_of} from "./effort";
import {boxes_text, length_lines, stud_ends, usual_wanted, wanted_lines, with_placed} from "./placing";
import {read_out_rows} from "./read_outs";
import {suggested_case, suggested_cylinder, suggested_extra, suggested_loads, suggested_spring} from "./suggested";
import {cases_of, type Loads} from "./block";

const beginnings = task_kinds
  .flatMap((kind) => (kind.analysed?.loads ? kind.beginnings : []))
  .map(({id, make}) => ({id, problem: make()}))
  .filter(({problem}) => incompleteness(problem) === null);
/** The loads with which a task begins, a spring and two more cases added. */
function loaded(problem: Problem): Problem & {loads: Loads} {
  const begun = {...problem, loads: suggested_loads(problem)},
    sprung = {...begun.loads, springs: [suggested_spring(begun)]},
    cold = {...sprung, cases: [...cases_of(sprung), suggested_case(sprung)]};
  return {...begun, loads: {...cold, cases: [...cold.cases, suggested_case(cold)]}};
}

describe("suggested loads", () => {
  test("are of the kinds that have a four-bar in the plane", () => expect(beginnings.length).toBeGreaterThan(5));
  test.each(beginnings)("are what the engine takes, requirements and all: $id", ({problem}) => {
    const asked = loaded(problem),
      keys = requirements_of(problem.task);
    const required = {
      ...asked,
      requirements: {
        ...asked.requirements,
        max_open_force: 1e6,
        max_close_force: 1e6,
        min_hold_open: -1e6,
        max_pin_force: 1e6,
      },
    };
    expect(keys.filter((key) => key in criteria.requirements)).toEqual(Object.keys(criteria.requirements));
    const known = Object.entries(criteria_of(kind_of(problem.task)).requirements).flatMap(([key, {is_of}]) =>
      (is_of?.(problem.task) ?? true) ? key : [],
    );
    expect(known.sort()).toEqual([...keys].sort());
    expect(properties_of(asked)).toEqual(
      expect.arrayContaining(["hand_force", "max_open_force", "max_close_force", "hold_open", "max_pin_force"]),
    );
    for (const objective of ["hand_force", "hold_open", "pin_force"] as const) {
      expect(objectives_of(asked)).toContain(objective);
      const text = engine_text({...required, options: {...required.options, objective}}),
        {map} = explored(text, "hand_force", 16);
      expect(Object.keys(map!.census.only)).toEqual([...keys]);
    }
  });
  /** By a cylinder, with springs and extra loads of each kind. */
  function of_every_kind(problem: Problem) {
    const begun = {...problem, loads: suggested_loads(problem)},
      springs = (["coil", "torsion"] as const).map((kind) => ({...suggested_spring(begun, kind), name: kind})),
      extra = (["mass", "force"] as const).map((by) => suggested_extra(begun.loads, by)),
      drive = {cylinder: suggested_cylinder(begun)};
    return explored(engine_text({...begun, loads: {...begun.loads, springs, extra, drive}}), "cylinder_force", 8).map!;
  }
  test.each(beginnings)("of every kind are what the engine takes: $id", ({problem}) => {
    expect(of_every_kind(problem).type.some((type) => type !== degenerate)).toBe(true);
  });
  test("have a force of the cylinder where it does not pass across its own line, as it may in all of few linkages", () => {
    const moved = beginnings.filter(({problem}) => of_every_kind(problem).value.some((force) => force > 0));
    expect(moved.length).toBeGreaterThan(2);
  });
  test("driven by a crank are told by its torque", () => {
    const {loads, ...problem} = loaded(beginnings[0]!.problem),
      {handle: _, ...bare} = loads,
      driven = {...problem, loads: {...bare, drive: "input" as const}, requirements: {max_torque: 1e6}};
    expect(properties_of(driven)).not.toContain("hand_force");
    expect(objectives_of(driven).slice(-2)).toEqual(["pin_force", "torque"]);
    const text = engine_text({...driven, options: {objective: "torque"}}),
      {map} = explored(text, "max_torque", 16);
    expect(map!.value.some((torque) => torque > 0)).toBe(true);
  });
});

describe("the forces of a linkage", () => {
  const asked = loaded(beginnings[0]!.problem),
    problem = engine_text(asked);
  /** Where the map has a linkage like this. */
  function place(is_like: (defects: number) => boolean): TauPair {
    const {defects, columns, input_tau, output_tau, type} = explored(problem, "hand_force", 30).map!,
      cell = defects.findIndex((bits, i) => type[i] !== degenerate && is_like(bits));
    return [input_tau[Math.floor(cell / columns)]!, output_tau[cell % columns]!];
  }

  test("come with their curves, and as rows of words", () => {
    const reply = ask("loads", {problem, tau: place((defects) => defects === 0)});
    if (!reply.loads) throw new Error("it gets through");
    const effort = effort_of(reply)!,
      {cases} = reply.loads;
    expect(effort.cases.map(({name}) => name)).toEqual(cases_of(asked.loads).map(({name}) => name));
    expect(effort.positions.map(({position}) => position)).toEqual([1, 2, 3, 4]);
    expect(Math.max(...effort.cases.flatMap(({open}) => open.map((value) => value ?? 0)))).toBeCloseTo(
      Math.max(...cases.map((of) => of.max_open_force!)),
      1,
    );
    const limits = {max_open_force: -1e6, min_hold_open: 1e6},
      rows = read_out_rows(reply.loads, {cases: cases_of(asked.loads), requirements: limits, unit: "mm"});
    expect(rows.filter(({values}) => values.some(({limit}) => limit)).map(({key}) => key)).toEqual([
      "max_open_force",
      "hold_open",
    ]);
    expect(rows.find(({key}) => key === "max_pin_force")!.values[0]!.text).toMatch(/^[\d.]+ N, (input|output), /);
    expect(rows.map(({key}) => key)).toEqual(
      expect.arrayContaining(["max_close_force", "max_pin_force", "stroke_left_1"]),
    );
  });
  test("are none of a linkage that does not get through, and without loads", () => {
    expect(ask("loads", {problem, tau: place((defects) => defects !== 0)})).toEqual({loads: null});
    const {loads: _, ...bare} = asked;
    expect(ask("loads", {problem: engine_text(bare), tau: place((defects) => defects === 0)})).toEqual({loads: null});
  });
});

describe("a spring to be placed", () => {
  const without_defects = (problem: string): TauPair | null => {
    const {defects, columns, input_tau, output_tau, type} = explored(problem, "hand_force", 30).map!,
      cell = defects.findIndex((bits, i) => type[i] !== degenerate && bits === 0);
    return cell < 0 ? null : [input_tau[Math.floor(cell / columns)]!, output_tau[cell % columns]!];
  };

  test.each(beginnings)("is at first one that the engine takes, in boxes with a map: $id", ({problem}) => {
    const text = engine_text(loaded(problem)),
      tau = without_defects(text);
    if (!tau) return;
    for (const choice of [0, "new"] as const)
      for (const stud of stud_ends) {
        const boxes = boxes_text(usual_wanted(loaded(problem), choice)!),
          answer = reply("stud_map", {problem: text, tau, boxes, stud, columns: 4, rows: 3});
        expect(answer).not.toHaveProperty("refused");
        const {map} = answer as Replies["stud_map"];
        if (map) expect(map.force).toHaveLength(12);
      }
  });
  const asked = loaded(beginnings[0]!.problem),
    problem = engine_text(asked),
    usual = usual_wanted(asked, 0)!;

  test("takes the hand the force that is told of it", () => {
    const tau = without_defects(problem)!,
      small = {...usual, ground: shrunk(usual.ground), body: shrunk(usual.body)}; // soon proved
    const {placed} = ask("place_spring", {problem, tau, boxes: boxes_text(small)});
    expect(placed).toMatchObject({proven: true, spring: {kind: "gas", name: usual.name}});
    const taken = {...asked, loads: with_placed(asked.loads, 0, placed!.spring!)},
      {loads: report} = ask("loads", {problem: engine_text(taken), tau}) as LoadsReply;
    const forces = report.cases.flatMap(({max_open_force, max_close_force}) => [max_open_force!, max_close_force!]);
    expect(Math.max(...forces)).toBeCloseTo(placed!.max_hand_force!, 2);
    expect(placed!.lower_bound!).toBeLessThanOrEqual(placed!.at_stations!);
  });
  test("has mistakes told where there are fields", () => {
    const wrong = {...usual, ratio: 0.5, friction: -1, end_margin: 1e-6, ground: {x: [1, 0], y: [0, 1]} as const},
      lines = [...wanted_lines(wrong, null), ...length_lines(wrong, "mm")];
    const fields = [...lines.map(({place}) => place), "ground.x", "ground.y"];
    const boxes = boxes_text(wrong),
      answer = reply("place_spring", {problem, tau: without_defects(problem)!, boxes}),
      places = "refused" in answer ? answer.refused.map(({place}) => place) : [];
    expect(places).not.toEqual([]);
    expect(places.filter((place) => !fields.includes(place))).toEqual([]);
  });
});
function shrunk({x, y}: Box): Box {
  const middle = ([low, high]: readonly [number, number]) => (low + high) / 2;
  return {x: [middle(x) - 1, middle(x) + 1], y: [middle(y) - 1, middle(y) + 1]};
}
