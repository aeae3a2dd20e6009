// The one state with the real engine behind it, in this thread.
import {readFileSync} from "node:fs";
import {afterEach, beforeAll, describe, expect, it} from "vitest";
import {create_linkwright} from "../engine/module";
import type {ReplyMessage, RequestMessage} from "../engine/protocol";
import {Server} from "../engine/serve";
import {targets} from "../exports/take_away";
import {examples, first_example} from "../gallery/gallery";
import {fetch_pin} from "../pins/fetch";
import {engine_text, with_options, with_requirements, type Problem} from "./problem";
import {fresh_function, function_kind} from "../tasks/function/kind";
import {pairs_of, with_named} from "../tasks/function/pairs";
import {new_problem} from "../tasks/motion/kind";
import {preferences} from "./preferences.svelte";
import {Workbench} from "./workbench.svelte";
import {poses_of} from "./task";
import {with_pose, with_poses} from "../tasks/kinds";

const wasm = readFileSync(new URL("../engine/generated/linkwright.wasm", import.meta.url));
const tailgate = first_example.problem,
  footrest = examples.find(({name}) => name === "footrest")!.problem;
let servers: (() => Server)[];

/** What the engine says a map took; null: the truth. */
interface Machine {
  map_ms: number | null;
  /** How much later the best linkages come. */
  best_ms: number;
  /** It does not answer. */
  mute: boolean;
}
/** Answers a little later, as a worker does. */
class Thread {
  onmessage: ((event: MessageEvent<ReplyMessage>) => void) | null = null;
  dead = false;
  constructor(
    private readonly server: Server,
    private readonly asked: RequestMessage[],
    private readonly machine: Machine,
  ) {
    setTimeout(() => this.say({kind: "ready", version: "test"}));
  }
  postMessage(message: RequestMessage): void {
    this.asked.push(message);
    if (!this.machine.mute)
      setTimeout(
        () => !this.dead && this.say(this.slowed(this.server.serve(message).message)),
        message.kind === "best" ? this.machine.best_ms : 0,
      );
  }
  private slowed(reply: ReplyMessage): ReplyMessage {
    const answer = (reply as {reply?: {engine_ms?: number}}).reply;
    if (answer?.engine_ms !== undefined && this.machine.map_ms !== null) answer.engine_ms = this.machine.map_ms;
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
  const modules = [await create_linkwright({wasmBinary: wasm}), await create_linkwright({wasmBinary: wasm})];
  servers = modules.map((module) => () => new Server(module));
  preferences.colour_by = "type";
});

const open: Workbench[] = [];
/** Nobody waits for the fine map of a test that is over. */
afterEach(() => {
  for (const {engine, driver_client} of open.splice(0)) for (const client of [engine, driver_client]) client?.close();
});

interface Bench {
  workbench: Workbench;
  asked: RequestMessage[];
  now: {time: number};
  machine: Machine;
}
function bench(problem: Problem, cores = 2): Bench {
  const now = {time: 0},
    asked: RequestMessage[] = [],
    machine: Machine = {map_ms: null, best_ms: 0, mute: false};
  const workbench = new Workbench(problem, () => now.time);
  open.push(workbench);
  let started = 0;
  workbench.connect(() => new Thread(servers[started++ % 2]!(), asked, machine) as unknown as Worker, cores);
  return {workbench, asked, now, machine};
}
async function until(what: () => unknown, ms = 20_000): Promise<void> {
  const end = performance.now() + ms;
  while (!what()) {
    if (performance.now() > end) throw new Error(`never: ${what}`);
    await new Promise((resolve) => setTimeout(resolve, 2));
  }
}
/** Until nothing more will come by itself but the fine map. */
async function settled({workbench}: Bench): Promise<void> {
  await until(
    () =>
      workbench.is_current && workbench.picked !== null && workbench.picked_linkage !== null && workbench.hand !== null,
  );
  await until(() => workbench.picked_linkage!.tau.join() === workbench.picked!.tau.join());
  await new Promise((resolve) => setTimeout(resolve, 60));
}
const digest = ({workbench}: Bench) =>
  JSON.stringify([workbench.document, workbench.picked_linkage, workbench.task!.axes.input]);

