// What the program answers, to compare the engine of the page with.
import {existsSync, mkdtempSync, readFileSync, writeFileSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {coarse} from "./asked_engine";
import {examples, program, run} from "./program";

if (!existsSync(program)) throw new Error("build/release is built first (script/build)");
export const scratch = mkdtempSync(join(tmpdir(), "linkwright-"));
export const tailgate = readFileSync(join(examples, "tailgate.json"), "utf8");

/** Where an axis is no Burmester curve it is laid out for a map of 400. */
export function samples_of(problem: string): number {
  const {kind, given = {}} = JSON.parse(problem.replace(/^\s*\/\/.*$/gm, "")).task;
  return kind === "function" || "side_lengths" in given || "side_length" in given || "side_angle_deg" in given
    ? 400
    : coarse;
}
/** What the program answers; null where it refuses. */
export function solved(problem: string, samples: number) {
  const file = join(scratch, "problem.json");
  writeFileSync(file, problem);
  try {
    return JSON.parse(run("solve", file, "--region", "--samples", String(samples), "-o", "-"));
  } catch (error) {
    if ((error as {status?: number}).status === 2) return null;
    throw error;
  }
}
