import {execFileSync} from "node:child_process";
import {existsSync, readdirSync, readFileSync} from "node:fs";
import {fileURLToPath} from "node:url";
import {afterEach, beforeAll, describe, expect, it} from "vitest";
import {create_linkwright} from "../engine/module";
import type {Mistake} from "../engine/protocol";
import {preferences} from "../state/preferences.svelte";
import {mistake_text, mistakes_text} from "./mistakes";

const root = fileURLToPath(new URL("../../../", import.meta.url));
const folder = `${root}data/bad_problems/`;
const wasm = new URL("../engine/generated/linkwright.wasm", import.meta.url);
const program = `${root}build/release/bin/linkwright`;

let read: (text: string) => Mistake[];
beforeAll(async () => {
  const session = new (await create_linkwright({wasmBinary: readFileSync(wasm)})).Session();
  read = (text) => (session.read(text) ? [] : (JSON.parse(session.mistakes()) as Mistake[]));
});
afterEach(() => void (preferences.language = "en"));

/** Files that are text: others are refused before the engine sees them. */
const files = readdirSync(folder)
  .filter((name) => name !== "expected.json")
  .flatMap((name) => {
    try {
      return [
        {name, text: new TextDecoder("utf-8", {fatal: true, ignoreBOM: true}).decode(readFileSync(folder + name))},
      ];
    } catch {
      return [];
    }
  });

describe("the engine's sentences about files", () => {
  it("are the program's in English", () => {
    expect(existsSync(program), "build/release is built first").toBe(true);
    for (const name of ["missing_angle.json", "trailing_comma.json", "three_poses.json"]) {
      let said = "";
      try {
        execFileSync(program, ["solve", folder + name, "-o", "-"], {encoding: "utf8", stdio: "pipe"});
      } catch (error) {
        said = (error as {stderr: string}).stderr;
      }
      for (const mistake of read(readFileSync(folder + name, "utf8"))) expect(said).toContain(mistake_text(mistake));
    }
  });
  it.each(files)("are Chinese in Chinese: $name", ({text}) => {
    preferences.language = "zh";
    const mistakes = read(text);
    expect(mistakes.length).toBeGreaterThan(0);
    for (const mistake of mistakes) {
      const said = mistake_text(mistake).slice(mistake.place.startsWith("line") ? 0 : mistake.place.length);
      expect(said).toMatch(/\p{Script=Han}/u);
      expect(
        said.replace(
          /"[^"]*"|JSON|UTF|NaN|Infinity|null|true|false|Linkwright|no_defects|poses|(in|out)put_deg|MiB|theta|\b[xyτ]\b|\\[nt]/g,
          "",
        ),
        mistake.message,
      ).not.toMatch(/[a-z]{3}/i);
    }
  });
  it("are counted where there are many", () => {
    const many: Mistake[] = Array.from({length: 7}, (_, i) => ({
      code: "missing_key",
      place: `task.poses[${i}].x`,
      message: "this is missing; add a number",
    }));
    const told = mistakes_text(many);
    expect(told).toContain("task.poses[2].x: this is missing; add a number.");
    expect(told).not.toContain("task.poses[3]");
    expect(told).toMatch(/4 more/);
  });
});
