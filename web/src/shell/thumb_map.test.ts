import {expect, it} from "vitest";
import {linkage_types} from "../contract/messages";
import {painted} from "./thumb_map";

it("a small map has the input upwards and four kinds of cells", () => {
  const colors = {
    ...Object.fromEntries(linkage_types.map((name) => [name, "#102030"])),
    hatch: "#808080",
    paper: "#ffffff",
    rocker_crank: "#ff0000",
  };
  const type = Uint8Array.from([1, 1, 0, 9]),
    fails = Uint32Array.from([0, 2, 4, 127]);
  const pixels = painted({rows: 2, columns: 2, type, fails}, colors, 2),
    at = (i: number) => [...pixels.slice(4 * i, 4 * i + 4)];
  expect(at(2)).toEqual([255, 0, 0, 255]); // row 0 lies at the bottom
  expect(at(3)).toEqual([128, 128, 128, 255]);
  expect(at(0)).toEqual([183, 188, 193, 255]);
  expect(at(1)).toEqual([255, 255, 255, 255]);
});
