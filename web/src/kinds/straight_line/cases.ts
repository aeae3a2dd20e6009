// What is given beside the line in each case, and how a new one begins.
import type {Point} from "../../contract/messages";
import {most_of} from "../../state/ends";
import type {TextKey} from "../../texts/texts.svelte";
import type {CaseName, Contact, GivenNumbers, GivenPivots, Line, StraightLineTask} from "./task";

export type NumberName = keyof GivenNumbers;
export interface GivenNumber {
  name: NumberName;
  symbol: string;
  quantity: "length" | "angle";
  /** An empty field, as this. */
  or_null?: TextKey;
  low?: number;
}
/** A way to be given: a case of the file, of which one has two. */
export interface Form {
  id: CaseName | "pole_at_given_pivot";
  case: CaseName;
  pivots: "both" | "input" | null;
  numbers: readonly GivenNumber[];
  contacts?: true;
  /** The line's point is where the coupler's point is, not just any point of the line. */
  at_point: boolean;
  /** Of path and line, at one place; 0: whatever does it. */
  contact: 0 | 4 | 5 | 6;
}

const distance: GivenNumber = {name: "pole_distance", symbol: "c", quantity: "length"},
  ray: GivenNumber = {name: "point_ray_deg", symbol: "ψC", quantity: "angle"},
  arm: GivenNumber = {name: "output_arm", symbol: "rB", quantity: "length"};
const cubic_n: GivenNumber = {
  name: "cubic_n",
  symbol: "N",
  quantity: "length",
  or_null: "straight.infinite",
};
const of_point = {pivots: null, at_point: true} as const;

export const forms: readonly Form[] = [
  {
    id: "search",
    case: "search",
    ...of_point,
    numbers: [
      {name: "stroke", symbol: "S", quantity: "length", low: 0},
      {name: "deviation", symbol: "δ", quantity: "length", low: 0},
    ],
    contact: 0,
  },
  {
    id: "four_point_pivots",
    case: "four_point_pivots",
    pivots: "both",
    numbers: [],
    at_point: false,
    contact: 4,
  },
  {id: "four_point_cubic", case: "four_point_cubic", ...of_point, numbers: [distance, ray, cubic_n], contact: 4},
  {
    id: "ball_point_on_side_link",
    case: "ball_point_on_side_link",
    pivots: "input",
    numbers: [],
    at_point: true,
    contact: 4,
  },
  {
    id: "isosceles_trapezoid",
    case: "isosceles_trapezoid",
    ...of_point,
    numbers: [{name: "half_frame", symbol: "f", quantity: "length", low: 0}],
    contact: 4,
  },
  {
    id: "pole_at_given_pivot",
    case: "pole_at_fixed_pivot",
    pivots: "both",
    numbers: [arm],
    at_point: false,
    contact: 4,
  },
  {id: "pole_at_fixed_pivot", case: "pole_at_fixed_pivot", ...of_point, numbers: [distance, arm], contact: 4},
  {
    id: "pole_at_fixed_pivot_ball_point_on_frame",
    case: "pole_at_fixed_pivot_ball_point_on_frame",
    ...of_point,
    numbers: [distance],
    contact: 4,
  },
  {id: "five_point", case: "five_point", ...of_point, numbers: [distance, ray], contact: 5},
  {
    id: "five_point_inflection_pole",
    case: "five_point_inflection_pole",
    ...of_point,
    numbers: [distance],
    contact: 5,
  },
  {
    id: "five_point_side_link_on_frame",
    case: "five_point_side_link_on_frame",
    ...of_point,
    numbers: [distance],
    contact: 5,
  },
  {id: "six_point", case: "six_point", ...of_point, numbers: [distance], contact: 6},
  {
    id: "parallel_side_links",
    case: "parallel_side_links",
    ...of_point,
    numbers: [
      {name: "input_offset", symbol: "xA", quantity: "length"},
      {name: "output_offset", symbol: "xB", quantity: "length"},
    ],
    contact: 5,
  },
  {
    id: "mixed",
    case: "mixed",
    pivots: "input",
    numbers: [{name: "coupler_angle_deg", symbol: "δ", quantity: "angle"}],
    contacts: true,
    at_point: false,
    contact: 4,
  },
  {
    id: "symmetric_lambda",
    case: "symmetric_lambda",
    ...of_point,
    numbers: [
      {name: "stroke", symbol: "S", quantity: "length", low: 0},
      {name: "crank_range_deg", symbol: "β", quantity: "angle", or_null: "straight.open", low: 0},
    ],
    contact: 4,
  },
];

