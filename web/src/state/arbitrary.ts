// For tests: states of the page as they can come about, drawn at random.
import fc, {type Arbitrary} from "fast-check";
import {linkage_types, type Pivot, type Property, type RequirementKey, type Requirements} from "../contract/messages";
import {box, far_point, found, number, pair, points, positive, record, text} from "./arbitrary_values";
import {from_problem, to_problem, type TaskDocument} from "./document";
import type {RequirementDescription} from "../kinds/kind";
import {objective_descriptions, property_descriptions, requirement_descriptions} from "../kinds/kind_dispatch";
import type {Background, Objective, Options, Pin, Problem, SolidBody, View} from "./problem";
import type {Task} from "./task";

/** Of all kinds: tasks, and what is required by a control of the kind's own. */
interface OfKind {
  arbitrary_task: Arbitrary<Task>;
  arbitrary_requirements?: {[K in RequirementKey]?: Arbitrary<Requirements[K]>};
}
const kinds = Object.values(import.meta.glob<OfKind>("../kinds/*/arbitrary.ts", {eager: true}));
/** Of analyses: their blocks. */
const blocks = Object.assign(
  {},
  ...Object.values(import.meta.glob<{arbitrary_block: object}>("../analyses/*/arbitrary.ts", {eager: true})).map(
    ({arbitrary_block}) => arbitrary_block,
  ),
) as object;
export const task: Arbitrary<Task> = fc.oneof(...kinds.map(({arbitrary_task}) => arbitrary_task));

// ---- the rest of a problem ------------------------------------------------------------------------------------------

const limit = (low: number, high: number) => fc.oneof(fc.constant(null), fc.double({min: low, max: high, noNaN: true}));
function requirement(key: RequirementKey, described: RequirementDescription): Arbitrary<unknown> {
  switch (described.control) {
    case "types":
      return fc.uniqueArray(fc.constantFrom(...linkage_types));
    case "no_defects":
      return fc.boolean();
    case "transmission_angle":
      return fc.double({min: 0, max: 89, noNaN: true});
    case "limit":
      return limit(described.from, described.quantity === "percent" ? 1 : 1e9);
    case "box":
      return fc.oneof(fc.constant(null), box);
    case "own":
      return fc.oneof(fc.constant(null), own_requirements[key] as Arbitrary<unknown>);
  }
}
const own_requirements: OfKind["arbitrary_requirements"] & object = Object.assign(
  {},
  ...kinds.map(({arbitrary_requirements}) => arbitrary_requirements),
);
const requirements = record<Requirements>({}, {
  ...Object.fromEntries(
    (Object.keys(requirement_descriptions) as RequirementKey[]).map((key) => [
      key,
      requirement(key, requirement_descriptions[key]),
    ]),
  ),
  respect_direction: fc.boolean(),
  least_sweep: limit(0, 1), // of a later version
} as object);
const options = record<Options>(
  {},
  {
    region_samples: fc.integer({min: 8, max: 20_000}),
    spacing: fc.constantFrom("coordinate", "arc_length"),
    objective: fc.constantFrom(...(Object.keys(objective_descriptions) as Objective[])),
    best: fc.integer({min: 0, max: 1000}),
    box,
    seed: fc.integer({min: 0, max: 999_999_999}),
    effort: fc.integer({min: 1, max: 10_000_000}),
  },
);
const name = fc.oneof(
  fc.constantFrom("A", "B", "Z12", "lid, 2nd try", "最佳", "<img>"),
  text(12)
    .map((typed) => typed.trim())
    .filter(Boolean),
);
const joints = (names: readonly string[], of: Arbitrary<Pivot | null>): Arbitrary<Pin["pivots"]> =>
  fc.record(Object.fromEntries(names.map((joint) => [joint, of])));
const axes = joints(
  ["input_fixed", "input_moving", "output_fixed", "output_moving"],
  fc.tuple(number(1), number(1), number(1)),
);
const pin = record<Pin>(
  {
    name,
    tau: pair,
    task,
    type: fc.constantFrom(...linkage_types),
    min_transmission_angle_deg: found,
    link_ratio: found,
    longest: found,
    lengths: fc.oneof(
      fc.constant(null),
      fc.record({ground: positive(1e300), input: positive(), coupler: positive(), output: positive()}),
    ),
    pivots: fc.oneof(joints(["input_center", "input_circle", "output_center", "output_circle"], far_point), axes),
  },
  {note: text(200), place: pair, shown: fc.constant(true)},
);
export const pins = fc.uniqueArray(pin, {selector: ({name}) => name, maxLength: 6});
const background = record<Background>(
  {
    image: fc
      .base64String({minLength: 4, maxLength: 400})
      .filter((data) => data.length > 0)
      .map((data) => `data:image/jpeg;base64,${data}`),
    x: number(),
    y: number(),
    width: positive(),
    aspect: positive(1e3),
  },
  {
    opacity: fc.double({min: 0, max: 1, noNaN: true}),
    angle_deg: fc.integer({min: -180, max: 180}),
    hidden: fc.constant(true),
    locked: fc.constant(true),
  },
);
const body: Arbitrary<SolidBody> = fc.oneof(
  fc.record({
    shape: fc.constantFrom("triad" as const, "wing" as const, "dish" as const, "box" as const, "craft" as const),
  }),
  fc.record({shape: fc.constant("own" as const), name: text(50), corners: fc.base64String({maxLength: 200})}),
);
const view = record<View>({}, {outline: points(3, 40), background, body, traced: points(0, 5)});
const problem: Arbitrary<Problem> = record<Problem>(
  {linkwright: fc.constant(1), task},
  {title: text(200), length_unit: text(20), requirements, options, view, ...blocks},
);

export const document: Arbitrary<TaskDocument> = fc
  .record({
    problem,
    picked: fc.oneof(fc.constant(null), fc.record({tau: pair, place: fc.oneof(fc.constant(null), pair)})),
    pins,
    order: fc.oneof(fc.constant(null), fc.integer({min: 0, max: 1000})),
  })
  .map(({problem, ...rest}) => ({...rest, problem: from_problem(problem).problem}));
export const whole_problem: Arbitrary<Problem> = document.map(to_problem);
/** Steps that have parts in common, as edits leave them. */
export const steps = fc.array(document, {minLength: 1, maxLength: 8}).chain((all) =>
  fc.tuple(fc.nat(all.length - 1), fc.array(fc.nat(all.length - 1), {maxLength: 12})).map(([present, more]) => ({
    past: more.map((i) => ({...all[i]!, problem: all[0]!.problem})),
    present: all[present]!,
    future: all.slice(0, present),
  })),
);
export const property = fc.constantFrom("type" as const, ...(Object.keys(property_descriptions) as Property[]));
