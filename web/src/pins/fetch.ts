import {Crashed, Superseded, type EngineClient} from "../engine/client";
import type {Linkage} from "../engine/protocol";
import {engine_text, type Pin, type Problem} from "../state/problem";
import {with_other_task} from "../tasks/kinds";

/** A pin's linkage in its own task; null where the engine refuses it. Waits its turn: the hand's request comes first. */
export async function fetch_pin(client: EngineClient, problem: Problem, pin: Pin): Promise<Linkage | null> {
  const text = engine_text(with_other_task(problem, pin.task));
  for (let tries = 0; tries < 50; ++tries) {
    while (client.busy && !client.resting) await new Promise((done) => setTimeout(done, 4));
    try {
      return (await client.request("linkage", {problem: text, tau: pin.tau})).linkage;
    } catch (error) {
      if (!(error instanceof Superseded || error instanceof Crashed)) return null;
    }
  }
  return null;
}