export function form_of(task: Pick<StraightLineTask, "case" | "ground_pivots">): Form {
  const id = task.case === "pole_at_fixed_pivot" && task.ground_pivots ? "pole_at_given_pivot" : task.case;
  return forms.find((form) => form.id === id) ?? forms[1]!;
}
export function form_name(id: Form["id"]): TextKey {
  return `straight.case.${id}`;
}
/** One sentence: what is given, and what it is good for. */
export function form_about(id: Form["id"]): TextKey {
  return `straight.about.${id}`;
}

/** A point beside the line: so far along its direction, and to its left. */
export function beside({point: [x, y], direction_deg}: Line, along: number, left: number): Point {
  const angle = (direction_deg * Math.PI) / 180,
    [c, s] = [Math.cos(angle), Math.sin(angle)];
  return [x + c * along - s * left, y + s * along + c * left];
}
/** Back: s along the line, e to its left. */
export function along_line({point, direction_deg}: Line, [x, y]: Point): Point {
  const angle = (direction_deg * Math.PI) / 180,
    [c, s] = [Math.cos(angle), Math.sin(angle)],
    [dx, dy] = [x - point[0], y - point[1]];
  return [c * dx + s * dy, c * dy - s * dx];
}
export function distance_of([x0, y0]: Point, [x1, y1]: Point): number {
  return Math.hypot(x1 - x0, y1 - y0);
}

/** What lengths of the task are measured by (engine: size_of). */
export function size_of(task: StraightLineTask): number {
  const {ground_pivots, input_pivot, line, contacts} = task;
  if (form_of(task).pivots === "both" && ground_pivots) return distance_of(ground_pivots.input, ground_pivots.output);
  if (contacts?.length && input_pivot)
    return most_of(contacts.map(({s}) => distance_of(beside(line, s, 0), input_pivot)));
  if (input_pivot) return distance_of(line.point, input_pivot);
  const {half_frame, input_offset, output_offset, stroke, pole_distance} = task;
  if (half_frame !== undefined) return 2 * half_frame;
  if (input_offset !== undefined && output_offset !== undefined) return Math.abs(output_offset - input_offset);
  return Math.abs(stroke ?? pole_distance ?? 1);
}

const even_contacts = (size: number): Contact[] => [
  {s: 0, multiplicity: 1},
  {s: rounded(size / 3), multiplicity: 1},
  {s: rounded((2 * size) / 3), multiplicity: 1},
  {s: size, multiplicity: 1},
];
function rounded(value: number): number {
  return Number(value.toPrecision(4));
}
function rounded_point([x, y]: Point): Point {
  return [rounded(x), rounded(y)];
}
const beginnings: Record<NumberName, (size: number) => number | null> = {
  pole_distance: (size) => size,
  point_ray_deg: () => 60,
  cubic_n: (size) => rounded(1.5 * size), // were it infinite, the fixed pivots would be
  half_frame: (size) => rounded(size / 2),
  output_arm: (size) => rounded(size / 2),
  input_offset: (size) => rounded(-size / 2),
  output_offset: (size) => rounded(size / 2),
  coupler_angle_deg: () => 0,
  stroke: (size) => size,
  deviation: (size) => rounded(size / 2000),
  crank_range_deg: () => null,
};

/** The task with another case: what both have stays, the rest begins in proportion to what there was. */
export function with_form(task: StraightLineTask, form: Form): StraightLineTask {
  const size = rounded(size_of(task)) || 1,
    {line} = task;
  const numbers = Object.fromEntries(
    form.numbers.map(({name}) => [name, task[name] === undefined ? beginnings[name](size) : task[name]]),
  ) as GivenNumbers;
  const input = task.input_pivot ?? task.ground_pivots?.input;
  const pivots: GivenPivots =
    form.pivots === "both"
      ? {
          ground_pivots: task.ground_pivots ?? {
            input: input ?? rounded_point(beside(line, -size / 2, -size)),
            output: rounded_point(beside(line, size / 2, -size)),
          },
        }
      : form.pivots === "input"
        ? {input_pivot: input ?? rounded_point(beside(line, -size / 2, -size))}
        : {};
  return {
    kind: "straight_line",
    mechanism: "four_bar",
    case: form.case,
    line,
    ...pivots,
    ...numbers,
    ...(form.contacts ? {contacts: task.contacts ?? even_contacts(size)} : {}),
  };
}
