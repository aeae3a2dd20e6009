// The linkage as plates on pins: one question, whose answer is what is told of its files before they are made and what
// the view in 3-D shows.
import type {Machine, Requests, TauPair} from "../contract/messages";
import {engine_text, type Problem} from "../state/problem";
import type {Workbench} from "../state/workbench.svelte";
import {plate_choice} from "./plate_form.svelte";

/** With the sizes that are given. */
export function machine_of(problem: Problem, tau: TauPair): Requests["machine"] {
  return {problem: engine_text(problem), tau, sizes: plate_choice.sizes};
}
/** Null where there is no answer: refused, or another one is wanted by now. */
export async function ask_machine(
  {machines, driver_client}: Workbench,
  of: Requests["machine"],
): Promise<Machine | null> {
  if (machines.is_of(of)) return machines.value;
  return driver_client && machines.ask(of, () => driver_client.follow("machine", of));
}
