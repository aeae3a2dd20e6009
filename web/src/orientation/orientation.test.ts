import {describe, expect, it} from "vitest";
import {angles_of, form_of, in_form, in_form_of, read_orientation, sequences, type Converted} from "./orientation";

const report = {
  matrix: [
    [1, 0, 0],
    [0, 0, -1],
    [0, 1, 0],
  ],
  quaternion: [Math.SQRT1_2, Math.SQRT1_2, 0, 0],
  axis: [1, 0, 0],
  angle_deg: 90,
  rotation_vector: [Math.PI / 2, 0, 0],
  euler_deg: {zyx: [1, 2, 3], xyz: [4, 5, 6]},
} as unknown as Converted;

describe("an orientation", () => {
  it("has 24 sequences: the extrinsic ones are read from their ends", () => {
    expect(new Set(sequences).size).toBe(12);
    expect(angles_of(report, "zyx", "intrinsic")).toEqual([1, 2, 3]);
    expect(angles_of(report, "xyz", "extrinsic")).toEqual([3, 2, 1]);
  });
  it("is read as it is written, in each of its forms", () => {
    for (const form of ["quaternion", "axis", "rotation_vector", "matrix", "euler_deg"] as const) {
      const orientation = in_form(report, form, "xyz", "extrinsic");
      expect(form_of(orientation)).toBe(form);
      expect(read_orientation(JSON.parse(JSON.stringify(orientation)))).toEqual(orientation);
      expect(in_form_of(report, orientation)).toEqual(orientation);
    }
  });
  it("is none in two forms, in no form, or with a wrong number", () => {
    for (const wrong of [
      {},
      null,
      {quaternion: [1, 0, 0]},
      {quaternion: [1, 0, 0, 0], matrix: report.matrix},
      {axis: [0, 0, 1]},
      {euler_deg: [1, 2, 3], sequence: "xxy"},
      {matrix: [[1, 0, 0]]},
      {rotation_vector: [1, 2, NaN]},
    ])
      expect(read_orientation(wrong)).toBeNull();
  });
});
