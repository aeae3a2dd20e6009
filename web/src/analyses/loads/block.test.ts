import {describe, expect, it} from "vitest";
import {body_point} from "../../state/problem";
import {cases_of, counts_for, drive_of, friction_of, has_of, read_loads, type Loads} from "./block";
import {all, strut, stud} from "./example";
import {moved_loads} from "./moved";

describe("loads", () => {
  it("are read as files have them", () => {
    expect(read_loads(all)).toEqual(all);
    expect(read_loads({gravity: null, drive: "output"})).toEqual({gravity: null, drive: "output"});
  });
  it("are read member by member", () => {
    const wrong = {
      gravity: 9.81,
      body: {mass: -1},
      links: {input: {}, coupler: {kg_per_m: 1, odd: 2}},
      handle: {point: [1]},
      springs: [{kind: "gas"}, {...strut, F1: 0}, {kind: "air"}, null, strut],
      extra: [{name: "x", on: "body", at: [0, 0]}],
      drive: "wind",
      cases: [{temperature_C: 5}, {name: "hot", for: ["hump", "odd"]}],
      stations: 0,
      constructor: 3,
    };
    expect(read_loads(wrong)).toEqual({
      links: {coupler: {kg_per_m: 1}},
      springs: [strut],
      extra: [],
      cases: [{name: "hot", for: ["hump"]}],
    });
    for (const none of [null, undefined, 3, [], "x"]) expect(read_loads(none)).toBeNull();
  });
  it("have a case, whatever is given", () => {
    expect(cases_of({})).toEqual([{name: "room"}]);
    const [room, cold] = cases_of(all);
    expect([counts_for(room!, "hump"), counts_for(cold!, "hump"), counts_for(cold!, "hold_open")]).toEqual([
      true,
      false,
      true,
    ]);
  });
  it("know what is told with them", () => {
    const needs = (loads: Loads) => ["loads", "hand", "crank", "cylinder", "limit"].filter((of) => has_of(loads, of));
    expect(needs({})).toEqual(["loads"]);
    expect(needs(all)).toEqual(["loads", "hand", "cylinder"]);
    expect(needs({drive: "input"})).toEqual(["loads", "crank"]);
    expect([drive_of({}), drive_of(all)]).toEqual(["hand", "cylinder"]);
  });
  it("have friction either way", () => {
    expect(friction_of(strut)).toBe(25);
    expect(friction_of({...strut, F3: undefined, friction: 12})).toBe(12);
  });
});

describe("with the fixed frame seen from elsewhere", () => {
  const move = (point: readonly [number, number]) => body_point([...point], {x: 10, y: 0, theta_deg: 90});

  it("what lies in it is told anew, and what belongs to the body stays", () => {
    const {gravity, handle, springs, extra, body, drive} = moved_loads(all, move);
    expect(gravity).toEqual({direction_deg: -170, acceleration: 9.8});
    expect(handle).toEqual({point: [-5, -70], direction: {fixed_deg: 45}});
    expect(springs![0]).toMatchObject({from: stud("ground", 115, -140), to: strut.to});
    expect(extra!.map((one) => ("force" in one ? one.force : one.mass))).toEqual([3, [5, 0], [0, -10]]);
    expect(body).toBe(all.body);
    expect(drive).toEqual({cylinder: {from: stud("ground", 2, 9), to: stud("body", 3, 4)}});
  });
  it("gravity that nobody gave turns too, and none stays none", () => {
    expect(moved_loads({}, move).gravity).toEqual({direction_deg: -180});
    expect(moved_loads({gravity: null}, move).gravity).toBeNull();
    const shifted = moved_loads({handle: {point: [1, 2]}}, ([x, y]) => [x + 1, y]);
    expect(shifted).toEqual({handle: {point: [1, 2]}});
  });
});
