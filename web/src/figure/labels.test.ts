import {expect, it} from "vitest";
import type {Point} from "../contract/messages";
import {placed_texts} from "./labels";

const label = (at: Point, text: string) => ({at, text, size: 12, gap: 10});

it("words stand beside what they name", () => {
  expect(placed_texts([label([100, 100], "a")], [])).toEqual([{x: 110, y: 100, anchor: "start"}]);
});
it("words stand neither upon each other nor upon a sign", () => {
  const places: Point[] = [
    [100, 100],
    [112, 104],
    [104, 118],
    [96, 92],
  ];
  const texts = placed_texts(
    places.map((at, i) => label(at, `joint ${i}`)),
    places,
  );
  const width = 0.56 * 12 * 7;
  const boxes = texts.map(({x, y, anchor}) => ({
    left: anchor === "start" ? x : anchor === "end" ? x - width : x - width / 2,
    y,
  }));
  for (const [i, a] of boxes.entries())
    for (const b of boxes.slice(i + 1))
      expect(Math.abs(a.left - b.left) >= width || Math.abs(a.y - b.y) >= 12, `${i}`).toBe(true);
});
