// The attitude of a body: how it is read, and what its pictures are made of.
import {describe, expect, it} from "vitest";
import {identity} from "../../sphere/vectors";
import {has_linkages, read_task} from "../kind_dispatch";
import {attitude_kind} from "./kind";
import {played_angles, rotation_picture, turn_at, turns_picture} from "./pictures";
import type {AttitudeReply} from "./reply";
import type {AttitudeTask} from "./task";

const task = attitude_kind.beginnings[0]!.make().task as AttitudeTask;
const axes = [
  [0, 0, 1],
  [1, 0, 0],
  [0, 0, 1],
] as const;
const reply = {
  convert: {matrix: identity, axis: [0, 0, 1], axis_defined: false, angle_deg: 0},
  turns: {angles_deg: [40, 50, 35], frames: [identity, identity, identity], axes, now: {frame: identity, axes}},
  rotation: {
    path: [
      [1, 0, 0],
      [1, 0, 0],
    ],
    now: {frame: identity, vector: [1, 0, 0]},
  },
} as unknown as AttitudeReply;

describe("an attitude", () => {
  it("is a task without linkages", () => expect(has_linkages(task)).toBe(false));
  it("is read with what is missing filled in, but not without an orientation", () => {
    const {orientation} = task;
    expect(read_task({kind: "attitude", orientation})).toEqual(task);
    expect(read_task({kind: "attitude", orientation, sequence: "xxx", vector: [1]})).toEqual(task);
    expect(read_task({kind: "attitude"})).toBeNull();
  });
  it("plays its turns one after the other", () => {
    expect(played_angles([40, 50, 60], 0)).toEqual([0, 0, 0]);
    expect(played_angles([40, 50, 60], 1.5)).toEqual([40, 25, 0]);
    expect(played_angles([40, 50, 60], 3)).toEqual([40, 50, 60]);
    expect(turn_at(1.5)).toEqual({turn: 1, share: 0.5});
    expect(turn_at(3).turn).toBe(2);
  });
  it("has a line of nodes for Euler angles, and each thing once", () => {
    for (const at of [0, 0.4, 1.7, 3]) {
      const {items, labels} = turns_picture(task, reply, at);
      expect(labels.map(({text}) => text)).toContain("N");
      expect(new Set(items.map(({key}) => key)).size).toBe(items.length);
      expect(new Set(labels.map(({key}) => key)).size).toBe(labels.length);
    }
    const cardan = turns_picture({...task, sequence: "xyz"}, reply, 3);
    expect(cardan.labels.map(({text}) => text)).not.toContain("N");
  });
  it("has no axis and no cone where it is not turned", () => {
    const keys = rotation_picture(task, reply, 1).items.map(({key}) => key);
    expect(keys).not.toContain("cone");
    expect(keys).toContain("a0");
  });
});
