// Who may import whom: no circles, and the frame knows no kind of task but by the registry.
import {readdirSync, readFileSync} from "node:fs";
import {dirname, join} from "node:path/posix";
import {describe, expect, it} from "vitest";

const root = new URL(".", import.meta.url).pathname;
const files = readdirSync(root, {recursive: true, encoding: "utf8"})
  .filter((file) => /\.(ts|svelte)$/.test(file) && !/\.test\.ts$|\.d\.ts$|^engine\/generated\//.test(file))
  .sort();
const texts = new Map(files.map((file) => [file, readFileSync(join(root, file), "utf8")]));

/** What a file imports, types too; what it loads later by `import()` is no import. */
function imports_of(file: string): string[] {
  const named = texts.get(file)!.matchAll(/^\s*(?:import|export)\s(?:[^"';]*?\sfrom\s)?"(\.[^"]+)"/gm);
  return [...named].flatMap(([, path]) => {
    const to = join(dirname(file), path!);
    return [to, `${to}.ts`].filter((name) => texts.has(name));
  });
}
const imports = new Map(files.map((file) => [file, imports_of(file)]));

/** Each a list of files that import each other in a ring (Tarjan, Depth-first search and linear graph algorithms, 1972). */
function circles(): string[][] {
  const index = new Map<string, number>(),
    low = new Map<string, number>(),
    stack: string[] = [],
    found: string[][] = [];
  const visit = (file: string): number => {
    index.set(file, index.size);
    low.set(file, index.get(file)!);
    stack.push(file);
    for (const to of imports.get(file)!) {
      const reached = index.has(to) ? (stack.includes(to) ? index.get(to)! : Infinity) : visit(to);
      low.set(file, Math.min(low.get(file)!, reached));
    }
    if (low.get(file) === index.get(file)) {
      const circle = stack.splice(stack.indexOf(file));
      if (circle.length > 1) found.push(circle.sort());
    }
    return low.get(file)!;
  };
  for (const file of files) if (!index.has(file)) visit(file);
  return found;
}

describe("imports", () => {
  it("are found", () => {
    expect(imports.get("main.ts")).toEqual([
      "shell/work_store_opening.ts",
      "App.svelte",
      "shell/kept_view.svelte.ts",
      "shell/start.ts",
      "state/context.ts",
      "kinds/view_dispatch.ts",
      "texts/texts.svelte.ts",
    ]);
    expect([...imports.values()].flat().length).toBeGreaterThan(1000);
  });
  it("make no circles", () => expect(circles()).toEqual([]));
});

describe("the frame and the kinds", () => {
  const analyses = readdirSync(join(root, "analyses"), {withFileTypes: true})
    .filter((entry) => entry.isDirectory())
    .map(({name}) => name);
  const folders = analyses.map((name) => `analyses/${name}/`);
  const others = files.filter((file) => !folders.some((folder) => file.startsWith(folder)));

  it("have analyses to know nothing of", () => expect(analyses).toEqual(["loads", "tolerances"]));
  it.each(others)("reach none from %s but through the registry, or to say what is made", (file) => {
    const reached = imports.get(file)!.filter((to) => folders.some((folder) => to.startsWith(folder)));
    const allowed =
      file === "analyses/registry.ts" ? /\/index\.ts$/ : /^kinds\/.*\/kind\.ts$/.test(file) ? /\/making\.ts$/ : /^$/;
    expect(reached.filter((to) => !allowed.test(to))).toEqual([]);
  });
});

describe("requests", () => {
  // What the user does once, and is told how it ended.
  const once = ["drawing/outline_file.ts", "exports/take_away.ts", "shell/files.ts"];
  const asking = files.filter((file) => /(\b|_)(engine|client)!?\s*\??\.(run|follow)\(/.test(texts.get(file)!));

  it("are found", () => expect(asking.length).toBeGreaterThan(12));
  it.each(asking.filter((file) => !once.includes(file)))("are made by questions in %s", (file) => {
    const knows = imports.get(file)!.some((to) => to.startsWith("questions/") || to === "state/answers.svelte.ts");
    expect(knows || /\bmachines\.ask\(/.test(texts.get(file)!)).toBe(true);
  });
  it.each(asking)("lose no error in %s", (file) =>
    expect(texts.get(file)).not.toMatch(/\.catch\(\(\) => (null|undefined|\{\}|\[\])/),
  );
});

describe("the frame", () => {
  const kinds = readdirSync(join(root, "kinds"), {withFileTypes: true})
    .filter((entry) => entry.isDirectory())
    .map(({name}) => name);
  // What the engine says of all of them: in its own words, and as the page still takes it.
  const contract = ["contract/problem.ts", "contract/result.ts", "contract/replies.ts", "engine/adapter.ts"];
  const frame = files.filter(
    (file) => !kinds.some((kind) => file.startsWith(`kinds/${kind}/`)) && !contract.includes(file),
  );

  const is_drawn = ["path"]; // what SVG calls its curves, too

  it("has kinds of tasks to know nothing of", () =>
    expect(kinds).toEqual([
      "attitude",
      "function",
      "given_linkage",
      "motion",
      "path",
      "six_bar",
      "spherical",
      "spherical_function",
      "straight_line",
    ]));
  it.each(frame)("names none in %s", (file) => {
    const named = texts
      .get(file)!
      .split("\n")
      .filter((line) => {
        const code = line.replace(/\/\/.*|^\s*(\*|\/\*\*).*/, "");
        return kinds.some((kind) => {
          const word = is_drawn.includes(kind) ? "" : `["'\`]${kind}["'\`.]|\\.${kind}\\b|`;
          return new RegExp(`${word}kinds/${kind}/|\\b${kind}_(kind|view)\\b`).test(code);
        });
      });
    expect(file === "kinds/registry.ts" ? [] : named).toEqual([]);
  });
  it.each(frame)("reaches none from %s but through the registry", (file) => {
    const reached = imports.get(file)!.filter((to) => kinds.some((kind) => to.startsWith(`kinds/${kind}/`)));
    expect(reached).toEqual(file === "kinds/registry.ts" ? kinds.map((kind) => `kinds/${kind}/index.ts`) : []);
  });
});
