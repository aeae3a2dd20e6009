import {BufferAttribute, BufferGeometry} from "three";
import {expect, it} from "vitest";
import {stretching} from "./scene";

it("a plate is stretched by moving its far end, again and again without drifting", () => {
  const geometry = new BufferGeometry().setAttribute(
    "position",
    new BufferAttribute(Float32Array.from([-0.06, 0, 0, 0, 0.06, 0, 1, 0.06, 0, 1.06, 0, 0]), 3),
  );
  const stretch = stretching(geometry),
    xs = () =>
      Array.from(geometry.getAttribute("position").array)
        .filter((_, i) => i % 3 === 0)
        .map((x) => Math.round(1e6 * x) / 1e6);
  for (let i = 0; i < 1000; ++i) stretch(Math.abs(Math.sin(i)));
  stretch(0.25);
  expect(xs()).toEqual([-0.06, 0, 0.25, 0.31]);
  stretch(0.01); // shorter than it is wide
  stretch(1);
  expect(xs()).toEqual([-0.06, 0, 1, 1.06]);
  expect(geometry.boundingBox!.max.x).toBeCloseTo(1.06);
});
