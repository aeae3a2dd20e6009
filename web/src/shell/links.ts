// Links to a task: made and copied, and opened from the page's own address.
import {copy_text} from "../numbers/clipboard";
import type {Workbench} from "../state/workbench.svelte";
import {grouped} from "../texts/numbers";
import {t} from "../texts/texts.svelte";
import {read_text, replace_work, save_file, say_refused} from "./files";
import {is_local, link_of, read_fragment, type LinkMistake} from "./share";

/** Copies the link, or leaves it in the address to be copied from there. */
export async function copy_link(workbench: Workbench): Promise<void> {
  const link = link_of(workbench.whole_problem, location.href);
  if (!link) return workbench.say("state.link_too_long", {}, {key: "file.save", run: () => save_file(workbench)});
  const values = {n: grouped(link.length), host: location.host || location.protocol};
  const picture = workbench.problem.view?.background != null,
    copied = await copy_text(link);
  if (!copied) history.replaceState(null, "", link);
  if (is_local(location))
    return workbench.say(copied ? "state.local_link_copied" : "state.local_link", values, {
      key: "file.save",
      run: () => save_file(workbench),
    });
  if (!copied) return workbench.say("state.link_in_address");
  workbench.say(picture ? "state.link_copied_no_picture" : "state.link_copied", values);
}

function link_refused(workbench: Workbench, mistake: LinkMistake): void {
  if (mistake === "too_long") return workbench.say("state.huge_link");
  if (mistake === "newer") return workbench.say("state.newer_link", {version: "2"});
  workbench.say("state.bad_link", {why: t(mistake === "damaged" ? "share.damaged" : "share.too_large")});
}
/** The fragment is taken out of the address once it is read: from then on the work is kept as any other. */
function taken_fragment(): string {
  const {hash} = location;
  if (hash.length > 1) history.replaceState(null, "", location.pathname + location.search);
  return hash;
}
/** Opens the link in the page's address, if there is one. */
export async function open_link(workbench: Workbench): Promise<boolean> {
  const page_length = location.href.length - location.hash.length;
  const link = read_fragment(taken_fragment(), page_length);
  if (!link) return false;
  if ("mistake" in link) {
    link_refused(workbench, link.mistake);
    return false;
  }
  const read = await read_text(workbench, link.text);
  if (read === null) return false;
  if (Array.isArray(read)) {
    say_refused(workbench, read, null);
    return false;
  }
  replace_work(workbench, read);
  return true;
}
