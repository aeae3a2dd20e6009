import type {Mistake} from "../contract/messages";

/** The engine refused: the caller's mistakes, each with its place. */
export class Refusal extends Error {
  constructor(readonly mistakes: Mistake[]) {
    super(mistakes.map((m) => (m.place ? `${m.place}: ${m.message}` : m.message)).join("\n"));
  }
}
