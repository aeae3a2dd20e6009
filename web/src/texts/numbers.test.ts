import {expect, it} from "vitest";
import {point_text} from "../numbers/linkage_words";
import {preferences} from "../state/preferences.svelte";
import {unbroken} from "./numbers";

it("keeps groups of three on one line", () => {
  expect(unbroken("between −1 000 000 000 and 5 parts of 10 00")).toBe(
    "between −1\u202f000\u202f000\u202f000 and 5 parts of 10 00",
  );
});
it("tells pivots with the decimals that are wanted", () => {
  expect(point_text([1178.1234, -190.5678], 1200)).toBe("1178, −191");
  preferences.decimals = 2;
  expect(point_text([1178.1234, -190.5678], 1200)).toBe("1178.12, −190.57");
  preferences.decimals = null;
});
