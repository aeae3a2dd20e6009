// A point of a four-bar's coupler runs along a line.
import type {Point} from "../../contract/messages";
import {length_levels, type Problem} from "../../state/problem";
import {is_number, is_object, is_pair, present, read_list, type JsonObject} from "../../state/shape";
import {significant} from "../../texts/numbers";
import {t} from "../../texts/texts.svelte";
import type {PropertyDescription, RequirementDescription, TaskKind} from "../kind";
import {planar_objectives, planar_properties, planar_requirements, planar_types} from "../planar";
import {line_making} from "../../analyses/tolerances/making";
import {told_with_point} from "../carried";
import {beside, form_name, form_of, forms, size_of} from "./cases";
import {pattern_of_contacts} from "./contacts";
import {case_names, is_straight_line, type Contact, type GivenNumbers, type Line, type StraightLineTask} from "./task";

const most_contacts = 4;

function read_line(value: unknown): Line | null {
  return is_object(value) && is_pair(value.point) && is_number(value.direction_deg)
    ? {point: value.point, direction_deg: value.direction_deg}
    : null;
}
function read_contact(value: unknown): Contact | null {
  if (!is_object(value) || !is_number(value.s) || !is_number(value.multiplicity)) return null;
  const {s, multiplicity, side} = value;
  return {s, multiplicity, ...(is_number(side) ? {side} : {})};
}
const number_names = [...new Set(forms.flatMap(({numbers}) => numbers.map(({name}) => name)))];

function read(value: JsonObject): StraightLineTask | null {
  const line = read_line(value.line),
    of = case_names.find((name) => name === value.case);
  if (value.kind !== "straight_line" || value.mechanism !== "four_bar" || !line || !of) return null;
  const pivots = value.ground_pivots,
    numbers: GivenNumbers = {};
  for (const name of number_names) {
    const given = value[name];
    if (is_number(given) || (given === null && (name === "cubic_n" || name === "crank_range_deg")))
      Object.assign(numbers, {[name]: given});
  }
  return {
    kind: "straight_line",
    mechanism: "four_bar",
    case: of,
    line,
    ...numbers,
    ...present({
      ground_pivots:
        is_object(pivots) && is_pair(pivots.input) && is_pair(pivots.output)
          ? {input: pivots.input, output: pivots.output}
          : null,
      input_pivot: is_pair(value.input_pivot) ? value.input_pivot : null,
      contacts: read_list(value.contacts, read_contact, most_contacts),
    }),
  };
}

function given_points({ground_pivots, input_pivot}: StraightLineTask): Point[] {
  return [...(ground_pivots ? [ground_pivots.input, ground_pivots.output] : []), ...(input_pivot ? [input_pivot] : [])];
}
/** Multiplicities of the contacts, each as a row of P. */
function pattern(task: StraightLineTask): string {
  const {contacts} = task;
  if (form_of(task).contacts && contacts?.length) return pattern_of_contacts(contacts);
  return "P".repeat(form_of(task).contact) || "–";
}
function moved(task: StraightLineTask, point: (p: Point) => Point): StraightLineTask {
  const {line, ground_pivots, input_pivot} = task,
    at = point(line.point),
    ahead = point(beside(line, 1, 0));
  const turned = (Math.atan2(ahead[1] - at[1], ahead[0] - at[0]) * 180) / Math.PI,
    same = Math.abs(((turned - line.direction_deg + 540) % 360) - 180) < 1e-9;
  return {
    ...task,
    line: {point: at, direction_deg: same ? line.direction_deg : Number(turned.toPrecision(12))},
    ...(ground_pivots ? {ground_pivots: {input: point(ground_pivots.input), output: point(ground_pivots.output)}} : {}),
    ...(input_pivot ? {input_pivot: point(input_pivot)} : {}),
  };
}
function default_max_length({task}: Problem): number {
  return Number((10 * size_of(task as StraightLineTask)).toPrecision(2));
}

const length_property = (
  text: "straight.usable_stroke" | "straight.usable_strip",
): PropertyDescription<StraightLineTask> => ({
  text,
  short: text,
  term: null,
  larger_is_better: true,
  requirement: text === "straight.usable_stroke" ? "min_stroke" : null,
  quantity: "length",
  span: (_, typical) => [0, 2 * typical],
  levels: length_levels,
});
const properties: TaskKind<StraightLineTask>["properties"] = {
  stroke_over_longest: {
    text: "straight.stroke_over_longest",
    short: "straight.short_stroke_over_longest",
    term: null,
    larger_is_better: true,
    requirement: null,
    quantity: "share",
    span: () => [0, 1],
    levels: () => [0.1, 0.2, 0.4, 0.6, 0.8],
  },
  usable_stroke: length_property("straight.usable_stroke"),
  usable_strip: length_property("straight.usable_strip"),
  deviation: {
    text: "straight.deviation",
    short: "straight.deviation",
    term: null,
    larger_is_better: false,
    requirement: "max_deviation",
    quantity: "length",
    span: ({max_deviation}, typical) => [0, max_deviation ? 2 * max_deviation : 1e-3 * typical],
    levels: length_levels,
  },
  min_transmission_angle_deg: planar_properties.min_transmission_angle_deg,
  velocity_nonuniformity: {
    text: "straight.velocity_nonuniformity",
    short: "straight.short_velocity_nonuniformity",
    term: null,
    larger_is_better: false,
    requirement: null,
    quantity: "share",
    span: () => [0, 2],
    levels: () => [0.1, 0.2, 0.5, 1],
  },
  contact_coefficient: {
    text: "straight.contact_coefficient",
    short: "straight.short_contact_coefficient",
    term: null,
    larger_is_better: false,
    requirement: null,
    quantity: "share",
    span: (_, typical) => [0, 1 / Math.max(typical, 1e-9) ** 3],
    levels: () => [],
  },
  link_ratio: planar_properties.link_ratio,
  longest_link: planar_properties.longest_link,
};
const limit = {control: "limit", term: null, quantity: "length", from: 0} as const;
const {types, min_transmission_angle_deg, max_link_ratio, max_length, ground_pivots_within, moving_pivots_within} =
  planar_requirements;
