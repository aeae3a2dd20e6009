// How the engine is asked for springs to be placed: in rounds, by a session that answers as it is told.
import {describe, expect, test} from "vitest";
import type {LinkwrightModule} from "./module";
import {Refusal} from "./refusal";
import {Engine} from "./serve";
import type {Replies, Requests, Tidings} from "../contract/messages";

type Asked = Requests["place_spring"];
const asked: Asked = {problem: "p", tau: [1, 2], boxes: "{}"};

/** What is told on the way, and what is answered; `answer` by the most boxes. */
function placed(answer: (most: number) => object | null): {
  told: Tidings["place_spring"][];
  reply: unknown;
  most: number[];
} {
  const most: number[] = [],
    told: Tidings["place_spring"][] = [];
  const session = {
    set_problem: () => true,
    place_spring(_input: number, _output: number, _boxes: string, boxes: number) {
      most.push(boxes);
      const found = answer(boxes);
      return found ? JSON.stringify(found) : "";
    },
  };
  const module = {
    Session: function () {
      return session;
    },
  } as unknown as LinkwrightModule;
  const engine = new Engine(module, (message) => {
    if ("tidings" in message) told.push(message.tidings as Tidings["place_spring"]);
  });
  const {message} = engine.serve({id: 1, kind: "place_spring", ...asked});
  return {told, most, reply: "reply" in message ? message.reply : message};
}

describe("a spring to be placed", () => {
  test("is looked for with more and more boxes until it is proven, and each round is told", () => {
    const {told, most, reply} = placed((boxes) => ({placed: {proven: boxes === 120_000, boxes}}));
    expect(most).toEqual([0, 30_000, 120_000]);
    expect(told.map(({found}) => found.boxes)).toEqual(most);
    expect((reply as Replies["place_spring"]).placed).toEqual({proven: true, boxes: 120_000});
  });
  test("is given up at the most boxes", () => {
    expect(placed(() => ({placed: {proven: false}})).most).toEqual([0, 30_000, 120_000, 500_000, 2_000_000]);
  });
  test("may fit with more boxes, but not where something else is in its way", () => {
    const why = (code: string, values?: object) => () => ({
      placed: {proven: false, why_not: {code, values, message: ""}},
    });
    expect(placed(why("nothing_fits")).most).toHaveLength(5);
    expect(placed(why("nothing_fits", {proven: 1})).most).toEqual([0]);
    expect(placed(why("no_handle")).most).toEqual([0]);
  });
  test("is none where the linkage does not get through its positions", () => {
    expect(placed(() => null)).toMatchObject({told: [], reply: {placed: null}});
  });
  test("is refused with all mistakes", () => {
    const mistakes = [{code: "negative", place: "min_stroke", values: {}, message: "a number from 0 on"}];
    expect(placed(() => ({mistakes})).reply).toEqual({id: 1, kind: "place_spring", refused: {mistakes}});
  });
});

test("the map of a stud is none where the engine has none", () => {
  const answers = ["", '{"columns": 0, "rows": 0, "force": []}', '{"columns": 1, "rows": 2, "force": [1, null]}'];
  const module = {
    Session: function () {
      return {set_problem: () => true, stud_map: () => answers.shift()};
    },
  } as unknown as LinkwrightModule;
  const engine = new Engine(module),
    ask = () => engine.ask("stud_map", {...asked, stud: "body", columns: 1, rows: 2}).map;
  expect([ask(), ask(), ask()]).toEqual([null, null, {columns: 1, rows: 2, force: [1, null]}]);
  answers.push('{"mistakes": []}');
  expect(ask).toThrow(Refusal);
});
