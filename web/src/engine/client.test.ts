import {kill} from "../../tests/kill";
import {afterEach, beforeEach, describe, expect, it, vi} from "vitest";
import {Cancelled, Crashed, EngineClient, no_answer, patience_ms, Refusal, Superseded} from "./client";
import type {ReplyMessage, RequestMessage} from "../contract/messages";

/** A worker that answers when it is told to. */
class Puppet extends EventTarget {
  static all: Puppet[] = [];
  readonly asked: RequestMessage[] = [];
  onmessage: ((event: MessageEvent<ReplyMessage>) => void) | null = null;
  onerror: ((event: ErrorEvent) => void) | null = null;
  dead = false;

  constructor() {
    super();
    Puppet.all.push(this);
    this.addEventListener("error", (event) => this.onerror?.(event as ErrorEvent));
  }
  static get last(): Puppet {
    return Puppet.all[Puppet.all.length - 1]!;
  }
  postMessage(message: RequestMessage): void {
    this.asked.push(message);
  }
  terminate(): void {
    this.dead = true;
  }
  say(data: unknown): void {
    this.onmessage?.({data} as MessageEvent<ReplyMessage>);
  }
  ready(): void {
    this.say({kind: "ready", version: "1"});
  }
  /** Answers what was asked last. */
  answer(reply: object = {}): void {
    const {id, kind} = this.asked[this.asked.length - 1]!;
    this.say({id, kind, reply});
  }
}

const problem = "{}",
  tau = [0, 1] as const;
const explore = {
  problem,
  samples: 8,
  window: {input: [0, 1], output: [0, 1]},
  property: "link_ratio",
  order: "fresh",
} as const;
const crashes: [string, boolean][] = [];
let readies = 0;
function client(): EngineClient {
  return new EngineClient(
    () => new Puppet() as unknown as Worker,
    (message, resting) => crashes.push([message, resting]),
    () => ++readies,
  );
}

beforeEach(() => {
  vi.useFakeTimers();
  Puppet.all = [];
  crashes.length = readies = 0;
  vi.stubGlobal(
    "ErrorEvent",
    class extends Event {
      message: string;
      constructor(type: string, init: ErrorEventInit) {
        super(type, init);
        this.message = init.message ?? "";
      }
    },
  );
});
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

describe("one engine worker", () => {
  it("is asked nothing before it is ready, and one thing at a time", async () => {
    const engine = client();
    const first = engine.follow("linkage", {problem, tau}),
      second = engine.follow("live", {problem, tau});
    expect(Puppet.last.asked).toEqual([]);
    Puppet.last.ready();
    expect(readies).toBe(1);
    expect(Puppet.last.asked.map((m) => m.kind)).toEqual(["linkage"]);
    Puppet.last.answer({linkage: 1});
    expect(await first).toEqual({linkage: 1});
    expect(Puppet.last.asked.map((m) => m.kind)).toEqual(["linkage", "live"]);
    Puppet.last.answer({input: 2});
    expect(await second).toEqual({input: 2});
    expect(engine.busy).toBe(false);
  });
  it("answers the last of each kind that waits", async () => {
    const engine = client();
    Puppet.last.ready();
    const running = engine.follow("linkage", {problem, tau: [0, 0]});
    const lost = expect(engine.follow("linkage", {problem, tau: [1, 1]})).rejects.toBeInstanceOf(Superseded);
    const last = engine.follow("linkage", {problem, tau: [2, 2]});
    await lost;
    Puppet.last.answer({n: 0});
    expect(await running).toEqual({n: 0});
    expect(Puppet.last.asked[1]).toMatchObject({tau: [2, 2]});
    Puppet.last.answer({n: 2});
    expect(await last).toEqual({n: 2});
  });
  it("lets a map wait for all others", () => {
    const engine = client();
    Puppet.last.ready();
    void engine.follow("live", {problem, tau});
    void engine.follow("explore", explore);
    void engine.follow("linkage", {problem, tau});
    Puppet.last.answer();
    expect(Puppet.last.asked.map((m) => m.kind)).toEqual(["live", "linkage"]);
    Puppet.last.answer();
    expect(Puppet.last.asked.map((m) => m.kind)).toEqual(["live", "linkage", "explore"]);
  });
  it("drops what is not wanted any more", async () => {
    const engine = client();
    const lost = expect(
      engine.follow("halo", {problem, part: 0, mode: "move", reach: 1, steps: 3, samples: 8}),
    ).rejects.toBeInstanceOf(Superseded);
    engine.cancel("halo");
    await lost;
    Puppet.last.ready();
    expect(Puppet.last.asked).toEqual([]);
  });
  it("hands on the caller's mistakes", async () => {
    const engine = client();
    Puppet.last.ready();
    const read = engine.follow("read", {text: "{"});
    Puppet.last.say({
      id: Puppet.last.asked[0]!.id,
      kind: "read",
      refused: {mistakes: [{code: "invalid_json", place: "line 1, column 2", message: "the file breaks off here"}]},
    });
    const refusal = await read.catch((error: unknown) => error);
    expect(refusal).toBeInstanceOf(Refusal);
    expect((refusal as Refusal).message).toBe("line 1, column 2: the file breaks off here");
  });
  it("takes no notice of answers to what it did not ask", async () => {
    const engine = client();
    Puppet.last.ready();
    const reply = engine.follow("verify", {problem, tau});
    Puppet.last.say({id: 999, kind: "verify", reply: {verified: false}});
    expect(engine.busy).toBe(true);
    Puppet.last.answer({verified: true});
    expect(await reply).toEqual({verified: true});
  });
});

