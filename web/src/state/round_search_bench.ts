// For tests: a workbench whose searches run in an engine that finds so in each round, beside one that knows each linkage.
import {Cancelled, type EngineClient, type Run} from "../engine/client";
import type {Replies, Requests} from "../contract/messages";
import type {Problem} from "./problem";
import {Workbench} from "./workbench.svelte";

/** `asked`: the problem of each round. */
export function searching_workbench(
  problem: Problem,
  find: () => Replies["best"],
): {workbench: Workbench; asked: string[]} {
  const workbench = new Workbench(problem),
    asked: string[] = [];
  const searching = {
    close: () => {},
    async run({rounds}: Requests["search"], {signal, progress}: Run<"search">) {
      let found = null;
      for (const [round, text] of rounds.entries()) {
        await Promise.resolve();
        if (signal?.aborted) throw new Cancelled();
        asked.push(text);
        found = find();
        progress?.({rounds: round + 1, found});
      }
      return found;
    },
  };
  workbench.start_engine = () => searching as unknown as EngineClient;
  workbench.driver_client = {run: () => Promise.resolve({linkage: {}})} as unknown as EngineClient;
  return {workbench, asked};
}
