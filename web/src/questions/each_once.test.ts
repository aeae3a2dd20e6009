import {beforeEach, expect, it} from "vitest";
import {Cancelled, Crashed, type EngineClient} from "../engine/client";
import {Refusal} from "../engine/refusal";
import {EachOnce} from "./each_once.svelte";
import {Questions} from "./questions";

let questions: Questions, lengths: EachOnce<string, number>, asked: string[];
let answer: (of: string) => Promise<number>;
beforeEach(() => {
  questions = new Questions();
  asked = [];
  answer = (of) => Promise.resolve(of.length);
  const request = (_: EngineClient, of: string, signal: AbortSignal) => {
    asked.push(of);
    return new Promise<number>((resolve, reject) => {
      signal.addEventListener("abort", () => reject(new Cancelled()));
      answer(of).then(resolve, reject);
    });
  };
  lengths = new EachOnce({questions, driver_client: {} as EngineClient}, (of) => of, request, 2);
});
const known = (...all: string[]) => all.map((of) => lengths.value_of(of));

it("asks of each once, one after the other, and waits for all", async () => {
  const all = lengths.want(["a", "bb", "ccc"]);
  expect([asked, questions.settled()]).toEqual([["a"], false]);
  await Promise.all([all, lengths.want(["a", "bb", "ccc"])]);
  expect([known("a", "bb", "ccc"), questions.settled()]).toEqual([[1, 2, 3], true]);
  await lengths.want(["bb", "dddd"]);
  expect(asked).toEqual(["a", "bb", "ccc", "dddd"]);
});
it("asks no more of what is not wanted any more", async () => {
  const before = lengths.want(["a", "bb"]);
  await lengths.want(["ccc"]);
  await before;
  expect([asked, known("a", "bb", "ccc")]).toEqual([
    ["a", "ccc"],
    [null, null, 3],
  ]);
});
it("takes a refusal as the answer to one", async () => {
  answer = (of) => (of === "a" ? Promise.reject(new Refusal([])) : Promise.resolve(of.length));
  await lengths.want(["a", "bb"]);
  await lengths.want(["a", "bb"]);
  expect([asked, known("a", "bb")]).toEqual([
    ["a", "bb"],
    [null, 2],
  ]);
});
it("asks again of what an engine has died with, which keeps none of the others", async () => {
  answer = (of) => (asked.length === 1 ? Promise.reject(new Crashed("killed")) : Promise.resolve(of.length));
  await lengths.want(["a", "bb"]);
  expect(known("a", "bb")).toEqual([null, 2]);
  await lengths.want(["a", "bb"]);
  expect([asked, known("a", "bb")]).toEqual([
    ["a", "bb", "a"],
    [1, 2],
  ]);
});
it("keeps what is wanted and the latest of what else is known", async () => {
  lengths.put("a", 1);
  for (const of of ["bb", "ccc", "dddd"]) lengths.put(of, of.length);
  await lengths.want(["a"]);
  expect([known("a", "bb", "ccc", "dddd"), asked]).toEqual([[1, null, 3, 4], []]);
});
