// For tests: states of the page as they can come about, drawn at random.
import fc, {type Arbitrary} from "fast-check";
import {linkage_types, type Property, type Requirements} from "../engine/protocol";
import {box, far_point, found, number, pair, points, positive, record, text} from "./arbitrary_values";
import {from_problem, to_problem, type Document} from "./document";
import {objective_descriptions, property_descriptions} from "../tasks/kinds";
import type {Background, Objective, Options, Pin, Problem, View} from "./problem";
import type {Task} from "./task";

/** Of all kinds. */
const tasks = import.meta.glob<{arbitrary_task: Arbitrary<Task>}>("../tasks/*/arbitrary.ts", {eager: true});
export const task: Arbitrary<Task> = fc.oneof(...Object.values(tasks).map(({arbitrary_task}) => arbitrary_task));

// ---- the rest of a problem ------------------------------------------------------------------------------------------

const limit = (low: number, high: number) => fc.oneof(fc.constant(null), fc.double({min: low, max: high, noNaN: true}));
const requirements = record<Requirements>(
  {},
  {
    types: fc.uniqueArray(fc.constantFrom(...linkage_types)),
    no_defects: fc.boolean(),
    min_transmission_angle_deg: fc.double({min: 0, max: 89, noNaN: true}),
    max_link_ratio: limit(1, 1e6),
    max_length: limit(1e-6, 1e9),
    min_length: limit(0, 1),
    ground_pivots_within: fc.oneof(fc.constant(null), box),
    moving_pivots_within: fc.oneof(fc.constant(null), box),
    respect_direction: fc.boolean(),
    ...({least_sweep: limit(0, 1)} as object), // of a later version
  },
);
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
    pivots: fc.record({
      input_center: far_point,
      input_circle: far_point,
      output_center: far_point,
      output_circle: far_point,
    }),
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
  {opacity: fc.double({min: 0, max: 1, noNaN: true})},
);
const view = record<View>({}, {outline: points(3, 40), background, traced: points(0, 5)});
const problem: Arbitrary<Problem> = record<Problem>(
  {linkwright: fc.constant(1), task},
  {title: text(200), length_unit: text(20), requirements, options, view},
);

export const document: Arbitrary<Document> = fc
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
