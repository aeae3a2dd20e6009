import {describe, expect, it} from "vitest";
import type {Background} from "../state/problem";
import {center_of, scaled, turned, widened} from "./background";

const picture: Background = {image: "", x: 10, y: 20, width: 40, aspect: 0.5};
const close = (point: readonly number[], to: readonly number[]) =>
  point.forEach((value, i) => expect(value).toBeCloseTo(to[i]!, 9));

describe("the picture behind the drawing", () => {
  it("turns about its middle, there and back", () => {
    close(center_of(picture), [30, 30]);
    const quarter = turned(picture, 90);
    close(center_of(quarter), [30, 30]);
    close([quarter.x, quarter.y], [40, 10]);
    const back = turned(quarter, 0);
    close([back.x, back.y], [10, 20]);
  });
  it("keeps its middle when its width is typed, its first mark when their distance is, turned or not", () => {
    close(center_of(widened(turned(picture, 30), 400)), [30, 30]);
    const doubled = scaled(picture, [[10, 20], [20, 20]], 20)!; // prettier-ignore
    expect([doubled.width, doubled.x, doubled.y]).toEqual([80, 10, 20]);
    expect(scaled(turned(picture, 30), [[0, 0], [0, 5]], 10)!.angle_deg).toBe(30); // prettier-ignore
    expect(scaled(picture, [[1, 1], [1, 1]], 5)).toBeNull(); // prettier-ignore
  });
});
