import {describe, expect, it} from "vitest";
import {rows_at, sample_drive} from "../transport/sample_drive";
import {only_changes} from "./animation";
import {animation_frames, duration_ms, frame_at} from "./frames";

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
    expect(duration_ms(frames)).toBe(78 * 50 + 2 * 500);
    expect(frames.every((f) => f.ms % 10 === 0)).toBe(true);
  });
  it("shows each frame for its time", () => {
    expect(frame_at(frames, 0).angle).toBe(0);
    expect(frame_at(frames, 499).angle).toBe(0);
    expect(frame_at(frames, 500).angle).toBeCloseTo(1.5);
    expect(frame_at(frames, duration_ms(frames) + 10).angle).toBe(0);
  });
  it("goes round where the driver goes round", () => {
    const crank = sample_drive(rows_at([-100, 0, 60, 260]), [1, 1, 2, 2], {
      full_turn: true,
      limits: {low: null, high: null},
    });
    const round = animation_frames(crank, true);
    expect(round).toHaveLength(80);
    expect(round.every((f, i) => f.ms === 50 && Math.abs(f.angle - (-100 + 4.5 * i)) < 1e-9)).toBe(true);
  });
});

it("writes only what changes", () => {
  expect([...only_changes(new Uint8Array([1, 2, 3]), new Uint8Array([1, 5, 3]))]).toEqual([127, 5, 127]);
});
