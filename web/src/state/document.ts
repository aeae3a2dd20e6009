// What undo restores, as a value, and what can be asked of it without the engine.
import {places_of, settled} from "../engine/axis";
import type {Axes, Picked, TauPair} from "../contract/messages";
import {map_of} from "../kinds/kind_dispatch";
import {same_question, with_view, type Pin, type Problem} from "./problem";
import {same_value} from "./task";

/** Immutable. */
export interface TaskDocument {
  problem: Problem; // its view.picked and view.pins are written on saving and sharing; here they live in `picked`, `pins`
  picked: Picked | null;
  pins: readonly Pin[];
  order: number | null; // display order of the map
}

/** The document of a problem file: picked linkage and pins are taken out of its view. */
export function from_problem(problem: Problem): TaskDocument {
  const {picked, pins, order, ...view} = problem.view ?? {};
  return {
    problem: Object.keys(view).length ? {...problem, view} : (({view: _, ...rest}) => rest)(problem),
    picked: picked ? {tau: picked, place: null} : null,
    pins: pins ?? [],
    order: order ?? null,
  };
}
/** The reverse, as it is saved and shared. */
export function to_problem({problem, picked, pins, order}: TaskDocument): Problem {
  const view = {
    ...problem.view,
    ...(pins.length ? {pins} : {}),
    ...(picked ? {picked: picked.tau} : {}),
    ...(order === null ? {} : {order}),
  };
  return Object.keys(view).length ? with_view(problem, view) : problem;
}

/** After a change: what was picked stays in hand where the map stays one of the same things. */
export function with_problem(document: TaskDocument, problem: Problem): TaskDocument {
  const same_map = map_of(document.problem.task) === map_of(problem.task);
  return same_map ? {...document, problem} : {...document, problem, picked: null, order: null};
}

export function same_tau(a: TauPair | null | undefined, b: TauPair | null | undefined): boolean {
  return a === b || (!!a && !!b && a[0] === b[0] && a[1] === b[1]);
}
/** A linkage by the task and its place there. */
export interface LinkageOf {
  problem: Problem;
  tau: TauPair;
}
export function same_linkage(a: LinkageOf, b: LinkageOf): boolean {
  return same_tau(a.tau, b.tau) && same_question(a.problem, b.problem);
}
/** Whether going from one to the other is a step. */
export function differs(a: TaskDocument, b: TaskDocument): boolean {
  return !same_value(a.problem, b.problem) || a.pins !== b.pins || a.picked?.tau.join() !== b.picked?.tau.join();
}

/** On the axes of an answer, the picked linkage keeps its place on the map; what was freshly loaded gets its place from τ.
 *  The same document where that changes nothing. */
export function settled_on(axes: Axes, document: TaskDocument): TaskDocument {
  const {order, blocks} = axes.input;
  if (blocks.length === 0) return document; // nothing to stand on: picked and pins wait for it
  const picked = document.picked && settled(axes, document.picked);
  const pins = document.pins.some((pin) => !pin.place) ? document.pins.map((pin) => marked(axes, pin)) : document.pins;
  const same = picked === document.picked && pins === document.pins && order === document.order;
  return same ? document : {...document, picked, pins, order};
}
function marked(axes: Axes, pin: Pin): Pin {
  return pin.place ? pin : {...pin, place: places_of(axes, pin.tau) ?? undefined};
}