describe("the workbench", () => {
  it("starts with the best linkage in hand", async () => {
    const b = bench(tailgate);
    await settled(b);
    expect(b.workbench.can_undo).toBe(false);
    expect(b.workbench.census!.meeting).toBe(25608);
    expect(b.workbench.hand!.min_transmission_angle_deg).toBeCloseTo(83.7, 1);
    await until(() => b.workbench.verified?.verified);
  });

  it("starts with the best linkage of a task that came while the first one's was sought", async () => {
    const b = bench(tailgate),
      other = examples.find(({name}) => name === "log_generator")!.problem;
    b.machine.best_ms = 1500; // later than any map
    await until(() => b.asked.some(({kind}) => kind === "best"));
    b.workbench.open(other);
    await settled(b);
    expect(b.workbench.problem.title).toBe(other.title);
    expect(b.workbench.hand!.function).toBeDefined();
  });

  it("says that the best is sought from the moment a map is there until it is picked", async () => {
    const b = bench(tailgate),
      {workbench} = b;
    b.machine.best_ms = 200;
    await until(() => workbench.is_current);
    expect([workbench.seeker.seeking, workbench.picked]).toEqual([true, null]);
    await until(() => !workbench.seeker.seeking);
    expect(workbench.picked).not.toBeNull();
    await settled(b);
  });

  it("brings back a pin of pairs from a named function, whose objective pairs have not", async () => {
    const pairs = function_kind.beginnings[0]!.make(),
      b = bench(pairs),
      {workbench} = b;
    await settled(b);
    workbench.pin();
    const [pin] = workbench.pins;
    workbench.edit((problem) =>
      with_options(with_named(problem, fresh_function(pairs_of(workbench))), {objective: "structural_error"}),
    );
    await until(() => workbench.is_current);
    expect((await fetch_pin(workbench.driver_client!, workbench.problem, pin!))?.lengths).toEqual(pin!.lengths);
    const {problem} = targets(workbench).find((target) => target.pin === pin!.name)!;
    expect(problem).toMatchObject({task: pairs.task, options: {}});
    workbench.pick_pin(pin!);
    await until(() => workbench.is_current || workbench.refusal);
    expect(workbench.refusal).toBeNull();
    expect(workbench.problem.task).toEqual(pairs.task);
    expect(workbench.problem.options).toEqual({});
    await settled(b);
    workbench.undo();
    expect(workbench.problem.options?.objective).toBe("structural_error");
  });

  it("makes one step of a drag, and undo brings back everything to the last bit", async () => {
    const b = bench(tailgate),
      {workbench} = b;
    await settled(b);
    const before = digest(b);
    workbench.begin_gesture();
    for (let i = 1; i <= 8; ++i) {
      workbench.drag((problem) => with_pose(problem, 2, {x: -220 + 2 * i, y: 220 - i}));
      await new Promise((resolve) => setTimeout(resolve, 15));
    }
    workbench.end_gesture();
    await settled(b);
    const after = digest(b);
    expect(after).not.toBe(before);
    expect(workbench.picked!.place).toEqual(JSON.parse(before)[0].picked.place); // it stays in place on the map
    workbench.undo();
    await settled(b);
    expect(digest(b)).toBe(before);
    expect(workbench.can_undo).toBe(false);
    workbench.redo();
    await settled(b);
    expect(digest(b)).toBe(after);
  });

  it("leaves no step where a drag ends where it began, or is cancelled", async () => {
    const b = bench(tailgate),
      {workbench} = b;
    await settled(b);
    const before = digest(b);
    workbench.begin_gesture();
    workbench.drag((problem) => with_pose(problem, 1, {x: -100}));
    workbench.drag((problem) => with_pose(problem, 1, {x: -125}));
    workbench.end_gesture();
    workbench.begin_gesture();
    workbench.drag((problem) => with_pose(problem, 1, {x: -90}));
    workbench.cancel_gesture();
    await settled(b);
    expect(digest(b)).toBe(before);
    expect(workbench.can_undo).toBe(false);
  });

  it("keeps the last good state when a drag ends where the engine refuses", async () => {
    const b = bench(tailgate),
      {workbench} = b,
      poses = poses_of(tailgate.task);
    await settled(b);
    workbench.begin_gesture();
    workbench.drag((problem) => with_pose(problem, 2, {x: -222}));
    await until(() => workbench.is_current);
    workbench.drag((problem) => with_pose(problem, 2, {...poses[1]}));
    await until(() => workbench.refusal !== null);
    expect(workbench.refusal![0]!.code).toBe("repeated_pose");
    expect(workbench.map).not.toBeNull();
    workbench.end_gesture();
    await settled(b);
    expect(poses_of(workbench.problem.task)[2]!.x).toBe(-222);
    expect(workbench.refusal).toBeNull();
    workbench.undo();
    expect(poses_of(workbench.problem.task)[2]!.x).toBe(-220);
    expect(workbench.can_undo).toBe(false);
  });

  it("takes back a typed value that the engine refuses, and only that", async () => {
    const b = bench(tailgate),
      {workbench} = b;
    await settled(b);
    workbench.pin();
    expect(workbench.pins.length).toBe(1);
    workbench.edit((problem) => with_pose(problem, 2, {...poses_of(tailgate.task)[1]}));
    await until(() => workbench.refusal !== null);
    expect(poses_of(workbench.problem.task)).toEqual(poses_of(tailgate.task));
    expect(workbench.pins.length).toBe(1);
    workbench.undo();
    expect(workbench.pins.length).toBe(0); // the pin was the last step: the refused one left none
    expect(workbench.can_undo).toBe(false);
  });

  it("shows no map that comes late to a task without one", async () => {
    const b = bench(tailgate),
      {workbench} = b;
    await settled(b);
    workbench.edit((problem) => with_pose(problem, 2, {x: -219}));
    workbench.edit((problem) => with_poses(problem, poses_of(problem.task).slice(1)));
    await new Promise((resolve) => setTimeout(resolve, 300));
    expect(workbench.incomplete?.state).toBe("no_given");
    expect([workbench.task, workbench.map, workbench.hand]).toEqual([null, null, null]);
    workbench.undo();
    await settled(b);
    expect(poses_of(workbench.problem.task)[2]!.x).toBe(-219);
  });

  it("shows nothing of a linkage beside a task that has none", async () => {
    const b = bench(tailgate),
      {workbench} = b;
    await settled(b);
    await until(() => workbench.verified);
    const shown = () => [
      workbench.map,
      workbench.census,
      workbench.hand,
      workbench.picked_linkage,
      workbench.live,
      workbench.verified,
    ];
    workbench.hover([1.3125, 1.1125]); // asked of the old task, answered after the new one
    workbench.edit((problem) => ({...problem, task: {...footrest.task, given: {side_length: 5}} as Problem["task"]}));
    await until(() => workbench.task?.reason?.code === "no_side_link_of_length");
    for (let i = 0; i < 20; ++i) {
      expect(shown()).toEqual([null, null, null, null, null, null]);
      await new Promise((resolve) => setTimeout(resolve, 5));
    }
    workbench.hover(null);
    workbench.undo();
    await settled(b);
    await until(() => workbench.verified?.verified);
    expect(shown()).not.toContain(null);
  });

  it("never says that driving has checked what it has not: another linkage, another task", async () => {
    const b = bench(tailgate),
      {workbench} = b;
    await settled(b);
    await until(() => workbench.verified?.verified);
    workbench.hover([1.3125, 1.1125]);
    await until(() => workbench.hand!.tau[0] === 1.3125);
    expect(workbench.verified).toBeNull();
    workbench.hover(null);
    expect(workbench.verified).not.toBeNull();
    workbench.begin_gesture();
    workbench.drag((problem) => with_pose(problem, 2, {x: -219}));
    expect(workbench.verified).toBeNull();
    await until(() => workbench.is_current);
    expect(workbench.verified).toBeNull();
    workbench.cancel_gesture();
    await settled(b);
    await until(() => workbench.verified?.verified);
  });

  it("pins the linkage of the task as it is, not the one that is still on screen", async () => {
    const b = bench(tailgate),
      {workbench} = b;
    await settled(b);
    const before = workbench.hand!;
    workbench.edit((problem) => with_pose(problem, 2, {x: -219}));
    workbench.pin();
    expect(workbench.pins).toEqual([]);
    await until(() => workbench.pins.length > 0);
    const [pin] = workbench.pins,
      {linkage} = await workbench.driver_client!.follow("linkage", {
        problem: engine_text(workbench.problem),
        tau: pin!.tau,
      });
    expect([pin!.task, pin!.lengths]).toEqual([workbench.problem.task, linkage.lengths]);
    expect(pin!.lengths).not.toEqual(before.lengths);
  });

  it("marks what is shown as outdated where no answer comes", async () => {
    const b = bench(tailgate),
      {workbench} = b,
      {answers} = workbench;
    await settled(b);
    const marks = () => [answers.map_outdated, answers.census_outdated, answers.hand_outdated];
    b.machine.mute = true;
    workbench.edit((problem) => with_pose(problem, 2, {x: -219}));
    expect(marks()).toEqual([false, false, false]); // not at once: in a drag the next answer is on its way
    await until(() => answers.map_outdated);
    expect(marks()).toEqual([true, true, true]);
    workbench.undo();
    expect(marks()).toEqual([false, false, false]);
    workbench.redo();
    await until(() => answers.map_outdated);
    b.machine.mute = false;
    workbench.engine!.restart();
    workbench.driver_client!.restart();
    await until(() => workbench.is_current && !marks().includes(true));
    await settled(b);
    workbench.hover([1.3125, 1.1125]);
    await until(() => workbench.hand!.tau[0] === 1.3125);
    expect(marks()).toEqual([false, false, false]);
  });

  it("lives with a task whose dyads are no curve", async () => {
    const b = bench(tailgate),
      {workbench} = b;
    await settled(b);
    workbench.edit((problem) =>
      with_poses(
        problem,
        [
          [200, 0],
          [0, 200],
          [-200, 0],
          [120, 160],
        ].map(([x, y]) => ({x: x!, y: y!, theta_deg: 0})),
      ),
    );
    await until(() => workbench.task?.status === "degenerate");
    expect(workbench.map).toBeNull();
    expect(workbench.task!.reason!.code).toBe("translations_on_circle");
    workbench.undo();
    await settled(b);
    expect(workbench.picked).not.toBeNull();
  });

  it("follows the pointer and comes back to what is picked", async () => {
    const b = bench(tailgate),
      {workbench} = b;
    await settled(b);
    const picked = workbench.picked!.tau;
    workbench.hover([1.3125, 1.1125]);
    await until(() => workbench.hand!.tau[0] === 1.3125);
    expect(workbench.hand!.min_transmission_angle_deg).toBeCloseTo(73.5, 1);
    workbench.edit((problem) => with_requirements(problem, {max_link_ratio: 7}));
    workbench.hover(null);
    await until(() => workbench.hand!.tau.join() === picked.join());
    workbench.hover([1.3125, 1.1125]);
    workbench.pick([1.3125, 1.1125]);
    await until(() => workbench.picked_linkage!.tau[0] === 1.3125); // picked while hovered
    workbench.hover(null);
    expect(workbench.hand!.tau).toEqual([1.3125, 1.1125]);
  });

  it("works with one worker as well, counts of the whole region included", async () => {
    const b = bench(tailgate, 1),
      {workbench} = b;
    await settled(b);
    const {census} = workbench;
    workbench.zoom({input: [0.2, 0.4], output: [0.5, 0.7]});
    await until(() => workbench.map!.samples === 1000 && workbench.map!.window.input[0] === 0.2);
    expect(workbench.census).toEqual(census);
    workbench.hover([1.3125, 1.1125]);
    await until(() => workbench.hand!.tau[0] === 1.3125);
  });

  it("leaves a linkage that a change has cost for the best, says so, and undo brings it back", async () => {
    const b = bench(tailgate),
      {workbench} = b,
      keys = () => workbench.toasts.map(({key}) => key);
    await settled(b);
    const picked = workbench.picked!.tau,
      longest = workbench.picked_linkage!.longest!;
    const limit = (max_length: number) => workbench.edit((problem) => with_requirements(problem, {max_length}));
    limit(Math.ceil(longest) + 1); // it still does
    await settled(b);
    await new Promise((resolve) => setTimeout(resolve, 500));
    expect([workbench.picked!.tau, keys()]).toEqual([picked, []]);
    limit(Math.floor(longest) - 1);
    await until(() => keys().includes("state.went_to_best"));
    await settled(b);
    expect(workbench.picked_linkage!.fails).toBe(0);
    const best = workbench.picked!.tau;
    workbench.undo(); // one step with the change
    await settled(b);
    expect([workbench.picked!.tau, workbench.problem.requirements!.max_length]).toEqual([
      picked,
      Math.ceil(longest) + 1,
    ]);
    workbench.redo();
    await settled(b);
    expect(workbench.picked!.tau).toEqual(best);
    workbench.undo();
    limit(Math.floor(longest) - 1);
    await until(() => keys().includes("state.went_to_best"));
    workbench.toasts[0]!.action!.run(); // keep the old one
    await settled(b);
    expect(workbench.picked!.tau).toEqual(picked);
    expect(workbench.problem.requirements!.max_length).toBe(Math.floor(longest) - 1);
    expect(workbench.picked_linkage!.fails).not.toBe(0);
    limit(Math.floor(longest) - 2); // it failed before: the user has wanted it so
    await settled(b);
    await new Promise((resolve) => setTimeout(resolve, 500));
    expect([workbench.picked!.tau, keys()]).toEqual([picked, []]);
  });

  it("stays with what it has where nothing is left, and after a step back", async () => {
    const b = bench(tailgate),
      {workbench} = b;
    await settled(b);
    const picked = workbench.picked!.tau,
      limit = (max_length: number) => workbench.edit((problem) => with_requirements(problem, {max_length}));
    limit(1);
    await until(() => workbench.census!.meeting === 0);
    await new Promise((resolve) => setTimeout(resolve, 600));
    expect([workbench.picked!.tau, workbench.toasts]).toEqual([picked, []]);
    workbench.undo();
    workbench.redo();
    workbench.undo();
    await settled(b);
    await new Promise((resolve) => setTimeout(resolve, 600));
    expect([workbench.picked!.tau, workbench.toasts]).toEqual([picked, []]);
  });

  it("opens another task as one step", async () => {
    const b = bench(tailgate),
      {workbench} = b;
    await settled(b);
    const before = digest(b);
    workbench.open(new_problem());
    await settled(b);
    expect(poses_of(workbench.problem.task)[1]!.x).toBe(-60);
    workbench.undo();
    await settled(b);
    expect(digest(b)).toBe(before);
  });

  it("opens what it saved as it was: pick, pins and the order of the map", async () => {
    const b = bench(tailgate),
      {workbench} = b;
    await settled(b);
    workbench.pin();
    const saved = JSON.parse(JSON.stringify(workbench.whole_problem)) as Problem;
    const other = bench(saved);
    await settled(other);
    expect(other.workbench.picked!.tau).toEqual(workbench.picked!.tau);
    expect(other.workbench.pins.map((pin) => [pin.name, pin.tau])).toEqual(
      workbench.pins.map((pin) => [pin.name, pin.tau]),
    );
    expect(other.workbench.task!.axes.input).toEqual(workbench.task!.axes.input);
    expect(other.workbench.map!.type).toEqual(workbench.map!.type);
  });

  it("asks the map once for what it shows already", async () => {
    const b = bench(tailgate);
    await settled(b);
    await until(() => b.workbench.map!.samples === 1000);
    await new Promise((resolve) => setTimeout(resolve, 400));
    const maps = b.asked
      .filter((message) => message.kind === "explore")
      .map((message) => (message as {samples: number}).samples);
    expect(maps).toEqual([400, 1000]);
    b.workbench.pin();
    b.workbench.pick([1.3125, 1.1025]);
    await settled(b);
    await new Promise((resolve) => setTimeout(resolve, 400));
    expect(b.asked.filter((message) => message.kind === "explore")).toHaveLength(2);
    expect(b.workbench.map!.samples).toBe(1000);
  });

  it("shows where a held position may go, closer where that is near", async () => {
    const b = bench(tailgate),
      {workbench} = b;
    await settled(b);
    workbench.begin_gesture();
    workbench.held_pose = 2;
    const wide = workbench.fetch_halo(2, "move", 120);
    await until(() => workbench.halo);
    const counts = (): number[] => Array.from(workbench.halo!.counts);
    expect(counts()[13 * 6 + 6 + 2]).toBe(0); // +40 mm in x
    await until(() => workbench.halo!.reach === 30);
    expect(counts().filter((count) => count > 0).length).toBeGreaterThan(20);
    workbench.cancel_gesture();
    await wide;
  });

  it("draws coarser maps in a drag when three in a row were slow, and tries again", async () => {
    const b = bench(tailgate),
      {workbench, machine} = b;
    machine.map_ms = 5; // the first map, too
    await settled(b);
    const dragged = async (steps: number): Promise<number[]> => {
      const seen: number[] = [];
      for (let i = 1; i <= steps; ++i) {
        workbench.drag((problem) => with_pose(problem, 2, {x: poses_of(workbench.problem.task)[2]!.x - 0.01}));
        await until(() => workbench.is_current);
        seen.push(workbench.map!.samples);
      }
      return seen;
    };
    workbench.begin_gesture();
    machine.map_ms = 40;
    const slow = await dragged(13);
    expect(slow.filter((samples) => samples === 100).length).toBeGreaterThanOrEqual(8);
    expect(slow.slice(0, 3)).toEqual([400, 400, 400]);
    machine.map_ms = 5;
    const fast = await dragged(14);
    expect(fast.slice(-4)).toEqual([400, 400, 400, 400]);
    workbench.cancel_gesture();
  });
});
