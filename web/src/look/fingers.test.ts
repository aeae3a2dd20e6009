import {expect, it} from "vitest";
import {Fingers} from "./fingers";

function two(): Fingers {
  const fingers = new Fingers();
  fingers.down(1, [0, 0]);
  fingers.down(7, [100, 0]);
  return fingers;
}

it("two that part are told once, by their middle and how far", () => {
  const fingers = two();
  fingers.move(7, [200, 0]);
  fingers.move(1, [0, 20]);
  expect(fingers.pinched()).toEqual({from: [50, 0], to: [100, 10], spread: Math.hypot(200, 20) / 100});
  expect(fingers.pinched()).toEqual({from: [100, 10], to: [100, 10], spread: 1});
});
it("steps multiply to the whole", () => {
  const fingers = two();
  let spread = 1;
  for (const x of [130, 90, 400]) {
    fingers.move(7, [x, 0]);
    spread *= fingers.pinched()!.spread;
  }
  expect(spread).toBeCloseTo(4, 12);
});
it("one, and three, and those that are gone pinch nothing", () => {
  const fingers = two();
  fingers.down(3, [5, 5]);
  expect(fingers.pinched()).toBeNull();
  expect(fingers.up(3)).toBe(true);
  expect(fingers.pinched()).toEqual({from: [50, 0], to: [50, 0], spread: 1});
  expect([fingers.up(7), fingers.up(7), fingers.pinched(), fingers.count]).toEqual([true, false, null, 1]);
  fingers.move(7, [9, 9]);
  expect([fingers.has(7), fingers.count]).toEqual([false, 1]);
  fingers.clear();
  expect(fingers.count).toBe(0);
});
it("two that lie on each other zoom to nothing infinite", () => {
  const fingers = two();
  fingers.move(7, [0, 0]);
  expect(fingers.pinched()!.spread).toBeCloseTo(0.1, 12);
  fingers.move(7, [100, 0]);
  expect(fingers.pinched()!.spread).toBeCloseTo(10, 12);
});
