// What is asked of the engine: the one place that knows what is on its way, what has been superseded, what has failed, and
// of what the answer is that is there. A worker that dies is the client's matter: it asks once more what is `run`, and what
// follows the task is asked anew when it is back.
import {Cancelled, Crashed, Refusal, Superseded} from "../engine/client";
import type {Questions} from "./questions";

type Request<Value> = (signal: AbortSignal) => Promise<Value | null>;
interface Asked<Of, Value> {
  of: Of;
  stop: AbortController;
  sent: boolean;
  answer: Promise<Value | null>;
}

interface Options<Of> {
  /** Whether the answer of one is that of the other. */
  same?: (a: Of, b: Of) => boolean;
  /** What it is asked of may change faster than the engine answers: an answer that comes late is one until the next. */
  follows?: boolean;
}

/** One question, asked again and again of something else. The last answer stays until the next is there. */
export class Question<Of, Value> {
  /** Why the last one that was not superseded has no answer. */
  error = $state.raw<Crashed | Refusal | null>(null);
  /** By the clock, the last answer. */
  took_ms = 0;
  private answered = $state.raw<{of: Of; value: Value} | null>(null);
  private asked = $state.raw<readonly Asked<Of, Value>[]>([]); // the last one is the present one
  private readonly same: (a: Of, b: Of) => boolean;
  private readonly follows: boolean;

  constructor(
    private readonly questions: Questions,
    {same = (a, b) => a === b, follows = false}: Options<Of> = {},
  ) {
    [this.same, this.follows] = [same, follows];
  }

  get value(): Value | null {
    return this.answered?.value ?? null;
  }
  /** Of what the value is. */
  get of(): Of | null {
    return this.answered?.of ?? null;
  }
  is_of(of: Of): boolean {
    return this.answered !== null && this.same(this.answered.of, of);
  }
  is_asked(of: Of): boolean {
    return this.last !== undefined && this.same(this.last.of, of);
  }
  /** On its way, or waiting. */
  get busy(): boolean {
    return this.last !== undefined;
  }
  private get last(): Asked<Of, Value> | undefined {
    return this.asked.at(-1);
  }

  /** Asks unless that is on its way, and supersedes what is. Waits `rest_ms` first, in which something else may be asked.
   *  Null where there is no answer: it was superseded, it has failed, or the request has found that nobody wants it. */
  ask(of: Of, request: Request<Value>, rest_ms = 0): Promise<Value | null> {
    if (this.last && this.same(this.last.of, of)) return this.last.answer;
    this.let_go(({sent}) => !this.follows || !sent);
    const asked = {of, stop: new AbortController(), sent: false} as Asked<Of, Value>;
    this.questions.begin(asked);
    this.asked = [...this.asked, asked];
    return (asked.answer = this.answer_of(asked, request, rest_ms));
  }
  private async answer_of(asked: Asked<Of, Value>, request: Request<Value>, rest_ms: number): Promise<Value | null> {
    const {signal} = asked.stop;
    try {
      if (rest_ms > 0) await rest(rest_ms, signal);
      asked.sent = true;
      const begin = performance.now(),
        value = await request(signal);
      if (signal.aborted) return null;
      this.took_ms = performance.now() - begin;
      if (value !== null) this.put(asked.of, value);
      const at = this.asked.indexOf(asked);
      this.let_go((other) => this.asked.indexOf(other) < at); // they are of before
      return value;
    } catch (error) {
      if (!signal.aborted) this.note(error);
      return null;
    } finally {
      this.questions.end(asked);
      this.asked = this.asked.filter((other) => other !== asked);
    }
  }
  private note(error: unknown): void {
    if (error instanceof Superseded || error instanceof Cancelled) return; // by another of its kind
    if (!(error instanceof Crashed || error instanceof Refusal)) throw error;
    this.error = error;
  }

  /** What is on its way is not wanted any more. */
  drop(): void {
    this.let_go(() => true);
  }
  /** What waits is not to be asked; what is with the engine may come. */
  hold(): void {
    this.let_go(({sent}) => !sent);
  }
  private let_go(unwanted: (asked: Asked<Of, Value>) => boolean): void {
    const gone = this.asked.filter(unwanted);
    if (gone.length) this.asked = this.asked.filter((asked) => !gone.includes(asked));
    for (const asked of gone) {
      this.questions.end(asked);
      asked.stop.abort(new Cancelled());
    }
  }
  /** An answer that has come otherwise. */
  put(of: Of, value: Value): void {
    this.error = null;
    this.answered = {of, value};
  }
  forget(): void {
    this.drop();
    this.error = this.answered = null;
  }
}

/** For `catch`: where a refusal is an answer, too. */
export function null_if_refused(error: unknown): null {
  if (error instanceof Refusal) return null;
  throw error;
}
/** Rejects where it is broken off. */
function rest(ms: number, signal: AbortSignal): Promise<void> {
  return new Promise((resolve, reject) => {
    const timer = setTimeout(resolve, ms);
    signal.addEventListener("abort", () => (clearTimeout(timer), reject(signal.reason as Error)), {once: true});
  });
}