const requirements: Partial<Record<string, RequirementDescription>> = {
  types,
  min_transmission_angle_deg,
  max_link_ratio,
  max_length,
  ground_pivots_within,
  moving_pivots_within,
  min_stroke: {name: "req.min_stroke", short: "req.short.min_stroke", bound: "least", ...limit},
  max_deviation: {name: "req.max_deviation", short: "req.short.max_deviation", bound: "most", ...limit},
};

function new_problem(task: Omit<StraightLineTask, "kind" | "mechanism">): Problem {
  const problem: Problem = {
    linkwright: 1,
    title: "",
    length_unit: "mm",
    task: {kind: "straight_line", mechanism: "four_bar", ...task},
  };
  return {...problem, requirements: {min_transmission_angle_deg: 30, max_length: default_max_length(problem)}};
}

export const straight_line_kind: TaskKind<StraightLineTask> = {
  name: "task.kind_straight_line",
  is: is_straight_line,
  read,
  incompleteness: ({case: of}) =>
    of === "search" ? {state: "to_be_sought", text: "straight.search_wanted", n: 0} : null,
  stops: (task) => (form_of(task).contacts ? (task.contacts?.length ?? 0) : 3),
  pattern,
  is_mixed: () => false,
  anchors(task) {
    const size = size_of(task) / 2;
    return [beside(task.line, -size, 0), beside(task.line, size, 0), ...given_points(task)];
  },
  around(task) {
    const size = size_of(task);
    return [beside(task.line, 0, -size), beside(task.line, 0, size / 2)];
  },
  default_max_length,
  map_of: (task) => `straight_line ${form_of(task).id}`,
  properties,
  types: planar_types,
  requirements,
  objectives: {
    stroke: {name: "req.objective.stroke", measure: "stroke_over_longest"},
    deviation: {name: "req.objective.deviation", measure: "deviation"},
    min_transmission_angle: planar_objectives.min_transmission_angle,
    size: planar_objectives.size,
    velocity_uniformity: {name: "req.objective.velocity_uniformity", measure: "velocity_nonuniformity"},
  },
  analysed: {tolerances: line_making},
  default_objective: "stroke",
  moved,
  table(task, unit) {
    const {line, contacts} = task,
      form = form_of(task),
      number = (value: number | null | undefined) => (value == null ? "∞" : significant(value, 7));
    const pairs: [string, string][] = [
      [t("straight.case"), t(form_name(form.id))],
      [`x ${unit}`.trim(), number(line.point[0])],
      [`y ${unit}`.trim(), number(line.point[1])],
      ["λ °", number(line.direction_deg)],
      ...form.numbers.map(({name, symbol, quantity, or_null}): [string, string] => [
        `${symbol} ${quantity === "angle" ? "°" : unit}`.trim(),
        task[name] === null && or_null ? t(or_null) : number(task[name]),
      ]),
      ...given_points(task).map((point, i): [string, string] => [i === 0 ? "A₀" : "B₀", point.map(number).join(", ")]),
      ...(contacts ?? []).map(({s, multiplicity}, i): [string, string] => [
        `s${i + 1} ${unit}`.trim(),
        `${number(s)} × ${multiplicity}`,
      ]),
    ];
    return {head: pairs.map(([name]) => name), rows: [pairs.map(([, value]) => value)]};
  },
  beginnings: [
    {
      id: "straight_search",
      name: "new.straight_search",
      about: "new.straight_search_about",
      make: () => new_problem({case: "search", line: {point: [0, 0], direction_deg: 0}, stroke: 100, deviation: 0.05}),
    },
    {
      id: "straight_line",
      name: "new.straight_line",
      about: "new.straight_line_about",
      make: () =>
        new_problem({
          case: "four_point_pivots",
          line: {point: [150, 200], direction_deg: 20},
          ground_pivots: {input: [0, 0], output: [300, 0]},
        }),
    },
    {
      id: "straight_line_five",
      name: "new.straight_line_five",
      about: "new.straight_line_five_about",
      make: () =>
        new_problem({
          case: "five_point",
          line: {point: [0, 0], direction_deg: 0},
          pole_distance: 100,
          point_ray_deg: 60,
        }),
    },
  ],
  ...told_with_point(({straight_line: line}) => line ?? null),
  texts: {
    "num.residual": "straight.residual",
    "status.residual": "straight.status_residual",
    "region.driver_axis": "straight.first_axis",
    "region.other_axis": "straight.second_axis",
  },
};
