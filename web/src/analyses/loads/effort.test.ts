import {describe, expect, it} from "vitest";
import type {LoadCurve} from "../../contract/replies";
import type {LoadCaseReport, LoadPlace} from "../../contract/result";
import {driver_at, effort_of, marks_of, values_at, x_of_driver} from "./effort";

const curve = (change: Partial<LoadCurve> = {}): LoadCurve => ({
  name: "room",
  driver_turn_deg: [0, 10, 30],
  body_turn_deg: [0, -20, -40],
  path: [0, 0.5, 1],
  position: [1, null, 2],
  open: [10, -5, -20],
  close: [-5, 12, 30],
  torque: [null, null, null],
  time: [null, null, null],
  shaking: [null, null, null],
  pin: [100, 120, 110],
  ...change,
});

describe("the effort", () => {
  it("is told over the turn of the body, rising", () => {
    const effort = effort_of({curves: [curve()]})!;
    expect(effort).toMatchObject({of: "hand", over: "body", sense: -1, x: [0, 20, 40]});
    expect(effort.positions).toEqual([
      {position: 1, x: 0},
      {position: 2, x: 40},
    ]);
    expect(effort.y).toEqual([-24, 34]);
  });
  it("over the way of the handle or the turn of the driver where the body turns back", () => {
    const turning_back = curve({body_turn_deg: [0, 5, 0]});
    expect(effort_of({curves: [turning_back]})).toMatchObject({over: "path", x: [0, 50, 100]});
    expect(effort_of({curves: [{...turning_back, path: [null, null, null]}]})).toMatchObject({
      over: "driver",
      all_over: ["driver"],
      x: [0, 10, 30],
    });
    const driver_turn_deg = [0, 5, 0];
    expect(effort_of({curves: [{...turning_back, driver_turn_deg, path: [null, null, null]}]})).toBeNull();
  });
  it("over what is chosen, as far as there is that", () => {
    const of = (over: "driver" | "path") => effort_of({curves: [curve()]}, {over, of: "pin"})!;
    expect(of("driver")).toMatchObject({of: "pin", all_of: ["hand", "pin"], over: "driver", x: [0, 10, 30]});
    expect(of("path").cases[0]).toEqual({name: "room", open: [100, 120, 110], close: null});
    expect(effort_of({curves: [curve()]}, {of: "torque"})).toMatchObject({of: "hand"});
  });
  it("is marked where it moves by itself, balances and rests", () => {
    const place = (path: number): LoadPlace => ({driver_turn_deg: 30 * path, body_turn_deg: -40 * path, path});
    const report = {
      self_rise: place(0.5),
      self_close: place(1), // all the way
      equilibria: [{at: place(0.25), stable: true, stiffness: 1}],
      rests: [{from: place(0.3), to: place(0.4)}],
    } as unknown as LoadCaseReport;
    const effort = effort_of({curves: [curve()]})!;
    expect(marks_of(effort, report)).toEqual({
      marks: [
        {kind: "rise", x: 20},
        {kind: "stable", x: 10},
      ],
      rests: [[12, 16]],
    });
    const pins = effort_of({curves: [curve()]}, {of: "pin"})!;
    expect(marks_of(pins, report)).toEqual({marks: [], rests: []});
    expect(values_at(effort, 0, 20)).toEqual({open: -12.5, close: 21});
  });
  it("of a drive is its torque, and else the pins'", () => {
    const none = [null, null, null];
    expect(effort_of({curves: [curve({open: none, close: none, torque: [1, 2, 3]})]})).toMatchObject({
      of: "torque",
      cases: [{open: [1, 2, 3], close: null}],
    });
    expect(effort_of({curves: [curve({open: none, close: none})]})).toMatchObject({of: "pin"});
    const moving = [curve({time: [0, 0.5, 1], shaking: [9, 7, 8]})];
    expect(effort_of({curves: moving}, {of: "shaking"})).toMatchObject({
      all_of: ["hand", "pin", "shaking"],
      cases: [{open: [9, 7, 8], close: null}],
    });
    expect(effort_of({curves: []})).toBeNull();
  });
  it("knows where the drive is", () => {
    const effort = effort_of({curves: [curve()]})!;
    expect([0, 5, 30, 31].map((angle) => x_of_driver(effort, angle))).toEqual([0, 10, 40, null]);
    expect([-3, 10, 30, 99].map((x) => driver_at(effort, x))).toEqual([0, 5, 20, 30]);
    const backwards = effort_of({curves: [curve({driver_turn_deg: [0, -10, -30]})]})!;
    expect(x_of_driver(backwards, -20)).toBe(30);
    expect(driver_at(backwards, 30)).toBe(-20);
  });
});
