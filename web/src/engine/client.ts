import type {Kind, RequestMessage, ReplyMessage, Replies, Requests, TidingsOf} from "../contract/messages";
import {Refusal} from "./refusal";

export {Refusal};
/** A newer request of the same kind took this one's place. */
export class Superseded extends Error {}
/** It was wanted no longer. */
export class Cancelled extends Error {}
/** The worker died while it had this request, or was ended because it did not answer. */
export class Crashed extends Error {}

/** A request by its kind. */
export type Job<K extends Kind> = {kind: K} & Requests[K];
export interface Run<K extends Kind> {
  /** Ends it: it leaves the queue at once, and a worker that is still at it after a moment is ended. */
  signal?: AbortSignal;
  /** Hears what the job tells on its way. */
  progress?: (tidings: TidingsOf<K>) => void;
}
interface Asked {
  message: RequestMessage;
  resolve(reply: never): void;
  reject(reason: Error): void;
  progress?(tidings: never): void;
  /** Never superseded; asked once more where a worker died with it. */
  kept: boolean;
  asked: number;
}

/** What the reason of a death is where the worker gave no answer. */
export const no_answer = "no answer";
/** So long a worker may take for one answer; a map of 1000² on a slow telephone takes a tenth of it. */
export const patience_ms = 30_000;
const most_in_a_row = 3,
  most_deaths = 5,
  remembered_ms = 300_000;
const first_delay_ms = 250,
  longest_delay_ms = 4000; // doubled from death to death
const grace_ms = 1000; // a new worker takes longer to load than most jobs to end

/** One engine worker. At most one request is with the worker. Of the waiting ones that `follow` something the last of each
 *  kind wins, and a map waits for all others; those that are `run` are all answered, in turn with the former. A worker that
 *  dies, or says nothing for `patience` ms, is started again, ever later, and what waits goes on; one that dies time after
 *  time is let rest until `restart`. */
export class EngineClient {
  private worker: Worker | null = null;
  private next_id = 1;
  private running: Asked | null = null;
  private readonly waiting = new Map<Kind, Asked>();
  private kept: Asked[] = [];
  private kept_next = true;
  private ready = false;
  private deaths: number[] = []; // when, of late
  private in_a_row = 0; // deaths without an answer between them
  private watch: ReturnType<typeof setTimeout> | undefined;
  private relaunch: ReturnType<typeof setTimeout> | undefined;

  /** `on_crash` hears of every death and whether the worker rests from now on; `on_ready` of every start. */
  constructor(
    private readonly start: () => Worker,
    private readonly on_crash: (reason: string, resting: boolean) => void,
    private readonly on_ready: (version: string) => void,
    private readonly patience = patience_ms,
  ) {
    this.launch();
  }

  /** What follows the task or the pointer: a newer request of the same kind takes its place. */
  follow<K extends Kind>(kind: K, request: Requests[K]): Promise<Replies[K]> {
    return new Promise<Replies[K]>((resolve, reject) => {
      this.cancel(kind); // and the newer request goes to the end of the queue
      this.waiting.set(kind, {...this.asked({kind, ...request}), resolve, reject, kept: false});
      this.pump();
    });
  }
  /** What is wanted whatever else is asked, until `signal` says otherwise: searches, exports, the linkages of pins. */
  run<K extends Kind>(job: Job<K>, {signal, progress}: Run<K> = {}): Promise<Replies[K]> {
    return new Promise<Replies[K]>((resolve, reject) => {
      if (signal?.aborted) return reject(new Cancelled());
      const asked: Asked = {...this.asked(job), resolve, reject, progress, kept: true};
      signal?.addEventListener("abort", () => this.drop(asked), {once: true});
      this.kept.push(asked);
      if (this.resting) this.wake();
      else this.pump();
    });
  }
  private asked<K extends Kind>(job: Job<K>): Pick<Asked, "message" | "asked"> {
    return {message: {id: this.next_id++, ...job} as unknown as RequestMessage, asked: 0};
  }
  private drop(job: Asked): void {
    job.kept = false;
    job.progress = undefined;
    job.reject(new Cancelled());
    this.kept = this.kept.filter((other) => other !== job);
    if (this.running === job) setTimeout(() => this.running === job && this.renew(), grace_ms);
  }

