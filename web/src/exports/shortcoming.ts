// What whoever takes a linkage away has to know before it is built.
import type {Linkage, Replies} from "../contract/messages";
import {verdict_of} from "../numbers/verdict";
import {unmet_text} from "../requirements/requirements";
import type {Workbench} from "../state/workbench.svelte";
import type {Task} from "../state/task";
import {told} from "../kinds/kind_dispatch";
import {t} from "../texts/texts.svelte";

/** Its defect and the requirements that it misses, in one sentence; nothing of a linkage that does what was asked. */
export function shortcoming(
  linkage: Linkage,
  task: Task,
  verified: Replies["verify"] | null,
  workbench: Pick<Workbench, "problem" | "task" | "unit">,
): string | null {
  const disputed = verdict_of(linkage, verified)?.text === "num.disputed" ? t("num.not_verified") : null;
  const parts = [linkage.reason && told(task, linkage.reason), disputed, unmet_text(linkage, workbench)].filter(
    (part) => part !== null,
  );
  return parts.length ? t("export.mind", {why: parts.join(" ")}) : null;
}
