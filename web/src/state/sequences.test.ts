// Whatever is done, in whatever order, and whatever dies meanwhile: nothing is lost. A model keeps the documents and where
// undo stands in them; workbench and store have to agree with it after every action.
import fc from "fast-check";
import {kill} from "../../tests/kill";
import {afterAll, beforeAll, describe, expect, it, vi} from "vitest";
import {patience_ms, type EngineClient} from "../engine/client";
import type {Kind, RequestMessage, Requests, TauPair} from "../contract/messages";
import {straight_axis} from "../../tests/axes";
import {keep_work, own_slot, read_work, type Store} from "../shell/storage";
import {new_problem} from "../kinds/motion/kind";
import {function_kind} from "../kinds/function/kind";
import {with_requirements, with_view, type Pin, type Problem} from "./problem";
import {poses_of} from "./task";
import {Workbench} from "./workbench.svelte";
import {with_pose, with_poses} from "../kinds/kind_dispatch";

// ---- an engine that is none -----------------------------------------------------------------------------------------

const refused_x = 666,
  rest_ms = 5000;
const linkage = (tau: unknown) => ({
  tau,
  type: "crank_rocker",
  input: {center: [0, 0], circle: [1, 0]},
  output: {center: [2, 0], circle: [1, 1]},
  fails: 0,
  drive: null,
  lengths: null,
  link_ratio: 2,
  longest: 2,
  min_transmission_angle_deg: 40,
});
const replies: Partial<Record<Kind, (request: never) => object>> = {
  explore: ({samples, window, property, picked}: Requests["explore"]) => ({
    task: {status: "solved", axes: {input: straight_axis, output: straight_axis}},
    engine_ms: 1,
    map: {samples, window, property, type: {length: 100}, census: {meeting: 1}},
    linkage: picked ? linkage(picked.place ?? picked.tau) : null, // τ and places are the same on this axis
    live: null,
  }),
  linkage: ({tau}: {tau: unknown}) => ({linkage: linkage(tau), engine_ms: 1}),
  best: () => ({linkages: [{tau: [0.5, 0.5], type: "crank_rocker"}]}),
  verify: () => ({verified: true, residual: 0}),
};
let hangs = false;
const met = {hung: 0, killed_at_work: 0, late_pins: 0};
class FakeWorker extends EventTarget {
  onmessage: ((event: object) => void) | null = null;
  onerror: ((event: Event) => void) | null = null;
  private dead = false;

  constructor() {
    super();
    this.addEventListener("error", (event) => this.onerror?.(event));
    setTimeout(() => this.say({kind: "ready", version: "0"}));
  }
  postMessage(message: RequestMessage): void {
    const {id, kind} = message,
      refused = "problem" in message && message.problem.includes(`"x":${refused_x},`);
    if (hangs) return void ++met.hung;
    const reply = refused
      ? {refused: {mistakes: [{code: "refused", place: "task", message: "no"}]}}
      : {reply: replies[kind]?.(message as never) ?? {}};
    setTimeout(() => this.say({id, kind, ...reply}), kind === "explore" ? 3 : 1);
  }
  terminate(): void {
    this.dead = true;
  }
  private say(data: object): void {
    if (!this.dead) this.onmessage?.({data});
  }
}

// ---- a browser that is none -----------------------------------------------------------------------------------------

