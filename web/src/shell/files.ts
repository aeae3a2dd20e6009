// Problem files come in: by the picker, dropped anywhere on the page, or out of a link. The engine reads every one
// before anything on screen changes.
import {Crashed, Refusal, Superseded} from "../engine/client";
import type {Mistake, Notice} from "../contract/messages";
import {save_problem} from "../exports/save";
import {read_problem} from "../state/problem_shape";
import type {Problem} from "../state/problem";
import type {Workbench} from "../state/workbench.svelte";
import {poses_of} from "../state/task";
import {block_of} from "../task_panel/paste";
import {filled_in} from "../task_panel/poses";
import {has_linkages, kind_of, with_poses} from "../kinds/kind_dispatch";
import {mistakes_text} from "../texts/mistakes";
import {notice_text, t} from "../texts/texts.svelte";
import {keep_task} from "./my_tasks";
import {told, without_comments} from "./own_files";
import {other_work, read_before, write_before, type Kept} from "./storage";

const most_bytes = 16 * 1024 * 1024;

function page_mistake(code: string, place: string, message: string): Mistake {
  return {code, place, values: {}, message};
}

/** A file that is the page's own: no linkage is sought in it, and the engine's reader of problems has no use for it. */
function own_problem(text: string): Problem | null {
  try {
    const problem = read_problem(JSON.parse(text));
    return problem && !has_linkages(problem.task) ? problem : null;
  } catch {
    return null;
  }
}
/** What the engine has read, its task in the form in which the file has it where that is kept. */
function as_typed(read: Problem | null, text: string): Problem | null {
  if (!read || !kind_of(read.task).keeps_form) return read;
  try {
    const typed = read_problem(JSON.parse(without_comments(text)));
    return typed && kind_of(typed.task) === kind_of(read.task) ? {...read, task: typed.task} : read;
  } catch {
    return read;
  }
}
/** The problem in a file's text, or the engine's mistakes; nothing when another file came meanwhile. What there is to
 *  know of the file goes to `notices`. */
export async function read_text(
  workbench: Workbench,
  text: string,
  notices: Notice[] = [],
): Promise<Problem | Mistake[] | null> {
  const own = own_problem(text);
  if (own) return own;
  const engine = workbench.driver_client;
  if (!engine) return [page_mistake("no_engine", "", t("state.engine_missing"))];
  try {
    const {problem, notices: of_file} = await engine.follow("read", {text});
    notices.push(...of_file);
    return (
      as_typed(read_problem(JSON.parse(problem)), text) ?? [page_mistake("not_on_page", "task", t("file.not_on_page"))]
    );
  } catch (error) {
    if (error instanceof Refusal) return error.mistakes;
    if (error instanceof Crashed) return [page_mistake("crashed", "", t("file.crashed"))];
    if (error instanceof Superseded) return null;
    throw error;
  }
}

/** Another task takes the place of the one on screen, which can be had back: by undo, and from the menu. */
export function replace_work(workbench: Workbench, problem: Problem, file_name: string | null = null): void {
  void write_before(workbench.slot, workbench.whole_problem);
  void keep_task(workbench);
  workbench.open(problem, file_name);
}
export function can_restore({slot}: Workbench): boolean {
  return read_before(slot) !== null;
}
/** What was here before; what is here now takes its place. */
export function restore_work(workbench: Workbench): void {
  const before = read_before(workbench.slot);
  if (before) replace_work(workbench, before);
}
/** What other tabs have kept, the last first: a few. */
export function work_elsewhere({slot}: Workbench): Kept[] {
  return other_work(slot).slice(0, 5);
}

function newer_version([first]: readonly Mistake[]): string | null {
  return first?.code === "newer_version" ? String(first.values.version) : null;
}
/** Says why a file or link was not opened. */
export function say_refused(workbench: Workbench, mistakes: readonly Mistake[], name: string | null): void {
  const version = newer_version(mistakes);
  if (version !== null) return workbench.say(name === null ? "state.newer_link" : "state.newer_file", {version});
  const why = mistakes_text(mistakes);
  if (name === null) workbench.say("state.bad_link", {why});
  else workbench.say("state.bad_file", {name, why});
}

