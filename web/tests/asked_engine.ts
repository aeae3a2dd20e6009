// The engine of the page, asked without the page; to be imported by tests.
import {beforeAll} from "vitest";
import {
  whole,
  type Kind,
  type MapAnswer,
  type Mistake,
  type Replies,
  type ReplyMessage,
  type RequestMessage,
  type Requests,
} from "../src/contract/messages";
import {load_module} from "../src/engine/node";
import {Engine} from "../src/engine/serve";

let server: Engine;
beforeAll(async () => {
  server = new Engine(await load_module());
});

export function reply<K extends Kind>(kind: K, content: Requests[K]): Replies[K] | {refused: Mistake[]} {
  const {message} = server.serve({id: 1, kind, ...content} as unknown as RequestMessage);
  const answer = message as Exclude<Extract<ReplyMessage, {id: number}>, {tidings: unknown}>;
  return "refused" in answer ? {refused: answer.refused.mistakes} : (answer.reply as Replies[K]);
}
export function ask<K extends Kind>(kind: K, content: Requests[K]): Replies[K] {
  const answer = reply(kind, content);
  if ("refused" in answer) throw new Error(JSON.stringify(answer.refused));
  return answer;
}
export const coarse = 100;
export function explored(problem: string, property: MapAnswer["property"] = "link_ratio", samples = coarse) {
  return ask("explore", {problem, samples, window: whole, property, order: "fresh"});
}
