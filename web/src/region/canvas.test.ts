import {expect, it} from "vitest";
import {size_canvas} from "./canvas";

it("a canvas takes both of its sizes, whichever it has already", () => {
  const untouched = {width: 300, height: 150};
  expect(size_canvas(untouched, 300, 300, 1)).toEqual([300, 300]);
  expect(untouched).toEqual({width: 300, height: 300});
  size_canvas(untouched, 300, 240, 1.5);
  expect(untouched).toEqual({width: 450, height: 360});
});
it("a canvas of the right size is not emptied", () => {
  const canvas = {
    width: 300,
    set height(_: number) {
      throw new Error("emptied");
    },
    get height() {
      return 200;
    },
  };
  expect(size_canvas(canvas, 150, 100, 2)).toEqual([300, 200]);
});
