// What is said of a linkage in one sentence: its defect, or that it has none and whether driving has confirmed that.
import type {Linkage, Replies} from "../contract/messages";
import type {TextKey} from "../texts/texts.svelte";
import {defect_key, has_defect} from "./linkage_words";

export interface Verdict {
  good: boolean;
  text: TextKey;
  /** Driven through the task, with the same result. */
  driven: boolean;
}

/** Nothing of what is no linkage with turning links. A defect stands for itself, whatever driving said. */
export function verdict_of(
  {type, defects}: Pick<Linkage, "type" | "defects">,
  verified: Replies["verify"] | null,
): Verdict | null {
  if (type === "degenerate") return null;
  if (has_defect({defects})) return {good: false, text: defect_key(defects), driven: false};
  if (verified && !verified.verified) return {good: false, text: "num.disputed", driven: false};
  return {good: true, text: "defect.none", driven: verified !== null};
}