describe("a worker that dies", () => {
  it("is started again, loses what it had and goes on with what waits", async () => {
    const engine = client(),
      first = Puppet.last;
    first.ready();
    const lost = expect(engine.follow("explore", explore)).rejects.toBeInstanceOf(Crashed);
    const waits = engine.follow("linkage", {problem, tau});
    kill(engine);
    await lost;
    expect(first.dead).toBe(true);
    expect(crashes).toEqual([["killed", false]]);
    expect(Puppet.all.length).toBe(2);
    first.say({kind: "ready", version: "1"}); // the dead are not heard
    expect(Puppet.last.asked).toEqual([]);
    Puppet.last.ready();
    Puppet.last.answer({linkage: 1});
    expect(await waits).toEqual({linkage: 1});
  });
  it("may say so itself", () => {
    client();
    Puppet.last.ready();
    Puppet.last.say({kind: "crashed", message: "out of memory"});
    expect(crashes).toEqual([["out of memory", false]]);
    expect(Puppet.all.length).toBe(2);
  });
  it("time after time is started ever later, then let rest until it is wanted", async () => {
    const engine = client();
    for (const delay of [0, 250, 500]) {
      Puppet.last.ready();
      Puppet.last.say({kind: "crashed", message: "again"});
      const before = Puppet.all.length;
      vi.advanceTimersByTime(delay);
      expect(Puppet.all.length - before, `after ${delay} ms`).toBe(delay ? 1 : 0); // the first one at once
    }
    Puppet.last.ready();
    Puppet.last.say({kind: "crashed", message: "again"});
    expect(crashes.map(([, resting]) => resting)).toEqual([false, false, false, true]);
    expect(engine.resting).toBe(true);
    vi.advanceTimersByTime(1e6);
    expect(Puppet.all.length).toBe(4);
    const waits = engine.follow("linkage", {problem, tau});
    engine.restart();
    expect(engine.resting).toBe(false);
    expect(Puppet.all.length).toBe(5);
    Puppet.last.ready();
    Puppet.last.answer({linkage: 3});
    expect(await waits).toEqual({linkage: 3});
  });
  /** Answers well, then dies. */
  async function dies_after_an_answer(engine: EngineClient): Promise<void> {
    Puppet.last.ready();
    const reply = engine.follow("linkage", {problem, tau});
    Puppet.last.answer({});
    await reply;
    Puppet.last.say({kind: "crashed", message: "again"});
  }
  it("after each good answer is not started for ever", async () => {
    const engine = client();
    for (let i = 0; i < 100 && !engine.resting; ++i) {
      await dies_after_an_answer(engine);
      vi.advanceTimersByTime(4000);
    }
    expect(Puppet.all.length).toBe(6);
    expect(crashes.map(([, resting]) => resting)).toEqual([false, false, false, false, false, true]);
  });
  it("that rests is woken by what somebody waits for, and that is told where it goes on dying", async () => {
    const engine = client();
    while (!engine.resting) {
      Puppet.last.say({kind: "crashed", message: "again"});
      vi.advanceTimersByTime(4000);
    }
    const before = Puppet.all.length,
      answered = engine.run({kind: "linkage", problem, tau});
    expect(Puppet.all.length).toBe(before + 1);
    Puppet.last.ready();
    Puppet.last.answer({linkage: 3});
    expect(await answered).toEqual({linkage: 3});
    const lost = expect(engine.run({kind: "linkage", problem, tau})).rejects.toThrow(Crashed);
    while (!engine.resting) {
      Puppet.last.say({kind: "crashed", message: "again"});
      vi.advanceTimersByTime(4000);
    }
    await lost;
  });
  it("now and then is started again every time", async () => {
    const engine = client();
    for (let i = 0; i < 20; ++i) {
      await dies_after_an_answer(engine);
      vi.advanceTimersByTime(120_000);
    }
    expect(engine.resting).toBe(false);
    expect(Puppet.all.length).toBe(21);
  });
  it("that gives no answer is ended, and what waits goes on", async () => {
    const engine = client(),
      first = Puppet.last;
    first.ready();
    const lost = expect(engine.follow("verify", {problem, tau})).rejects.toBeInstanceOf(Crashed);
    const waits = engine.follow("linkage", {problem, tau});
    vi.advanceTimersByTime(patience_ms - 1);
    expect(first.dead).toBe(false);
    vi.advanceTimersByTime(1);
    await lost;
    expect(first.dead).toBe(true);
    expect(crashes).toEqual([[no_answer, false]]);
    Puppet.last.ready();
    Puppet.last.answer({linkage: 1});
    expect(await waits).toEqual({linkage: 1});
    vi.advanceTimersByTime(10 * patience_ms); // nothing is asked, so nothing is late
    expect(crashes.length).toBe(1);
  });
});

