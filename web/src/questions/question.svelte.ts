// What is asked of the engine: the one place that knows what is on its way, what has been superseded, what has failed, and
// of what the answer is that is there. A worker that dies is the client's matter: it asks once more what is `run`, and what
// follows the task is asked anew when it is back.
import {Cancelled, Crashed, Refusal, Superseded} from "../engine/client";
import type {Questions} from "./questions";

type EngineRequest<Value> = (signal: AbortSignal) => Promise<Value | null>;
interface Asked<Of, Value> {
  of: Of;
  stop: AbortController;
  sent: boolean;
  answer: Promise<Value | null>;
}

/** So long the last answer stands for the next one: in a drag each comes a few frames late. */
export const patience_ms = 400;

interface Options<Of> {
  /** Whether the answer of one is that of the other. */
  same?: (a: Of, b: Of) => boolean;
  /** What it is asked of may change faster than the engine answers: an answer that comes late is one until the next. */
  follows?: boolean;
  /** Whether an answer is what the page is about: what has not been so for longer than patience is stale. */
  is_present?: (of: Of) => boolean;
}
interface Asking<Value> {
  /** Before it is asked; meanwhile something else may be. */
  rest_ms?: number;
  /** It refines what there is: nobody waits for it. */
  at_leisure?: boolean;
  /** Hears of the answer in the moment in which it is there: what it brings along is shown with it. */
  taken?: (value: Value) => void;
  refused?: (refusal: Refusal) => void;
}

/** One question, asked again and again of something else. The last answer stays until the next is there. */
export class Question<Of, Value> {
  /** Why the last one that was not superseded has no answer. */
  error = $state.raw<Crashed | Refusal | null>(null);
  /** By the clock, the last answer. */
  took_ms = 0;
  stale = $state(false);
  /** On its way, or waiting. */
  busy = $state(false);
  private stale_timer: ReturnType<typeof setTimeout> | undefined;
  private answered = $state.raw<{of: Of; value: Value} | null>(null);
  private asked: readonly Asked<Of, Value>[] = []; // the last one is the present one
  private readonly same: (a: Of, b: Of) => boolean;
  private readonly follows: boolean;
  private readonly is_present: (of: Of) => boolean;

  constructor(
    private readonly questions: Questions,
    {same = (a, b) => a === b, follows = false, is_present = () => true}: Options<Of> = {},
  ) {
    [this.same, this.follows, this.is_present] = [same, follows, is_present];
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
  get is_of_present(): boolean {
    return this.answered !== null && this.is_present(this.answered.of);
  }
  is_asked(of: Of): boolean {
    return this.last !== undefined && this.same(this.last.of, of);
  }
  /** Until what was asked last has its answer, or has none. */
  get underway(): Promise<unknown> {
    return this.last?.answer ?? Promise.resolve();
  }
  private get last(): Asked<Of, Value> | undefined {
    return this.asked.at(-1);
  }

  /** Asks unless that is on its way, and supersedes what is.
   *  Null where there is no answer: it was superseded, it has failed, or the request has found that nobody wants it. */
  ask(of: Of, request: EngineRequest<Value>, asking: Asking<Value> = {}): Promise<Value | null> {
    if (this.last && this.same(this.last.of, of)) return this.last.answer;
    this.let_go(({sent}) => !this.follows || !sent);
    const asked = {of, stop: new AbortController(), sent: false} as Asked<Of, Value>;
    if (!asking.at_leisure) this.questions.begin(asked);
    this.note_asked([...this.asked, asked]);
    return (asked.answer = this.answer_of(asked, request, asking));
  }
  private async answer_of(
    asked: Asked<Of, Value>,
    request: EngineRequest<Value>,
    {rest_ms = 0, taken, refused}: Asking<Value>,
  ): Promise<Value | null> {
    const {signal} = asked.stop;
    try {
      if (rest_ms > 0) await rest(rest_ms, signal);
      asked.sent = true;
      const begin = performance.now(),
        value = await request(signal);
      if (signal.aborted) return null;
      this.took_ms = performance.now() - begin;
      const at = this.asked.indexOf(asked);
      this.let_go((other) => this.asked.indexOf(other) < at); // they are of before
      if (value !== null) this.take(asked.of, value, taken);
      return value;
    } catch (error) {
      if (signal.aborted) return null;
      this.note(error);
      if (error instanceof Refusal) refused?.(error);
      return null;
    } finally {
      this.questions.end(asked);
      this.note_asked(this.asked.filter((other) => other !== asked));
    }
  }
  private note_asked(asked: readonly Asked<Of, Value>[]): void {
    this.asked = asked;
    this.busy = asked.length > 0;
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
    this.note_asked(this.asked.filter((asked) => !gone.includes(asked)));
    for (const asked of gone) {
      this.questions.end(asked);
      asked.stop.abort(new Cancelled());
    }
  }
  /** An answer that has come otherwise takes the place of what is on its way. */
  put(of: Of, value: Value): void {
    this.drop();
    this.take(of, value);
  }
  private take(of: Of, value: Value, taken?: (value: Value) => void): void {
    this.error = null;
    this.answered = {of, value};
    clearTimeout(this.stale_timer);
    this.stale_timer = undefined;
    this.compare();
    taken?.(value);
  }
  /** What the page is about may be something else. */
  compare(): void {
    const is_behind = () => this.answered !== null && !this.is_of_present;
    if (is_behind())
      this.stale_timer ??= setTimeout(() => {
        this.stale_timer = undefined;
        this.stale = is_behind();
      }, patience_ms);
    else {
      clearTimeout(this.stale_timer);
      this.stale_timer = undefined;
      this.stale = false;
    }
  }
  forget(): void {
    this.drop();
    this.error = this.answered = null;
    this.compare();
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
