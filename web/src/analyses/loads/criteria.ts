// What linkages can be coloured by, required to be and the best by once it is known what acts on them.
import {most_of} from "../../state/ends";
import {round_step} from "../../state/problem";
import type {ObjectiveDescription, PropertyDescription} from "../../kinds/kind";
import {limits, type Criteria} from "../analysis";
import {is_between_studs, usual_gravity, type Loads} from "./block";

const largest_force = 1e9;

/** About how large the forces are: the weights, with what springs add on the pins. */
export function typical_force({body, extra = [], springs = [], gravity}: Loads): number {
  const acceleration = gravity === null ? 0 : (gravity?.acceleration ?? usual_gravity);
  const weights = [body, ...extra].map((one) => (one && "mass" in one ? one.mass * acceleration : 0)),
    forces = extra.map((one) => ("force" in one ? Math.hypot(one.force[0], one.force[1]) : 0)),
    pushes = springs.map((one) => (one.kind === "gas" ? (one.count ?? 1) * one.F2 : 0));
  const weight = [...weights, ...forces].reduce((sum, force) => sum + force, 0);
  return weight || most_of([0, ...pushes]) || 100;
}
/** Of all springs side by side between two studs. */
function spring_force({springs = []}: Loads): number {
  return springs
    .filter(is_between_studs)
    .reduce((sum, one) => sum + (one.count ?? 1) * (one.kind === "gas" ? one.F2 : one.rate * one.free_length), 0);
}

const even_levels = ([from, to]: readonly [number, number]): number[] => {
  const step = round_step((to - from) / 8),
    first = Math.ceil(from / step);
  return Array.from({length: Math.floor(to / step) - first + 1}, (_, i) => (first + i) * step).filter(
    (level) => level > from && level < to,
  );
};
type Span = (loads: Loads) => [number, number];
const span_of =
  (span: Span): PropertyDescription["span"] =>
  (_, __, {loads = {}}) =>
    span(loads);
const hand_span: Span = (loads) => [0, round_step(1.2 * typical_force(loads))];
/** A negative one: no hand is needed. */
const signed_span: Span = (loads) => {
  const [, to] = hand_span(loads);
  return [-to / 2, to];
};
const hold_span: Span = (loads) => {
  const [, to] = hand_span(loads);
  return [-to, to];
};
const pin_span: Span = (loads) => [0, round_step(3 * (typical_force(loads) + spring_force(loads)))];

type Described = Pick<PropertyDescription, "text" | "short" | "term" | "requirement" | "needs"> & {span: Span};
const force = ({span, ...described}: Described): PropertyDescription => ({
  ...described,
  larger_is_better: false,
  quantity: "force",
  span: span_of(span),
  levels: even_levels,
});

