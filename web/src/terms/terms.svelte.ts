// What a word of the trade means: one sentence and a small picture, shown beside the word that is pointed at, focused or
// touched. One is open at a time.
import type {Attachment} from "svelte/attachments";
import type {Linkage, LinkageType} from "../contract/messages";
import {term_of_kind} from "../kinds/kind_dispatch";
import type {TermName} from "./pictures";

export interface Explained {
  name: TermName;
  /** What a press on it does, where it does something. */
  hint: string | null;
  at: DOMRect;
}
const wait_ms = 350; // of the pointer, so that nothing flickers on the way past

class Terms {
  open = $state.raw<Explained | null>(null);
  private owner: Element | null = null;
  private waiting: ReturnType<typeof setTimeout> | undefined;

  show(owner: Element, name: TermName, hint: string | null = null): void {
    clearTimeout(this.waiting);
    this.owner = owner;
    this.open = {name, hint, at: owner.getBoundingClientRect()};
  }
  show_soon(owner: Element, name: TermName, hint: string | null): void {
    clearTimeout(this.waiting);
    this.waiting = setTimeout(() => owner.isConnected && this.show(owner, name, hint), wait_ms);
  }
  /** Unless another word is explained by now. */
  hide(owner: Element): void {
    clearTimeout(this.waiting);
    if (this.owner === owner) this.close();
  }
  /** What scrolls away with a word closes it; a list that scrolls elsewhere does not. */
  scrolled(what: EventTarget | null): void {
    if (this.owner && what instanceof Node && what.contains(this.owner)) this.owner = this.open = null;
  }
  close(): void {
    clearTimeout(this.waiting);
    this.owner = this.open = null;
  }
}
export const terms = new Terms();

export function term_of_type(type: LinkageType): TermName {
  return type === "degenerate" ? "slider" : type;
}
/** Of a longer linkage than a four-bar, its make-up. */
export function term_of_linkage(linkage: Pick<Linkage, "type">): TermName {
  return term_of_kind(linkage) ?? term_of_type(linkage.type);
}
/** The worst defect, as it is told. */
export function term_of_defects({order, branch, circuit}: Linkage["defects"]): TermName {
  return circuit ? "circuit_defect" : branch ? "branch_defect" : order ? "order_defect" : "no_defects";
}
export const tip_id = "term_tip";

type Explaining = Attachment<HTMLElement | SVGElement>;
const without_hint: {[name in TermName]?: Explaining} = {};

/** Explains a word on a thing that has another use already: a button, a cell. Words alone take a Term. */
export function explains(name: TermName | null, hint?: () => string): Explaining | null {
  if (!name) return null;
  if (hint) return explaining(name, hint);
  // The same one for the same word: another one is attached anew whenever what it was chosen by is another.
  return (without_hint[name] ??= explaining(name, () => null));
}
function explaining(name: TermName, hint: () => string | null): Explaining {
  return (element) => {
    const events = new AbortController(),
      {signal} = events;
    element.addEventListener(
      "pointerenter",
      (event) => {
        if ((event as PointerEvent).pointerType === "mouse") terms.show_soon(element, name, hint());
      },
      {signal},
    );
    element.addEventListener("pointerleave", () => terms.hide(element), {signal});
    element.addEventListener("pointerdown", () => terms.hide(element), {signal});
    element.addEventListener(
      "focus",
      () => {
        if (element.matches(":focus-visible")) terms.show(element, name, hint());
      },
      {signal},
    );
    element.addEventListener("blur", () => terms.hide(element), {signal});
    return () => {
      events.abort();
      terms.hide(element);
    };
  };
}
