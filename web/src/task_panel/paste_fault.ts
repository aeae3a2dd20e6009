import {grouped} from "../texts/numbers";
import {t} from "../texts/texts.svelte";
import {most_pasted_rows, type Block} from "./paste";

/** Why a block was not taken, as a sentence; null where it was. */
export function block_fault(block: Block): string | null {
  if ("fault" in block) return t("task.paste_fault", block.fault);
  return "too_many" in block ? t("task.paste_too_many", {n: grouped(block.too_many), most: most_pasted_rows}) : null;
}
