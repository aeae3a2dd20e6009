// The workbench of the site: it can be installed, works without its server, and never shows an old page where there is a new one.
import {cpSync, readFileSync, writeFileSync} from "node:fs";
import {execFileSync} from "node:child_process";
import {join} from "node:path";
import type {Page} from "@playwright/test";
import {drag, middle_of, poses_of_page, read_state, until_ready, until_settled} from "../e2e/support";
import {expect, known_visitor, root, Server, site, test} from "./support";

const built = join(root, "build/web");

/** All files are stored, and the page's requests go through the service worker. */
async function until_kept(page: Page): Promise<void> {
  await page.evaluate(() => navigator.serviceWorker.ready);
  await page.waitForFunction(() => navigator.serviceWorker.controller?.state === "activated");
}
/** The site's copy of a workbench that says which one it is. */
function make_version(folder: string, words: string): void {
  cpSync(built, folder, {recursive: true});
  const page = join(folder, "index.html");
  writeFileSync(page, readFileSync(page, "utf8").replace(/content="Every linkage[^"]*"/, `content="${words}"`));
  const script =
    "import sys; from pathlib import Path; sys.path.insert(0, sys.argv[1]); import installable; installable.make_installable(Path(sys.argv[2]), Path(sys.argv[1]))";
  execFileSync("/usr/bin/python3", ["-B", "-c", script, join(root, "site"), folder]);
}
const words_of = (page: Page) => page.locator("meta[name=description]").getAttribute("content");

test("it can be installed", async ({page, site_address}) => {
  await known_visitor(page);
  await page.goto(`${site_address}workbench/index.html`);
  await until_kept(page);
  const session = await page.context().newCDPSession(page);
  const {errors} = await session.send("Page.getAppManifest"),
    {installabilityErrors} = await session.send("Page.getInstallabilityErrors");
  expect(errors).toEqual([]);
  expect(installabilityErrors.filter(({errorId}) => errorId !== "in-incognito")).toEqual([]);
});

test("it works without its server", async ({page, serve}) => {
  await known_visitor(page);
  const server = await serve(Server.folder(site));
  await page.goto(`${server.address}workbench/`);
  await until_kept(page);
  await server.stop();
  await page.reload();
  await until_ready(page);
  await until_settled(page);
  const before = await poses_of_page(page),
    disc = await middle_of(page.getByTestId("drawing.disc_3"));
  await drag(page, disc, {x: disc.x + 15, y: disc.y - 10});
  await until_settled(page);
  expect(await poses_of_page(page)).not.toEqual(before);
  expect(await read_state(page, (workbench) => workbench.census!.types.reduce((sum, n) => sum + n, 0))).toBeGreaterThan(
    0,
  );
});

test("a new version is shown at once, and kept in turn", async ({page, serve, folder}) => {
  await known_visitor(page);
  make_version(folder, "the first");
  const server = await serve(Server.folder(folder));
  await page.goto(server.address);
  await until_kept(page);
  for (const words of ["the second", "the third"]) {
    make_version(folder, words);
    await page.reload();
    expect(await words_of(page)).toBe(words);
    await expect.poll(() => page.evaluate(kept_versions)).toContain(words);
  }
  await expect.poll(async () => (await page.evaluate(kept_versions)).length).toBe(2);
  await server.stop();
  await page.reload();
  await until_ready(page);
  expect(await words_of(page)).toBe("the third");
});
/** Runs in the page: what the stored pages say of themselves. */
async function kept_versions(): Promise<string[]> {
  const found: string[] = [];
  for (const key of await caches.keys()) {
    const page = await (await caches.open(key)).match("index.html");
    found.push(/name="description" content="([^"]*)"/.exec((await page?.text()) ?? "")?.[1] ?? "");
  }
  return found;
}

test("the program shows its own page, even where a site was", async ({page, serve, folder}) => {
  await known_visitor(page);
  make_version(folder, "that of a site");
  const server = await serve(Server.folder(folder));
  await page.goto(server.address);
  await until_kept(page);
  await server.stop();
  await serve(Server.studio(built, server.port));
  await page.goto(server.address);
  await until_ready(page);
  expect(await words_of(page)).toBe("Every linkage that does your task, on one map");
});

test("the program's page keeps nothing", async ({page, serve}) => {
  const studio = await serve(Server.studio(built));
  await page.goto(studio.address);
  await until_ready(page);
  expect(await page.evaluate(async () => (await navigator.serviceWorker.getRegistrations()).length)).toBe(0);
});
