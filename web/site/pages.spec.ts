// The documents: nothing is fetched from elsewhere, all links lead somewhere, and the search finds words of both languages.
import {readFileSync, readdirSync} from "node:fs";
import {dirname, join, normalize} from "node:path";
import type {Page} from "@playwright/test";
import {read_state, until_ready} from "../e2e/support";
import {read_fragment} from "../src/shell/share";
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
  const all = readdirSync(join(root, "include/linkwright"), {recursive: true, encoding: "utf8"});
  const headers = all.filter((name) => name.endsWith(".hpp") && name !== "linkwright.hpp"); // which includes them
  expect(headers.length).toBeGreaterThan(50);
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

interface ProblemFile {
  title: string;
  task: {kind: string; mechanism: string};
}
/** The problems that the links of a page hold, as the workbench itself reads them. */
function linked_problems(page: string): {fragment: string; problem: ProblemFile}[] {
  const links = text_of(page).matchAll(/class="open-in-workbench" href="[^"#]*workbench\/index\.html(#[^"]*)"/g);
  return [...links].map(([, fragment]) => {
    const read = read_fragment(fragment!);
    if (!read || "mistake" in read) throw new Error(`${page}: ${JSON.stringify(read)}`);
    return {fragment: fragment!, problem: JSON.parse(read.text) as ProblemFile};
  });
}

test("every example has a link that holds its problem", () => {
  const examples = pages.filter((name) => name.startsWith("examples/") && !name.endsWith("index.html"));
  expect(examples.length).toBeGreaterThan(30);
  for (const example of examples) {
    const file: unknown = JSON.parse(text_of(example.replace(/html$/, "json")).replace(/^\s*\/\/.*$/gm, ""));
    expect(linked_problems(example).map(({problem}) => problem)).toEqual([file]);
  }
  expect(linked_problems("examples/index.html").length).toBeGreaterThan(30);
});

test("an example of each kind opens in the workbench", async ({page, site_address}) => {
  await known_visitor(page);
  const links = linked_problems("examples/index.html"),
    kinds = new Map(links.map((link) => [`${link.problem.task.kind} ${link.problem.task.mechanism}`, link]));
  expect(kinds.size).toBeGreaterThanOrEqual(6);
  await page.goto(`${site_address}examples/tailgate.html`);
  await page.locator(".open-in-workbench").click();
  await until_ready(page);
  expect(await read_state(page, (workbench) => workbench.problem.title)).toBe("Tailgate hinge");
  for (const {fragment, problem} of kinds.values()) {
    await page.evaluate((link) => (location.hash = link), fragment);
    await page.waitForFunction((title) => globalThis.__linkwright!.workbench.problem.title === title, problem.title);
  }
});

test("a problem that a document shows opens in the workbench", async ({page, site_address}) => {
  await known_visitor(page);
  await page.goto(`${site_address}zh.html`);
  await page.locator(".open-in-workbench[href*='#']").first().click();
  await until_ready(page);
  expect(await read_state(page, (workbench) => workbench.problem.title)).toBe("Tailgate hinge");
});