  /** Nothing of this kind is wanted any more. */
  cancel(kind: Kind): void {
    this.waiting.get(kind)?.reject(new Superseded());
    this.waiting.delete(kind);
  }

  get busy(): boolean {
    return this.running !== null;
  }

  get resting(): boolean {
    return this.in_a_row > most_in_a_row || this.deaths.length > most_deaths;
  }

  /** Stops what is running, keeps what is waiting (for the user's Stop). */
  restart(message = "stopped"): void {
    this.deaths = [];
    this.in_a_row = 0;
    this.crashed(message);
  }
  /** Another worker in place of one that is at work in vain. */
  private renew(): void {
    this.end_worker();
    this.running = null;
    this.launch();
  }
  /** Somebody waits for an answer: once more. */
  private wake(): void {
    this.deaths = [];
    this.in_a_row = 0;
    this.launch();
  }
  /** It is not needed any more; what it has under way is not answered. */
  close(): void {
    this.end_worker();
    for (const job of [this.running, ...this.waiting.values(), ...this.kept])
      job?.reject(job.kept ? new Cancelled() : new Superseded());
    this.running = null;
    this.waiting.clear();
    this.kept = [];
  }

  private launch(): void {
    const worker = this.start();
    this.worker = worker;
    worker.onmessage = (event: MessageEvent<ReplyMessage>) => {
      if (this.worker === worker) this.receive(event.data);
    };
    worker.onerror = (event) => {
      event.preventDefault();
      if (this.worker === worker) this.crashed(event.message || "the worker failed");
    };
  }
  private end_worker(): void {
    clearTimeout(this.watch);
    clearTimeout(this.relaunch);
    this.worker?.terminate();
    this.worker = null;
    this.ready = false;
  }

  private pump(): void {
    if (!this.ready || this.running) return;
    const next = this.next();
    if (!next) return;
    this.running = next;
    ++next.asked;
    this.await_word();
    this.worker!.postMessage(next.message);
  }
  private await_word(): void {
    clearTimeout(this.watch);
    this.watch = setTimeout(() => this.crashed(no_answer), this.patience);
  }
  private next(): Asked | undefined {
    const following = [...this.waiting.values()],
      quick = following.find((job) => job.message.kind !== "explore");
    const kept = this.kept.length > 0 && (this.kept_next || !quick);
    this.kept_next = !kept;
    if (kept) return this.kept.shift();
    const next = quick ?? following[0];
    if (next) this.waiting.delete(next.message.kind);
    return next;
  }

  private receive(message: ReplyMessage): void {
    if (message.kind === "ready") {
      this.ready = true;
      this.on_ready(message.version);
    } else if (message.kind === "crashed") {
      this.crashed(message.message);
      return;
    } else if (this.running?.message.id === message.id) {
      const job = this.running;
      if ("tidings" in message) {
        this.await_word();
        job.progress?.(message.tidings as never);
        return;
      }
      this.running = null;
      this.in_a_row = 0;
      clearTimeout(this.watch);
      if ("refused" in message) job.reject(new Refusal(message.refused.mistakes));
      else job.resolve(message.reply as never);
    }
    this.pump();
  }

  private crashed(reason: string): void {
    this.end_worker();
    const lost = this.running,
      now = performance.now();
    this.running = null;
    ++this.in_a_row;
    this.deaths = [...this.deaths.filter((death) => now - death < remembered_ms), now];
    if (lost?.kept && lost.asked < 2 && reason !== no_answer) this.kept.unshift(lost);
    else lost?.reject(new Crashed(reason));
    this.on_crash(reason, this.resting);
    if (this.resting) {
      for (const job of this.kept) job.reject(new Crashed(reason)); // somebody waits for them
      this.kept = [];
      return;
    }
    const before = this.deaths.length - 1;
    if (before === 0) this.launch();
    else
      this.relaunch = setTimeout(() => this.launch(), Math.min(first_delay_ms * 2 ** (before - 1), longest_delay_ms));
  }
}
