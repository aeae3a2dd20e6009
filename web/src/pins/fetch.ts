import type {EngineClient} from "../engine/client";
import type {Linkage} from "../contract/messages";
import {engine_text, type Pin, type Problem} from "../state/problem";
import {with_other_task} from "../tasks/kinds";

/** A pin's linkage in its own task; null where the engine refuses it, or does not outlive it. */
export async function fetch_pin(client: EngineClient, problem: Problem, pin: Pin): Promise<Linkage | null> {
  const reply = await client
    .run({kind: "linkage", problem: engine_text(with_other_task(problem, pin.task)), tau: pin.tau})
    .catch(() => null);
  return reply && reply.linkage;
}
