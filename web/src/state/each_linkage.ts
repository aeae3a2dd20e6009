// Linkages beside the one in hand, each fetched once: by the engine that follows the pointer, in turn with what it follows.
import type {Linkage} from "../contract/messages";
import {EachOnce} from "../questions/each_once.svelte";
import type {LinkageOf} from "./document";
import {engine_text} from "./problem";
import type {Workbench} from "./workbench.svelte";

export type Linkages = EachOnce<LinkageOf, Linkage>;
export function each_linkage(workbench: Pick<Workbench, "questions" | "driver_client">): Linkages {
  return new EachOnce(
    workbench,
    ({problem, tau}) => `${engine_text(problem)} ${tau.join()}`,
    async (client, {problem, tau}, signal) =>
      (await client.run({kind: "linkage", problem: engine_text(problem), tau}, {signal})).linkage,
  );
}
