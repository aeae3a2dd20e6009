import {describe, expect, it} from "vitest";
import {rows_at, sample_drive} from "./sample_drive";
import {advanced, degrees_per_ms, next_stop, passed, played_span, stops_of, task_span, unreached_poses} from "./play";

const drive = sample_drive(rows_at([-40, -20, 0, 10, 30, 60, 100]), [2, 3, 4, 5]);
const up = {angle: 50, sense: 1 as const, ended: false};

describe("span", () => {
  it("is the task, the travel on request, and the travel where a defect keeps the task apart", () => {
    expect(played_span(drive, false)).toEqual([0, 60]);
    expect(played_span(drive, true)).toEqual([-40, 100]);
    const apart = sample_drive(rows_at([-40, 0, 100]), [1, -1, -1, -1]);
    expect(task_span(apart)).toBeNull();
    expect(played_span(apart, false)).toEqual([-40, 100]);
    expect(unreached_poses(apart)).toEqual([1, 2, 3]);
  });
  it("takes two seconds for the task at speed 1", () => {
    expect(degrees_per_ms(drive, false, 1) * 2000).toBeCloseTo(60);
    expect(degrees_per_ms(drive, true, 2) * 2000).toBeCloseTo(140);
  });
});

describe("a run", () => {
  it("turns at the ends", () => {
    expect(advanced(up, 5, [0, 60], "reverse")).toEqual({...up, angle: 55});
    expect(advanced(up, 15, [0, 60], "reverse")).toEqual({angle: 55, sense: -1, ended: false});
    expect(advanced({...up, angle: 3, sense: -1}, 5, [0, 60], "reverse")).toEqual({angle: 2, sense: 1, ended: false});
  });
  it("begins again", () => {
    expect(advanced(up, 15, [0, 60], "loop")).toEqual({...up, angle: 5});
  });
  it("stops at a limit", () => {
    expect(advanced(up, 15, [0, 60], "once")).toEqual({angle: 60, sense: 1, ended: true});
  });
  it("comes back from outside the span", () => {
    expect(advanced({...up, angle: 90}, 1, [0, 60], "reverse")).toEqual({angle: 89, sense: -1, ended: false});
    expect(advanced({...up, angle: -20}, 5, [0, 60], "reverse").angle).toBe(-15);
  });
  it("ends where there is no travel", () => {
    expect(advanced(up, 1, [3, 3], "loop").ended).toBe(true);
  });
});

describe("stops", () => {
  const stops = stops_of(drive);
  it("are passed in both senses, the end of the way included", () => {
    const poses = (from: number, to: number) => passed(stops, from, to).map((stop) => stop.pose);
    expect(poses(-5, 10)).toEqual([0, 1]);
    expect(poses(10, 20)).toEqual([]);
    expect(poses(70, 5)).toEqual([3, 2, 1]);
    expect(poses(70, 60)).toEqual([3]);
  });
  it("follow each other and begin again", () => {
    expect(next_stop(stops, 0, 1)?.pose).toBe(1);
    expect(next_stop(stops, 60, 1)?.pose).toBe(0);
    expect(next_stop(stops, 0, -1)?.pose).toBe(3);
  });
  it("come in their real order", () => {
    expect(stops_of(sample_drive(rows_at([0, 10, 30, 60]), [0, 2, 1, 3])).map((s) => s.pose)).toEqual([0, 2, 1, 3]);
  });
});
