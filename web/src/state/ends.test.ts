import {readdirSync, readFileSync} from "node:fs";
import {expect, it} from "vitest";
import {room_around} from "../pins/reach";
import {least_of, most_of} from "./ends";

it("the ends of any number of values are found", () => {
  expect([least_of([3, -1, 2]), most_of([3, -1, 2]), least_of([]), most_of([])]).toEqual([-1, 3, Infinity, -Infinity]);
  const many = Array.from({length: 200_000}, (_, i) => [i, -i] as const);
  expect(room_around(many).width).toBeCloseTo(199_999 * 1.12);
});
it("no list becomes the arguments of a call, however short it is meant to be", () => {
  const folder = new URL("..", import.meta.url),
    files = readdirSync(folder, {recursive: true, encoding: "utf8"});
  const sources = files.filter(
    (name) => /\.(ts|svelte)$/.test(name) && !name.endsWith(".test.ts") && !name.startsWith("generated"),
  );
  expect(sources.length).toBeGreaterThan(200);
  const spread = /Math\.(min|max|hypot)\(\.\.\.|Math\.(min|max)\([^()]*,? ?\.\.\./;
  expect(sources.filter((name) => spread.test(readFileSync(new URL(name, folder), "utf8")))).toEqual([]);
});
