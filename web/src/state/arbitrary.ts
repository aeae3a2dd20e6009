// For tests: states of the page as they can come about, drawn at random.
import fc, {type Arbitrary} from "fast-check";
import {linkage_types, properties, type Box, type Point, type Requirements, type TauPair} from "../engine/protocol";
import {from_problem, to_problem, type Document} from "./document";
import {objectives, type Background, type Options, type Pin, type Problem, type View} from "./problem";
import type {
  AnglePair,
  FreeNumber,
  FunctionTask,
  Given,
  MotionTask,
  NamedFunction,
  Pose,
  SixBarTask,
  Task,
} from "./task";

// Numbers as they are typed, computed or dragged; −0 is written as 0.
const number = (most = 1e9): Arbitrary<number> =>
  fc
    .oneof(
      fc.integer({min: -1000, max: 1000}),
      fc.double({min: -most, max: most, noNaN: true}),
      fc.constantFrom(most, -most, 1e-9, 0.1),
    )
    .map((value) => value + 0);
const positive = (most = 1e9): Arbitrary<number> => fc.double({min: 1e-9, max: most, noNaN: true});
const found = fc.oneof(
  fc.constant(null),
  fc.double({noNaN: true, noDefaultInfinity: true}).map((value) => value + 0),
); // by the engine: however large
const point: Arbitrary<Point> = fc.tuple(number(), number());
const far_point: Arbitrary<Point | null> = fc.oneof(fc.constant(null), fc.tuple(number(1e300), number(1e300)));
const pair: Arbitrary<TauPair> = fc.tuple(number(100), number(100));
const text = (most: number): Arbitrary<string> =>
  fc.oneof(
    fc.string({maxLength: most}),
    fc.string({maxLength: most, unit: "grapheme"}),
    fc.constantFrom("", '尾门 "A"', "<b>", "…", "__proto__", "constructor"),
  );
const points = (min: number, max: number): Arbitrary<Point[]> => fc.array(point, {minLength: min, maxLength: max});
const box: Arbitrary<Box> = fc.record({x: fc.tuple(number(), number()), y: fc.tuple(number(), number())});
/** Members that may be missing. */
function record<T extends object>(
  required: {[K in keyof T]?: Arbitrary<NonNullable<T[K]> | T[K]>},
  optional: {[K in keyof T]?: Arbitrary<T[K]>} = {},
): Arbitrary<T> {
  return fc.record({...required, ...optional} as never, {
    requiredKeys: Object.keys(required) as never[],
  }) as unknown as Arbitrary<T>;
}

// ---- tasks ----------------------------------------------------------------------------------------------------------

const derivative = fc.record({x: number(), y: number(), theta: number()});
const pose = record<Pose>(
  {x: number(), y: number(), theta_deg: number()},
  {derivatives: fc.array(derivative, {minLength: 1, maxLength: 4})},
);
const poses = fc.array(pose, {maxLength: 8});
const given: Arbitrary<Given> = fc.oneof(
  fc.record({side_lengths: fc.tuple(positive(), positive())}),
  fc.record({side_length: positive()}),
  fc.record(
    {side_angle_deg: number(), directed: fc.boolean(), input_length: positive()},
    {requiredKeys: ["side_angle_deg"]},
  ),
  fc.record({instant_center: point}),
  fc.record({instant_center: point, at_infinity: fc.constant(true)}),
) as Arbitrary<Given>;
const motion = record<MotionTask>(
  {kind: fc.constant("motion"), mechanism: fc.constant("four_bar"), poses},
  {given, freed_pose: fc.integer({min: 1, max: 5})},
);
const chain = fc.record(
  {a: point, b: point, d: point, elbow: fc.array(fc.constantFrom(-1, 1), {minLength: 4, maxLength: 4})},
  {requiredKeys: ["a", "b", "d"]},
);
const six_bar = record<SixBarTask>(
  {
    kind: fc.constant("motion"),
    mechanism: fc.constant("six_bar"),
    poses,
    added: fc.constantFrom(["0-2", "0-3"] as const, ["1-3", "0-2"] as const),
  },
  {chain},
);

const range = fc.tuple(number(), number());
const rates = fc.array(fc.record({input: number(), output: number()}), {minLength: 1, maxLength: 4});
const angle_pair = record<AnglePair>({input_deg: number(), output_deg: number()}, {derivatives: rates});
const named = record<NamedFunction>(
  {input_range_deg: range, output_range_deg: range},
  {
    expression: text(200),
    table: points(1, 50),
    interpolation: fc.constantFrom("linear", "monotone_cubic"),
    x: range,
    y: range,
    points: fc.integer({min: 4, max: 5}),
    spacing: fc.oneof(
      fc.constantFrom("chebyshev" as const, "even" as const),
      fc.array(number(), {minLength: 1, maxLength: 5}),
    ),
  },
);
const free = record<FreeNumber>(
  {number: fc.constantFrom("output_scale", "pair_output")},
  {pair: fc.integer({min: 1, max: 4}), range},
);
const function_ends = {ground_pivots: fc.record({input: point, output: point}), free};
const head = {kind: fc.constant("function" as const), mechanism: fc.constant("four_bar" as const)};
const function_task: Arbitrary<FunctionTask> = fc.oneof(
  record<FunctionTask>({...head, pairs: fc.array(angle_pair, {maxLength: 12})}, function_ends),
  record<FunctionTask>({...head, function: named}, function_ends),
);
export const task: Arbitrary<Task> = fc.oneof(motion, six_bar, function_task);

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
    objective: fc.constantFrom(...objectives),
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
    past: more.map((i) => ({...all[i], problem: all[0].problem})),
    present: all[present],
    future: all.slice(0, present),
  })),
);
export const property = fc.constantFrom("type" as const, ...properties);
