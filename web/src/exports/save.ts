import {filed} from "../kinds/kind_dispatch";
import type {Workbench} from "../state/workbench.svelte";
import {slug} from "./names";

/** Hands a file to the browser's own way of saving. */
export function save_blob(name: string, blob: Blob): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000); // some browsers begin to read only later
}
export function save_text(name: string, text: string, type: string): void {
  save_blob(name, new Blob([text], {type}));
}

/** The problem file, with what is picked and pinned: what `linkwright solve` reads, of a linkage `linkwright analyze`. */
export function save_problem(workbench: Workbench): string {
  const name = workbench.file_name ?? `${slug(workbench.problem.title ?? "")}.json`;
  save_text(name, `${JSON.stringify(filed(workbench.whole_problem), null, 2)}\n`, "application/json");
  return name;
}
