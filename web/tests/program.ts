// The program, to compare with: what browser tests and component tests ask it.
import {execFileSync} from "node:child_process";
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from "node:fs";
import {tmpdir} from "node:os";
import {dirname, join, resolve} from "node:path";
import {fileURLToPath} from "node:url";

export const root = resolve(dirname(fileURLToPath(import.meta.url)), "../..");
export const program = process.env.LINKWRIGHT_CLI
  ? resolve(root, "web", process.env.LINKWRIGHT_CLI)
  : join(root, "build/release/bin/linkwright");
export const examples = join(root, "examples");
export const bad_problems = join(root, "data/bad_problems");

/** Runs `linkwright`; its standard output. */
export function run(...args: string[]): string {
  return execFileSync(program, args, {
    encoding: "utf8",
    maxBuffer: 1 << 28,
    timeout: 600_000,
    stdio: ["ignore", "pipe", "pipe"],
  });
}
/** Runs it with a file made of `content` as its first argument; its standard output. */
export function run_program(command: string, content: unknown, ...flags: string[]): string {
  const folder = mkdtempSync(join(tmpdir(), "linkwright-"));
  try {
    const file = join(folder, "input.json");
    writeFileSync(file, typeof content === "string" ? content : JSON.stringify(content));
    return run(...command.split(" "), file, ...flags);
  } finally {
    rmSync(folder, {recursive: true});
  }
}
/** The program's result for a problem. */
export function solve(problem: unknown, ...flags: string[]): any {
  return JSON.parse(run_program("solve", problem, "-o", "-", ...flags));
}
/** The program's analysis of a linkage. */
export function analyze(linkage: unknown, ...flags: string[]): any {
  return JSON.parse(run_program("analyze", linkage, "-o", "-", ...flags));
}
/** What `linkwright attitude` says: convert, screw or rates. */
export function attitude_report(of: string, asked: object): any {
  return JSON.parse(run_program(`attitude ${of}`, {linkwright: 1, ...asked}, "-o", "-"));
}
/** A problem of examples/, its comments taken out. */
export function example(name: string): any {
  return JSON.parse(readFileSync(join(examples, `${name}.json`), "utf8").replace(/^\s*\/\/.*$/gm, ""));
}