const turn_span = (): [number, number] => [0, 90];
const turned = (
  text: "loads.rises_from" | "loads.closes_from",
  requirement: "max_self_rise_deg" | "min_self_close_deg",
): PropertyDescription => ({
  text,
  short: text,
  term: null,
  requirement,
  needs: "hand",
  larger_is_better: requirement === "min_self_close_deg",
  quantity: "fine_angle",
  in_degrees: true,
  span: turn_span,
  levels: even_levels,
});
const properties: Record<string, PropertyDescription> = {
  hand_force: force({
    text: "loads.hand_force",
    short: "loads.hand_force",
    term: "hand_force",
    requirement: null,
    needs: "hand",
    span: hand_span,
  }),
  max_open_force: force({
    text: "loads.open_force",
    short: "loads.open_short",
    term: "hand_force",
    requirement: "max_open_force",
    needs: "hand",
    span: signed_span,
  }),
  max_close_force: force({
    text: "loads.close_force",
    short: "loads.close_short",
    term: "hand_force",
    requirement: "max_close_force",
    needs: "hand",
    span: signed_span,
  }),
  hold_open: {
    ...force({
      text: "loads.hold_open",
      short: "loads.hold_open",
      term: "hold_open",
      requirement: "min_hold_open",
      needs: "hand",
      span: hold_span,
    }),
    larger_is_better: true,
  },
  max_pin_force: force({
    text: "loads.pin_force",
    short: "loads.pin_short",
    term: null,
    requirement: "max_pin_force",
    needs: "loads",
    span: pin_span,
  }),
  max_torque: {
    ...force({
      text: "loads.torque",
      short: "loads.torque",
      term: null,
      requirement: "max_torque",
      needs: "crank",
      span: hand_span,
    }),
    quantity: "torque",
    span: (_, typical, {loads = {}}) => [0, round_step((typical_force(loads) * typical) / 1000)],
  },
  self_rise_deg: turned("loads.rises_from", "max_self_rise_deg"),
  self_close_deg: turned("loads.closes_from", "min_self_close_deg"),
  best_F1: force({
    text: "loads.best_f1",
    short: "loads.best_f1",
    term: null,
    requirement: "max_best_F1",
    needs: "free",
    span: ({springs = []}) => [
      0,
      round_step(most_of([1, ...springs.map((one) => (one.kind === "gas" ? (one.best_F1?.max_F1 ?? 0) : 0))])),
    ],
  }),
  hand_force_error: force({
    text: "loads.hand_error",
    short: "loads.hand_error",
    term: null,
    requirement: null,
    needs: "hand",
    span: (loads) => [0, round_step(0.05 * typical_force(loads))],
  }),
  cylinder_force: force({
    text: "loads.cylinder_force",
    short: "loads.cylinder_short",
    term: null,
    requirement: "max_cylinder_force",
    needs: "cylinder",
    span: pin_span,
  }),
};

const of_hand = {term: "hand_force", bound: "most", quantity: "force", from: -largest_force, needs: "hand"} as const;
const of_turn = {term: null, quantity: "angle", in_degrees: true, from: 0, needs: "hand"} as const;
const requirements = limits({
  max_open_force: of_hand,
  max_close_force: of_hand,
  min_hold_open: {...of_hand, term: "hold_open", bound: "least"},
  max_pin_force: {term: null, bound: "most", quantity: "force", from: 0, needs: "loads"},
  max_torque: {term: null, bound: "most", quantity: "torque", from: 0, needs: "crank"},
  max_cylinder_force: {term: null, bound: "most", quantity: "force", from: 0, needs: "cylinder"},
  max_self_rise_deg: {...of_turn, bound: "most"},
  min_self_close_deg: {...of_turn, bound: "least"},
  max_best_F1: {term: null, bound: "most", quantity: "force", from: 0, needs: "free"},
});
const objectives: Record<string, ObjectiveDescription> = {
  hand_force: {name: "req.objective.hand_force", measure: "hand_force", needs: "hand"},
  hold_open: {name: "req.objective.hold_open", measure: "hold_open", needs: "hand"},
  pin_force: {name: "req.objective.pin_force", measure: "max_pin_force", needs: "loads"},
  torque: {name: "req.objective.torque", measure: "max_torque", needs: "crank"},
  cylinder_force: {name: "req.objective.cylinder_force", measure: "cylinder_force", needs: "cylinder"},
  self_rise: {name: "req.objective.self_rise", measure: "self_rise_deg", needs: "hand"},
  self_close: {name: "req.objective.self_close", measure: "self_close_deg", needs: "hand"},
  best_F1: {name: "req.objective.best_F1", measure: "best_F1", needs: "free"},
};
export const criteria: Criteria = {properties, requirements, objectives};
/** Of what is read off a linkage, that which a requirement limits. */
export const limited_by = {
  max_open_force: "max_open_force",
  max_close_force: "max_close_force",
  hold_open: "min_hold_open",
  max_pin_force: "max_pin_force",
  max_torque: "max_torque",
  cylinder_force: "max_cylinder_force",
  self_rise: "max_self_rise_deg",
  self_close: "min_self_close_deg",
  best_F1: "max_best_F1",
} as const;
