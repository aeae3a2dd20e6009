import type {Kind, Mistake, RequestMessage, ReplyMessage, Replies, Requests} from "./protocol";

/** The engine refused: the caller's mistakes, each with its place. */
export class Refusal extends Error {
  constructor(readonly mistakes: Mistake[]) {
    super(mistakes.map((m) => (m.place ? `${m.place}: ${m.message}` : m.message)).join("\n"));
  }
}
/** A newer request of the same kind took this one's place. */
export class Superseded extends Error {}
/** The worker died while it had this request. */
export class Crashed extends Error {}

interface Job {
  message: RequestMessage;
  resolve(reply: never): void;
  reject(reason: Error): void;
}

const most_restarts = 3; // in a row, without an answer between them

/** One engine worker. At most one request is with the worker; of the waiting ones the last of each kind wins, and a map
 *  waits for all others. When the worker dies it is started again and the waiting requests go on; one that dies time
 *  after time is let rest until `restart`. */
export class EngineClient {
  private worker: Worker | null = null;
  private next_id = 1;
  private running: Job | null = null;
  private readonly waiting = new Map<Kind, Job>();
  private ready = false;
  private restarts = 0;

  /** `on_crash` hears of every death and whether the worker rests from now on; `on_ready` of every start. */
  constructor(
    private readonly start: () => Worker,
    private readonly on_crash: (message: string, resting: boolean) => void,
    private readonly on_ready: (version: string) => void,
  ) {
    this.launch();
  }

  request<K extends Kind>(kind: K, content: Requests[K]): Promise<Replies[K]> {
    return new Promise<Replies[K]>((resolve, reject) => {
      const message = {id: this.next_id++, kind, ...content} as unknown as RequestMessage;
      this.waiting.get(kind)?.reject(new Superseded());
      this.waiting.delete(kind); // a newer request goes to the end of the queue
      this.waiting.set(kind, {message, resolve: resolve as Job["resolve"], reject});
      this.pump();
    });
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
    return this.restarts > most_restarts;
  }

  /** Stops what is running, keeps what is waiting (for the user's Stop). */
  restart(message = "stopped"): void {
    this.restarts = 0;
    this.crashed(message);
  }
  /** It is not needed any more; what it has under way is not answered. */
  close(): void {
    this.worker?.terminate();
    this.worker = null;
    this.ready = false;
    for (const job of [this.running, ...this.waiting.values()]) job?.reject(new Superseded());
    this.running = null;
    this.waiting.clear();
  }
  /** For tests: the worker dies, and says so as the browser would. */
  kill(): void {
    const worker = this.worker;
    worker?.terminate();
    worker?.dispatchEvent(new ErrorEvent("error", {message: "killed", cancelable: true}));
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

  private pump(): void {
    if (!this.ready || this.running) return;
    const jobs = [...this.waiting.values()];
    const next = jobs.find((job) => job.message.kind !== "explore") ?? jobs[0];
    if (!next) return;
    this.waiting.delete(next.message.kind);
    this.running = next;
    this.worker!.postMessage(next.message);
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
      this.running = null;
      this.restarts = 0;
      if ("refused" in message) job.reject(new Refusal(message.refused.mistakes));
      else job.resolve(message.reply as never);
    }
    this.pump();
  }

  private crashed(reason: string): void {
    this.worker?.terminate();
    this.worker = null;
    this.ready = false;
    const lost = this.running;
    this.running = null;
    ++this.restarts;
    lost?.reject(new Crashed(reason));
    this.on_crash(reason, this.resting);
    if (!this.resting) this.launch();
  }
}