describe("what is run", () => {
  const dxf = {kind: "export", problem, tau, format: "dxf"} as const,
    svg = {kind: "export", problem, tau, format: "svg"} as const;
  it("is answered whatever else is asked meanwhile, of its own kind too", async () => {
    const engine = client();
    const first = engine.run(dxf),
      second = engine.run(svg);
    const followed = engine.follow("export", {problem, tau, format: "csv"});
    Puppet.last.ready();
    for (let i = 0; i < 3; ++i) {
      const {format} = Puppet.last.asked.at(-1) as unknown as {format: string};
      Puppet.last.answer({text: format});
      await Promise.resolve();
    }
    expect(await Promise.all([first, second, followed])).toEqual([{text: "dxf"}, {text: "svg"}, {text: "csv"}]);
  });
  it("takes turns with what follows the pointer", () => {
    const engine = client();
    for (let i = 0; i < 3; ++i) void engine.run(dxf);
    Puppet.last.ready();
    for (let i = 0; i < 4; ++i) {
      void engine.follow("linkage", {problem, tau: [i, i]}).catch(() => {}); // superseded by the next
      Puppet.last.answer();
    }
    expect(Puppet.last.asked.map(({kind}) => kind)).toEqual(["export", "linkage", "export", "linkage", "export"]);
  });
  it("outlives a worker's death once: it may be what it dies of", async () => {
    const engine = client(),
      made = engine.run(dxf);
    Puppet.last.ready();
    kill(engine);
    Puppet.last.ready();
    Puppet.last.answer({text: "x"});
    expect(await made).toEqual({text: "x"});
    const deadly = expect(engine.run(svg)).rejects.toBeInstanceOf(Crashed);
    for (let i = 0; i < 2; ++i) {
      kill(engine);
      vi.advanceTimersByTime(4000);
      Puppet.last.ready();
    }
    await deadly;
    expect(engine.busy).toBe(false);
  });
  it("leaves the queue when it is cancelled, and what was cancelled before is not asked", async () => {
    const engine = client(),
      stop = new AbortController();
    Puppet.last.ready();
    void engine.run(dxf);
    const cancelled = expect(engine.run(svg, {signal: stop.signal})).rejects.toBeInstanceOf(Cancelled);
    stop.abort();
    await cancelled;
    await expect(engine.run(svg, {signal: stop.signal})).rejects.toBeInstanceOf(Cancelled);
    Puppet.last.answer({text: "x"});
    expect(Puppet.last.asked.map((message) => "format" in message && message.format)).toEqual(["dxf"]);
    expect(engine.busy).toBe(false);
  });
  it("that is cancelled at work ends its worker after a moment, without a death being told", async () => {
    const engine = client(),
      first = Puppet.last,
      stop = new AbortController();
    first.ready();
    const cancelled = expect(engine.run(dxf, {signal: stop.signal})).rejects.toBeInstanceOf(Cancelled);
    const waits = engine.run(svg);
    stop.abort();
    await cancelled;
    expect(first.dead).toBe(false);
    vi.advanceTimersByTime(1000);
    expect(first.dead).toBe(true);
    expect(crashes).toEqual([]);
    Puppet.last.ready();
    Puppet.last.answer({text: "x"});
    expect(await waits).toEqual({text: "x"});
  });
  it("that ends soon after it was cancelled keeps its worker", () => {
    const engine = client(),
      stop = new AbortController();
    Puppet.last.ready();
    engine.run(dxf, {signal: stop.signal}).catch(() => {});
    stop.abort();
    Puppet.last.answer({text: "x"});
    vi.advanceTimersByTime(10_000);
    expect(Puppet.all.length).toBe(1);
  });
  it("tells how far it is, and is waited for as long as it does", async () => {
    const engine = client(),
      heard: number[] = [];
    Puppet.last.ready();
    const found = engine.run(
      {kind: "search", rounds: ["{}", "{}"], most: 1},
      {progress: ({rounds}) => heard.push(rounds)},
    );
    const {id, kind} = Puppet.last.asked[0]!;
    for (const rounds of [1, 2]) {
      vi.advanceTimersByTime(patience_ms - 1);
      Puppet.last.say({id, kind, tidings: {rounds, found: {}}});
    }
    vi.advanceTimersByTime(patience_ms - 1);
    Puppet.last.answer({linkages: []});
    expect(await found).toEqual({linkages: []});
    expect(heard).toEqual([1, 2]);
    expect(crashes).toEqual([]);
  });
});
