import {describe, expect, it} from "vitest";
import {rows_at, sample_drive} from "../transport/sample_drive";
import {only_changes} from "./animation";
import {film_angles} from "./film";
import {animation_frames} from "./frames";

const drive = sample_drive(rows_at([-40, 0, 20, 40, 60, 100]), [1, 2, 3, 4]);

describe("an animation", () => {
  const frames = animation_frames(drive, false);
  it("goes over the task and back, each end once, exactly at the positions", () => {
    expect(frames).toHaveLength(80);
    expect(frames[0]).toEqual({angle: 0, ms: 500});
    expect(frames[40]).toEqual({angle: 60, ms: 500});
    expect(frames.filter((f) => f.angle === 0 || f.angle === 60)).toHaveLength(2);
    expect(frames[79]!.angle).toBeCloseTo(1.5);
  });
  it("takes two seconds each way and rests at the ends", () => {
    expect(frames.reduce((sum, {ms}) => sum + ms, 0)).toBe(78 * 50 + 2 * 500);
    expect(frames.every((f) => f.ms % 10 === 0)).toBe(true);
  });
  const crank = sample_drive(rows_at([-100, 0, 60, 260]), [1, 1, 2, 2], {
    full_turn: true,
    limits: {low: null, high: null},
  });
  it("goes round where the driver goes round", () => {
    const round = animation_frames(crank, true);
    expect(round).toHaveLength(80);
    expect(round.every((f, i) => f.ms === 50 && Math.abs(f.angle - (-100 + 4.5 * i)) < 1e-9)).toBe(true);
  });
  it("is one loop as a film, whatever the frame rate: five seconds there and back, four for a turn", () => {
    for (const rate of [24, 30, 60]) {
      const angles = film_angles(drive, false, rate);
      expect(angles).toHaveLength(5 * rate);
      expect([angles[0], angles[rate / 2], angles[2.5 * rate], angles[3 * rate]]).toEqual([0, 0, 60, 60]);
      const steps = angles.map((angle, i) => Math.abs(angle - angles.at(i - 1)!));
      expect(Math.max(...steps), "without a jump, from the last to the first either").toBeCloseTo(60 / (2 * rate));
      expect(film_angles(crank, true, rate)).toEqual(
        Array.from({length: 4 * rate}, (_, i) => expect.closeTo(-100 + (360 * i) / (4 * rate)) as number),
      );
    }
  });
});

it("writes only what changes", () => {
  expect([...only_changes(new Uint8Array([1, 2, 3]), new Uint8Array([1, 5, 3]))]).toEqual([127, 5, 127]);
});