function store(): Store {
  const items = new Map<string, string>();
  return {
    get length() {
      return items.size;
    },
    key: (i) => [...items.keys()][i] ?? null,
    getItem: (key) => items.get(key) ?? null,
    setItem: (key, text) => void items.set(key, text),
    removeItem: (key) => void items.delete(key),
  };
}
beforeAll(() => {
  vi.useFakeTimers();
  vi.stubGlobal("document", Object.assign(new EventTarget(), {visibilityState: "visible"}));
  vi.stubGlobal("addEventListener", () => {});
  vi.stubGlobal("removeEventListener", () => {});
  vi.stubGlobal("ErrorEvent", class extends Event {});
});
afterAll(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

class Page {
  workbench!: Workbench;
  private readonly local = store();
  private readonly session = store();
  private end = () => {};

  constructor() {
    this.open();
  }
  open(): void {
    const slot = own_slot(this.local, this.session),
      kept = read_work(slot, this.local);
    this.workbench = new Workbench(kept ?? new_problem());
    this.workbench.slot = slot;
    this.workbench.connect(() => new FakeWorker() as unknown as Worker, 2);
    this.end = keep_work(this.workbench, kept?.at ?? 0, this.local, this.session);
  }
  /** The page goes, without a moment's rest, and comes again. */
  reload(): void {
    this.close();
    this.open();
  }
  close(): void {
    this.end();
    this.workbench.maps.stop();
    for (const client of this.clients) client.close();
  }
  get clients(): EngineClient[] {
    return [this.workbench.engine!, this.workbench.driver_client!];
  }
}

// ---- the model and what can be done ---------------------------------------------------------------------------------

interface Kept {
  problem: Problem;
  pins: readonly Pick<Pin, "name" | "note" | "shown" | "tau" | "task">[];
}
class Model {
  private steps: Kept[];
  private at = 0;
  constructor(first: Problem) {
    this.steps = [{problem: first, pins: []}];
  }
  get now(): Kept {
    return this.steps[this.at]!;
  }
  get can(): [undo: boolean, redo: boolean] {
    return [this.at > 0, this.at < this.steps.length - 1];
  }
  step(next: Partial<Kept>): void {
    this.steps = [...this.steps.slice(0, this.at + 1), {...this.now, ...next}];
    ++this.at;
  }
  move(by: 1 | -1): void {
    this.at = Math.min(Math.max(this.at + by, 0), this.steps.length - 1);
  }
}
type Action = {name: string; by: number};
type Doing = (page: Page, model: Model, by: number) => void | Promise<unknown>;

/** The same change here and there. */
function edited(change: (problem: Problem, by: number) => Problem): Doing {
  return ({workbench}, model, by) => {
    const before = workbench.problem,
      after = change(before, by);
    workbench.edit(() => after);
    if (!refused(after)) model.step({problem: after});
  };
}
const refused = (problem: Problem) =>
  poses_of(problem.task).length >= 4 && JSON.stringify(problem.task).includes(`"x":${refused_x},`);
const last = (problem: Problem) => Math.max(poses_of(problem.task).length - 1, 0);
const doings: Record<string, Doing> = {
  move: edited((problem, by) => with_pose(problem, by % (last(problem) + 1), {x: by + 0.125, y: 1 - by})),
  refused: edited((problem) => with_pose(problem, last(problem), {x: refused_x})),
  limit: edited((problem, by) => with_requirements(problem, {max_link_ratio: by % 3 ? by + 2 : null})),
  title: edited((problem, by) => ({...problem, title: `task ${by} …`})),
  outline: edited((problem, by) =>
    with_view(problem, {
      outline: [
        [0, 0],
        [by + 1, 0],
        [0, 1],
      ],
    }),
  ),
  remove: edited((problem) => (last(problem) > 2 ? with_poses(problem, poses_of(problem.task).slice(0, -1)) : problem)),
  add: edited((problem, by) =>
    last(problem) < 3
      ? with_poses(problem, [...poses_of(problem.task), {x: 1000 + by, y: by, theta_deg: by}])
      : problem,
  ),
  drag: async ({workbench}, model, by) => {
    workbench.begin_gesture();
    for (let i = 0; i < 3; ++i) {
      workbench.drag((problem) => with_pose(problem, 0, {x: by + i + 0.25}));
      await vi.advanceTimersByTimeAsync(by % 7);
    }
    const {problem} = workbench;
    if (by % 4 === 0) return workbench.cancel_gesture();
    workbench.end_gesture();
    if (JSON.stringify(problem) !== JSON.stringify(model.now.problem)) model.step({problem});
  },
  pin: async ({workbench}, model, by) => {
    const count = workbench.pins.length;
    const tau: TauPair = [(by % 50) / 100, 0.9];
    await Promise.all([workbench.pin_at(tau), vi.advanceTimersByTimeAsync(rest_ms)]);
    if (workbench.pins.length > count)
      model.step({
        pins: [
          ...model.now.pins,
          {name: workbench.pins.at(-1)!.name, note: undefined, shown: undefined, tau, task: model.now.problem.task},
        ],
      });
  },
  /** The task changes before the engine has answered: there is nothing to pin. */
  pin_late: async (page, model, by) => {
    const asked = page.workbench.pin_at([by / 1000, 0.7]);
    void edited((problem) => ({...problem, title: `late ${++met.late_pins}`}))(page, model, by);
    await Promise.all([asked, vi.advanceTimersByTimeAsync(rest_ms)]);
  },
  rename: ({workbench}, model, by) => {
    const pin = workbench.pins[by % (workbench.pins.length || 1)],
      to = {name: `No. ${by}, lid…`, note: `noted ${by}`, shown: true};
    if (!pin || workbench.pins.some(({name}) => name === to.name)) return;
    workbench.change_pin(pin.name, to);
    model.step({pins: model.now.pins.map((other) => (other.name === pin.name ? {...other, ...to} : other))});
  },
  unpin: ({workbench}, model, by) => {
    const pin = workbench.pins[by % (workbench.pins.length || 1)];
    if (!pin) return;
    workbench.unpin(pin.name);
    model.step({pins: model.now.pins.filter(({name}) => name !== pin.name)});
  },
  open: ({workbench}, model, by) => {
    const problem = {...(by % 2 ? new_problem() : function_kind.beginnings[0]!.make()), title: `opened ${by}`};
    workbench.open(problem);
    model.step({problem, pins: []});
  },
  hover: ({workbench}, _, by) => workbench.hover(by % 3 ? [by / 1000, 0.2] : null),
  undo: ({workbench}, model) => (workbench.undo(), model.move(-1)),
  redo: ({workbench}, model) => (workbench.redo(), model.move(1)),
  reload: (page) => page.reload(),
  kill: (page, _, by) => {
    set_to_work(page, by);
    const client = page.clients[by % 2];
    met.killed_at_work += Number(client!.busy);
    kill(client!);
  },
  hang: async (page, _, by) => {
    hangs = true;
    set_to_work(page, by);
    await vi.advanceTimersByTimeAsync(patience_ms + rest_ms);
    hangs = false;
    await vi.advanceTimersByTimeAsync(patience_ms + rest_ms); // what was asked again meanwhile hangs, too
  },
};
function set_to_work({workbench}: Page, by: number): void {
  workbench.best_list.question.forget();
  void workbench.best_list.fetch();
  void workbench.linkages.fetch([by / 1000, 0.3]);
}
const action: fc.Arbitrary<Action> = fc.record({name: fc.constantFrom(...Object.keys(doings)), by: fc.nat(500)});

/** With reloads in between that wait for nothing. */
async function followed(actions: readonly Action[]): Promise<void> {
  const page = new Page(),
    model = new Model(page.workbench.problem);
  await vi.advanceTimersByTimeAsync(rest_ms);
  for (const {name, by} of actions) {
    await doings[name]!(page, model, by);
    if (by % 5 === 0 && !refused(page.workbench.problem)) page.reload(); // before the engine has refused it, it is the work that there is
    await vi.advanceTimersByTimeAsync(rest_ms);
    const {problem, pins, can_undo, can_redo} = page.workbench;
    expect(
      {
        problem,
        pins: pins.map(({name, note, shown, tau, task}) => ({name, note, shown, tau, task})),
        can: [can_undo, can_redo],
      },
      name,
    ).toEqual({...model.now, can: model.can});
  }
  page.close();
}

const seed = Number(process.env.SEQUENCES_SEED ?? 1); // another seed, other sequences
describe("1,000 sequences of actions, with reloads and with workers that die or hang", () => {
  it("lose nothing", async () => {
    await fc.assert(fc.asyncProperty(fc.array(action, {minLength: 1, maxLength: 25}), followed), {
      numRuns: 1000,
      seed,
      endOnFailure: true,
    });
    expect(met.hung).toBeGreaterThan(100);
    expect(met.killed_at_work).toBeGreaterThan(100);
  }, 120_000);
});
