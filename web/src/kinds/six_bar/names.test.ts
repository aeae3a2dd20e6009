import {expect, it} from "vitest";
import {joint_words, length_words} from "./names";

const joints = ["a", "b", "d", "c4", "z4", "c5", "z5"].map((name, i) => ({name, ground: i === 0, at: [0, 0] as const}));
const bodies = [
  [0, 3],
  [0, 1, 5],
  [1, 2, 4],
  [2, 6],
  [3, 4],
  [5, 6],
];

it("names hinges by the bodies that they join, and distances by their body", () => {
  expect(joint_words({joints, bodies}, 0)).toBe("a · ground – driver");
  expect(joint_words({joints, bodies}, 3)).toBe("c₄ · ground – added link 4");
  expect(joint_words({joints, bodies}, 6)).toBe("z₅ · guided body – added link 5");
  expect(length_words("2:b-d")).toBe("floating link b–d");
  expect(length_words("0:a-c4")).toBe("ground a–c₄");
});
