// For tests: the one state with the real engine behind it, in this thread.
import {afterEach, beforeAll} from "vitest";
import {load_module} from "../engine/node";
import type {Kind, ReplyMessage, RequestMessage} from "../contract/messages";
import {Engine} from "../engine/serve";
import {preferences} from "./preferences.svelte";
import type {Problem} from "./problem";
import {Workbench} from "./workbench.svelte";

let servers: (() => Engine)[];

/** What the engine says a map took; null: the truth. */
interface Machine {
  map_ms: number | null;
  /** How much later what is asked for comes. */
  late_ms: {[K in Kind]?: number};
  /** It does not answer. */
  mute: boolean;
}
/** Answers a little later, as a worker does. */
class Thread {
  onmessage: ((event: MessageEvent<ReplyMessage>) => void) | null = null;
  dead = false;
  constructor(
    private readonly server: Engine,
    private readonly asked: RequestMessage[],
    private readonly machine: Machine,
  ) {
    setTimeout(() => this.say({kind: "ready", version: "test"}));
  }
  postMessage(message: RequestMessage): void {
    this.asked.push(message);
    if (this.machine.mute) return;
    setTimeout(() => {
      if (!this.dead) this.say(this.slowed(this.server.serve(message).message));
    }, this.machine.late_ms[message.kind] ?? 0);
  }
  private slowed(reply: ReplyMessage): ReplyMessage {
    type Timed = {engine_ms?: number; live?: Timed | null};
    const answer = (reply as {reply?: Timed}).reply,
      {map_ms} = this.machine;
    for (const part of [answer, answer?.live])
      if (part?.engine_ms !== undefined && map_ms !== null) part.engine_ms = map_ms;
    return reply;
  }
  terminate(): void {
    this.dead = true;
  }
  private say(data: ReplyMessage): void {
    if (!this.dead) this.onmessage?.({data} as MessageEvent<ReplyMessage>);
  }
}

beforeAll(async () => {
  const modules = [await load_module(), await load_module()];
  servers = modules.map((module) => () => new Engine(module));
  preferences.colour_by = "type";
});

const open: Workbench[] = [];
/** Nobody waits for the fine map of a test that is over. */
afterEach(() => {
  for (const {engine, driver_client} of open.splice(0)) for (const client of [engine, driver_client]) client?.close();
});

export interface Bench {
  workbench: Workbench;
  asked: RequestMessage[];
  now: {time: number};
  machine: Machine;
}
export function bench(problem: Problem, cores = 2): Bench {
  const now = {time: 0},
    asked: RequestMessage[] = [],
    machine: Machine = {map_ms: null, late_ms: {}, mute: false};
  const workbench = new Workbench(problem, () => now.time);
  open.push(workbench);
  let started = 0;
  workbench.connect(() => new Thread(servers[started++ % 2]!(), asked, machine) as unknown as Worker, cores);
  return {workbench, asked, now, machine};
}
export async function until(what: () => unknown, ms = 20_000): Promise<void> {
  const end = performance.now() + ms;
  while (!what()) {
    if (performance.now() > end) throw new Error(`never: ${what}`);
    await new Promise((resolve) => setTimeout(resolve, 2));
  }
}
/** Until nothing more will come by itself but what is finer. */
export async function settled({workbench}: Bench): Promise<void> {
  await until(
    () =>
      workbench.questions.settled() &&
      workbench.is_current &&
      workbench.picked !== null &&
      workbench.hand !== null &&
      workbench.picked_linkage?.tau.join() === workbench.picked.tau.join(),
  );
}
export const digest = ({workbench}: Bench) =>
  JSON.stringify([workbench.document, workbench.picked_linkage, workbench.task!.axes.input]);
