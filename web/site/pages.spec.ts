// The documents: nothing is fetched from elsewhere, all links lead somewhere, and the search finds words of both languages.
import {readFileSync, readdirSync} from "node:fs";
import {dirname, join, normalize} from "node:path";
import type {Page} from "@playwright/test";
import {read_state, until_ready} from "../e2e/support";
import {expect, known_visitor, root, site, test} from "./support";

const pages = readdirSync(site, {recursive: true, encoding: "utf8"}).filter(
  (name) => name.endsWith(".html") && !name.startsWith("workbench/"),
);
const text_of = (name: string) => readFileSync(join(site, name), "utf8");

/** Addresses that an element of the page names, without those of other sites. */
function addresses(html: string): string[] {
  const found = [...html.matchAll(/<[^>]*?\s(?:href|src)="([^"]*)"/g)].map((match) => match[1]!.replace(/&amp;/g, "&"));
  return found.filter((address) => !/^(?:[a-z]+:|#)/.test(address));
}
const ids = (name: string) => new Set([...text_of(name).matchAll(/\sid="([^"]+)"/g)].map((match) => match[1]));

test("every link of every page leads somewhere", () => {
  const dead: string[] = [],
    known = new Map<string, Set<string | undefined>>(),
    files = new Set(readdirSync(site, {recursive: true, encoding: "utf8"}));
  for (const page of pages)
    for (const address of addresses(text_of(page))) {
      const [path, part] = address.split("#") as [string, string?],
        file = normalize(join(dirname(page), decodeURIComponent(path))).replace(/^\.$|\/$/, "");
      const target =
        path === "" ? page : files.has(file) && !/\.\w+$/.test(file) ? join(file, "index.html") : file || "index.html";
      if (!files.has(target)) dead.push(`${page}: ${address}`);
      else if (part && target.endsWith(".html") && !target.startsWith("workbench/")) {
        if (!known.has(target)) known.set(target, ids(target));
        if (!known.get(target)!.has(decodeURIComponent(part))) dead.push(`${page}: ${address}`);
      }
    }
  expect(dead).toEqual([]);
});

test("every page has a policy that lets nothing in from elsewhere", () => {
  for (const page of pages)
    expect(text_of(page), page).toContain(`Content-Security-Policy" content="default-src 'none';`);
  const workbench = text_of("workbench/index.html");
  expect(workbench).toContain(`Content-Security-Policy" content="default-src &#39;self&#39;;`);
});

test("every public header has its section", () => {
  const headers = readdirSync(join(root, "include/linkwright"), {recursive: true, encoding: "utf8"}).filter((name) =>
    name.endsWith(".hpp"),
  );
  expect(headers.length).toBeGreaterThan(200);
  for (const header of headers) {
    const [folder, name] = header.split("/") as [string, string];
    expect(ids(`cpp/${folder}.html`).has(name.replace(".", "-")), header).toBe(true);
  }
});

test("pages of all parts are shown whole, from this machine alone", async ({page, site_address}) => {
  const parts = ["index.html", "zh.html", "theory/planar.html", "glossary.html", "formats/problem.html", "python.html"];
  for (const part of [...parts, "cpp/planar.html", "examples/tailgate.html", "tutorials/tailgate.html"]) {
    await page.goto(site_address + part);
    await expect(page.locator("h1")).toBeVisible();
    const broken = await page.evaluate(() =>
      [...document.images].filter((image) => image.complete && image.naturalWidth === 0).map((image) => image.src),
    );
    expect(broken).toEqual([]);
  }
});

/** Types as people do: the search listens to keys. */
async function search(page: Page, words: string): Promise<void> {
  const field = page.locator(".md-search__input");
  await field.fill(words);
  await field.press("End");
}
test("the search finds words of both languages", async ({page, site_address}) => {
  await page.goto(`${site_address}theory/planar.html`);
  for (const [words, place] of [
    ["transmission angle", "formats/result.html"],
    ["tolerances", "cpp/robust.html"],
    ["连杆", "glossary.html"],
    ["传动角", "glossary.html"],
    ["球面四杆机构", "glossary.html"],
    ["解域", "zh.html"],
  ] as const) {
    await search(page, words);
    await expect(page.locator(`.md-search-result__link[href*="${place}"]`).first(), words).toBeAttached();
    await expect(page.locator(".md-search-result__list")).toContainText(words, {ignoreCase: true});
  }
  await search(page, "没有这个词");
  await expect(page.locator(".md-search-result__link")).toHaveCount(0);
});

test("every example opens in the workbench", async ({page, site_address}) => {
  test.slow();
  await known_visitor(page);
  const examples = pages.filter((name) => name.startsWith("examples/") && !name.endsWith("index.html"));
  expect(examples.length).toBeGreaterThan(30);
  await page.goto(`${site_address}${examples[0]}`);
  await page.locator(".open-in-workbench").click();
  await until_ready(page);
  for (const example of examples) {
    const [, fragment] = /class="open-in-workbench" href="[^"#]*(#[^"]*)"/.exec(text_of(example))!;
    await page.evaluate((link) => (location.hash = link), fragment!);
    const file = JSON.parse(text_of(example.replace(/html$/, "json")).replace(/^\s*\/\/.*$/gm, "")) as {title: string};
    await page.waitForFunction((title) => globalThis.__linkwright!.workbench.problem.title === title, file.title);
  }
});

test("a problem that a document shows opens in the workbench", async ({page, site_address}) => {
  await known_visitor(page);
  await page.goto(`${site_address}zh.html`);
  await page.locator(".open-in-workbench").first().click();
  await until_ready(page);
  expect(await read_state(page, (workbench) => workbench.problem.title)).toBe("Tailgate hinge");
});
