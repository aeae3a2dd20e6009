import fc from "fast-check";
import {expect, test} from "vitest";
import {sharing} from "./sharing";

test("a value that shares parts is the same value; equal ones are the one before", () => {
  fc.assert(
    fc.property(fc.jsonValue(), fc.jsonValue(), (next, before) => {
      expect(sharing(next, before)).toEqual(next);
      const copy = structuredClone(before);
      expect(sharing(copy, before)).toBe(before);
    }),
  );
});

test("what is equal is taken over, what is not is new", () => {
  const before = {fails: 0, drive: {width: 2, states: new Float64Array([1, NaN])}, pivots: [[0, 1], null]},
    next = {...structuredClone(before), fails: 4},
    shared = sharing(next, before);
  expect(shared).toEqual(next);
  expect(shared).not.toBe(before);
  expect(shared.drive).toBe(before.drive);
  expect(shared.pivots).toBe(before.pivots);
  next.drive.states[0] = 2;
  expect(sharing(next, before).drive.states).toBe(next.drive.states);
  expect(sharing([1, 2], [1, 2, 3])).toEqual([1, 2]);
  expect(sharing(new Float64Array([1]), new Float32Array([1]))).toBeInstanceOf(Float64Array);
});
