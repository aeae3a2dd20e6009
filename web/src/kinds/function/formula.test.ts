import {expect, it} from "vitest";
import {wrong_from} from "./formula";

it("parts a formula where the engine stopped", () => {
  expect(wrong_from('"2x²" is not understood from character 3 on; there are x', "2x²")).toEqual({
    right: "2x",
    rest: "²",
  });
  expect(wrong_from('"2x +" is not understood from character 5 on; there are x', "2x +")).toEqual({
    right: "2x +",
    rest: "",
  });
  expect(wrong_from("the range is empty", "x")).toBeNull();
});
