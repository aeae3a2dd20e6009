// Things of one kind, each asked once: what the engine has said of one stays, a refusal, too.
import {SvelteMap} from "svelte/reactivity";
import {Crashed, type EngineClient} from "../engine/client";
import {null_if_refused, Question} from "./question.svelte";
import type {Questions} from "./questions";

interface Asking {
  readonly questions: Questions;
  readonly driver_client: EngineClient | null;
}
type EngineRequest<Of, Value> = (client: EngineClient, of: Of, signal: AbortSignal) => Promise<Value>;

export class EachOnce<Of, Value> {
  /** Null: refused. */
  private readonly known = new SvelteMap<string, Value | null>();
  private readonly question: Question<string, true>;

  /** `most`: of those that are not wanted at present. */
  constructor(
    private readonly asking: Asking,
    private readonly key: (of: Of) => string,
    private readonly request: EngineRequest<Of, Value>,
    private readonly most = 500,
  ) {
    this.question = new Question(asking.questions);
  }

  /** Null: nothing yet, or nothing at all. */
  value_of(of: Of): Value | null {
    return this.known.get(this.key(of)) ?? null;
  }
  put(of: Of, value: Value | null): void {
    this.known.set(this.key(of), value);
  }
  /** One after the other, so that the engine does between them what else it is asked. What was wanted before is not any more. */
  async want(wanted: readonly Of[]): Promise<void> {
    const client = this.asking.driver_client,
      keys = wanted.map(this.key);
    this.forget_all_but(keys);
    if (!client || keys.every((key) => this.known.has(key))) return this.question.drop();
    await this.question.ask(keys.join("\n"), (signal) => this.ask_each(client, wanted, signal));
  }
  /** One with which the worker dies keeps none of the others. */
  private async ask_each(client: EngineClient, wanted: readonly Of[], signal: AbortSignal): Promise<true> {
    let crash: Crashed | null = null;
    for (const of of wanted.filter((one) => !this.known.has(this.key(one))))
      try {
        const value = await this.request(client, of, signal).catch(null_if_refused);
        if (!signal.aborted) this.put(of, value);
      } catch (error) {
        if (!(error instanceof Crashed)) throw error;
        crash = error;
      }
    if (crash) throw crash;
    return true;
  }
  private forget_all_but(wanted: readonly string[]): void {
    const others = [...this.known.keys()].filter((key) => !wanted.includes(key));
    for (const key of others.slice(0, Math.max(others.length - this.most, 0))) this.known.delete(key);
  }
}