const looked_at = 4096; // bytes at the start of a file that say what it is

function decoded(bytes: ArrayBuffer): string | null {
  try {
    return new TextDecoder("utf-8", {fatal: true, ignoreBOM: true}).decode(bytes);
  } catch {
    return null;
  }
}
export async function open_file(workbench: Workbench, file: File): Promise<void> {
  const {name} = file;
  if (file.size > most_bytes) return workbench.say("state.huge_file", {name});
  const bytes = await file.arrayBuffer(),
    text = decoded(bytes),
    start = new TextDecoder("latin1").decode(bytes.slice(0, looked_at));
  const found = told(name, start, text),
    notices: Notice[] = [];
  if (!("text" in found)) {
    if (found.kind === "table" && text !== null && take_table(workbench, name, text)) return;
    return workbench.say(`state.is_${found.kind}`, {name});
  }
  const read =
    text === null
      ? [page_mistake("not_utf8", "", t("mistake.not_utf8"))]
      : await read_text(workbench, found.text, notices);
  if (read === null) return;
  if (Array.isArray(read)) return say_refused(workbench, read, name);
  const words = {
    problem: "file.opened",
    result: "file.opened_result",
    linkage: "file.opened_linkage",
    lone_linkage: "file.opened",
  } as const;
  const is_saved_as_it_is = found.kind === "problem" || found.kind === "lone_linkage";
  replace_work(workbench, read, is_saved_as_it_is ? name : null); // saving it must not write over what it came from
  const undo = {key: "edit.undo", run: () => workbench.undo()} as const,
    [notice] = notices;
  if (notice) workbench.say("file.opened_but", {name, what: notice_text(notice)}, undo);
  else workbench.say(words[found.kind], {name}, undo);
}
/** Rows of positions take the place of those of the task in hand. Whether they were such. */
function take_table(workbench: Workbench, name: string, text: string): boolean {
  const block = block_of(text, 0, workbench.unit);
  if (!("rows" in block) || !block.rows.length || block.rows.some(({length}) => length !== 3)) return false;
  const {task} = workbench.problem;
  if (!poses_of(task).length || !kind_of(task).with_poses) return false;
  workbench.edit((problem) => with_poses(problem, filled_in([], 0, 0, block.rows)));
  workbench.say("state.table_taken", {name, n: block.rows.length}, {key: "edit.undo", run: () => workbench.undo()});
  return true;
}
/** Browsers show their file chooser only shortly after a click or a key of the page's own, not after Ctrl-O alone. */
export function pick_file(workbench: Workbench): void {
  if (navigator.userActivation?.isActive === false)
    return workbench.say("file.open_by_click", {}, {key: "file.open", run: () => pick_file(workbench)});
  const input = document.createElement("input");
  input.type = "file";
  input.accept = ".json,application/json";
  input.onchange = () => input.files?.[0] && void open_file(workbench, input.files[0]);
  input.click();
}
export function save_file(workbench: Workbench): void {
  workbench.say("state.exported", {name: save_problem(workbench)});
}

/** A file dropped anywhere is opened, unless the place where it was dropped has another use for it. */
export function accept_drops(workbench: Workbench): () => void {
  const has_file = (event: DragEvent) => event.dataTransfer?.types.includes("Files") ?? false;
  const over = (event: DragEvent) => {
    if (event.defaultPrevented || !has_file(event)) return;
    event.preventDefault();
    event.dataTransfer!.dropEffect = "copy";
  };
  const drop = (event: DragEvent) => {
    if (event.defaultPrevented || !has_file(event)) return;
    event.preventDefault(); // the browser would leave the page for the file
    const file = event.dataTransfer!.files[0];
    if (file) void open_file(workbench, file);
  };
  addEventListener("dragover", over);
  addEventListener("drop", drop);
  return () => {
    removeEventListener("dragover", over);
    removeEventListener("drop", drop);
  };
}
