// The document with the steps of undo about it, as text to be kept between visits. What steps have in common, a picture or
// the pins, is written once.
import {from_problem, to_problem, type TaskDocument} from "./document";
import type {Problem} from "./problem";
import {read_problem} from "./problem_shape";
import {is_object, is_pair} from "./shape";

export interface Steps {
  past: readonly TaskDocument[];
  present: TaskDocument;
  future: readonly TaskDocument[];
}
export const most_steps = 500; // that are kept, before and after the present

/** Of the parts of a document: they are immutable, and each is asked for with every step that has it. */
const texts = new WeakMap<object, string>();
function text_of(part: unknown): string {
  if (typeof part !== "object" || part === null) return JSON.stringify(part);
  const known = texts.get(part) ?? JSON.stringify(part);
  texts.set(part, known);
  return known;
}
function members_text(object: object): string {
  return `{${Object.entries(object)
    .flatMap(([key, part]) => (part === undefined ? [] : [`${JSON.stringify(key)}:${text_of(part)}`]))
    .join(",")}}`;
}
class Parts {
  readonly list: string[] = [];
  private readonly index = new Map<string, number>();

  of(part: unknown): number {
    const text = text_of(part),
      known = this.index.get(text);
    if (known !== undefined) return known;
    this.index.set(text, this.list.length);
    return this.list.push(text) - 1;
  }
  /** Where its members stand. */
  members(object: object): Record<string, number> {
    return Object.fromEntries(
      Object.entries(object).flatMap(([key, part]) => (part === undefined ? [] : [[key, this.of(part)]])),
    );
  }
}
interface Packed {
  problem: Record<string, number>;
  view: Record<string, number>;
  pins: number[];
  place: unknown;
}
function packed(document: TaskDocument, parts: Parts): Packed {
  const {view = {}, ...problem} = to_problem(document),
    {pins = [], ...rest} = view;
  return {
    problem: parts.members(problem),
    view: parts.members(rest),
    pins: pins.map((pin) => parts.of(pin)),
    place: document.picked?.place ?? null,
  };
}
function unpacked(value: unknown, parts: readonly unknown[]): TaskDocument | null {
  if (!is_object(value)) return null;
  const members = (of: unknown) =>
    Object.fromEntries(Object.entries(is_object(of) ? of : {}).map(([key, at]) => [key, parts[at as number]]));
  const pins = Array.isArray(value.pins) ? value.pins.map((at: number) => parts[at]) : [];
  return read_document(
    {...members(value.problem), view: {...members(value.view), ...(pins.length ? {pins} : {})}},
    value.place,
  );
}
/** As the page has it: the place of what is picked is no part of a problem file. */
function read_document(problem: unknown, place: unknown): TaskDocument | null {
  const read = read_problem(problem),
    document = read && from_problem(read);
  return document?.picked && is_pair(place) ? {...document, picked: {...document.picked, place}} : document;
}

/** `problem` first, as it always was, so that an older page finds it. */
export function steps_text({past, present, future}: Steps, at: number, most = most_steps): string {
  const parts = new Parts(),
    pack = (document: TaskDocument) => packed(document, parts);
  const before = past.slice(Math.max(past.length - most, 0)).map(pack),
    after = future.slice(Math.max(future.length - most, 0)).map(pack);
  const rest = JSON.stringify({version: 1, at, place: present.picked?.place ?? null, past: before, future: after});
  return `${rest.slice(0, -1)},"problem":${members_text(to_problem(present))},"parts":[${parts.list.join(",")}]}`;
}
/** Each step for itself: what is damaged is left out, and nothing is left where the present is. */
export function read_steps(text: string | null): (Steps & {at: number}) | null {
  const value = parsed(text);
  if (!is_object(value) || value.version !== 1) return null;
  const present = read_document(value.problem, value.place),
    parts = Array.isArray(value.parts) ? value.parts : [];
  if (!present) return null;
  const list = (steps: unknown) =>
    (Array.isArray(steps) ? steps : []).map((step) => unpacked(step, parts)).filter((step) => step !== null);
  return {past: list(value.past), present, future: list(value.future), at: typeof value.at === "number" ? value.at : 0};
}
function parsed(text: string | null): unknown {
  try {
    return JSON.parse(text ?? "null");
  } catch {
    return null;
  }
}
/** The steps with every problem changed. */
export function mapped({past, present, future}: Steps, change: (problem: Problem) => Problem): Steps {
  const one = (document: TaskDocument): TaskDocument => ({...document, problem: change(document.problem)});
  return {past: past.map(one), present: one(present), future: future.map(one)};
}
