// What the tests of the site share: a static server that knows nothing of us, and a page that must not ask elsewhere.
import {test as base, expect, type Page} from "@playwright/test";
import {type ChildProcess, spawn} from "node:child_process";
import {mkdtempSync, mkdirSync, rmSync, symlinkSync} from "node:fs";
import {createServer} from "node:net";
import {tmpdir} from "node:os";
import {dirname, join, resolve} from "node:path";
import {fileURLToPath} from "node:url";

export const root = resolve(dirname(fileURLToPath(import.meta.url)), "../..");
export const site = join(root, "build/site");
export const program = resolve(root, "web", process.env.LINKWRIGHT_CLI ?? "../build/release/bin/linkwright");

function free_port(): Promise<number> {
  return new Promise((done) => {
    const probe = createServer().listen(0, "127.0.0.1", () => {
      const {port} = probe.address() as {port: number};
      probe.close(() => done(port));
    });
  });
}
async function answers(address: string): Promise<boolean> {
  return fetch(address).then(
    () => true,
    () => false,
  );
}

/** A server process, and the address of what it serves. */
export class Server {
  private constructor(
    readonly port: number,
    private readonly process: ChildProcess,
  ) {}

  static async start(command: (port: number) => string[], wanted?: number): Promise<Server> {
    const port = wanted ?? (await free_port()),
      [name, ...words] = command(port);
    const server = new Server(port, spawn(name!, words, {stdio: "ignore"}));
    await expect.poll(() => answers(server.address)).toBe(true);
    return server;
  }
  /** Python's: no headers of ours, no compression. */
  static folder(folder: string, port?: number): Promise<Server> {
    return Server.start(
      (free) => [
        ...["/usr/bin/python3", "-m", "http.server", String(free)],
        ...["--bind", "127.0.0.1", "--directory", folder],
      ],
      port,
    );
  }
  static studio(folder: string, port?: number): Promise<Server> {
    return Server.start((free) => [program, "studio", "--port", String(free), "--folder", folder], port);
  }
  get address(): string {
    return `http://127.0.0.1:${this.port}/`;
  }
  async stop(): Promise<void> {
    if (this.process.exitCode !== null || this.process.signalCode !== null) return;
    const ended = new Promise((done) => this.process.once("exit", done));
    this.process.kill("SIGTERM");
    await ended;
  }
}

interface Fixtures {
  /** Starts servers that end with the test. */
  serve: (start: Promise<Server>) => Promise<Server>;
  /** A folder that ends with the test. */
  folder: string;
  /** What pages complained of, and addresses they asked for that are not on this machine. */
  complaints: string[];
}
export const test = base.extend<Fixtures, {site_address: string}>({
  site_address: [
    async ({browser: _}, use) => {
      const above = mkdtempSync(join(tmpdir(), "linkwright-site-"));
      mkdirSync(join(above, "some"));
      symlinkSync(site, join(above, "some/place"));
      const server = await Server.folder(above);
      await use(`${server.address}some/place/`);
      await server.stop();
      rmSync(above, {recursive: true});
    },
    {scope: "worker"},
  ],
  serve: async ({browser: _}, use) => {
    const started: Server[] = [];
    await use(async (start) => {
      const server = await start;
      started.push(server);
      return server;
    });
    await Promise.all(started.map((server) => server.stop()));
  },
  folder: async ({browser: _}, use) => {
    const folder = mkdtempSync(join(tmpdir(), "linkwright-page-"));
    await use(folder);
    rmSync(folder, {recursive: true});
  },
  complaints: [
    async ({page}, use) => {
      const complaints: string[] = [];
      page.on("request", (request) => {
        const {hostname, protocol} = new URL(request.url());
        if (/^https?:$/.test(protocol) && hostname !== "127.0.0.1") complaints.push(`asks ${request.url()}`);
      });
      page.on("console", (message) => {
        if (/^(error|warning)$/.test(message.type()) && !/WebGL|GPU stall/.test(message.text()))
          complaints.push(`${page.url()}: ${message.text()}`);
      });
      page.on("pageerror", (error) => complaints.push(`${page.url()}: ${error.message}`));
      await use(complaints);
      expect(complaints, "complaints of the pages").toEqual([]);
    },
    {auto: true},
  ],
});
export {expect};

/** The workbench from now on knows its visitor: no tour, English. */
export async function known_visitor(page: Page): Promise<void> {
  await page.addInitScript(() =>
    localStorage.setItem("linkwright.preferences", JSON.stringify({language: "en", toured: true})),
  );
}
