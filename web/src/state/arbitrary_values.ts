// For tests: numbers, points and poses as they can come about, drawn at random.
import fc, {type Arbitrary} from "fast-check";
import type {Box, Point, TauPair} from "../contract/messages";
import type {Pose} from "./task";

// Numbers as they are typed, computed or dragged; −0 is written as 0.
export const number = (most = 1e9): Arbitrary<number> =>
  fc
    .oneof(
      fc.integer({min: -1000, max: 1000}),
      fc.double({min: -most, max: most, noNaN: true}),
      fc.constantFrom(most, -most, 1e-9, 0.1),
    )
    .map((value) => value + 0);
export const positive = (most = 1e9): Arbitrary<number> => fc.double({min: 1e-9, max: most, noNaN: true});
export const found = fc.oneof(
  fc.constant(null),
  fc.double({noNaN: true, noDefaultInfinity: true}).map((value) => value + 0),
); // by the engine: however large
export const point: Arbitrary<Point> = fc.tuple(number(), number());
export const far_point: Arbitrary<Point | null> = fc.oneof(fc.constant(null), fc.tuple(number(1e300), number(1e300)));
export const pair: Arbitrary<TauPair> = fc.tuple(number(100), number(100));
export const text = (most: number): Arbitrary<string> =>
  fc.oneof(
    fc.string({maxLength: most}),
    fc.string({maxLength: most, unit: "grapheme"}),
    fc.constantFrom("", '尾门 "A"', "<b>", "…", "__proto__", "constructor"),
  );
export const points = (min: number, max: number): Arbitrary<Point[]> =>
  fc.array(point, {minLength: min, maxLength: max});
export const box: Arbitrary<Box> = fc.record({x: fc.tuple(number(), number()), y: fc.tuple(number(), number())});
/** Members that may be missing. */
export function record<T extends object>(
  required: {[K in keyof T]?: Arbitrary<NonNullable<T[K]> | T[K]>},
  optional: {[K in keyof T]?: Arbitrary<T[K]>} = {},
): Arbitrary<T> {
  return fc.record({...required, ...optional} as never, {
    requiredKeys: Object.keys(required) as never[],
  }) as unknown as Arbitrary<T>;
}

const derivative = fc.record({x: number(), y: number(), theta: number()});
const pose = record<Pose>(
  {x: number(), y: number(), theta_deg: number()},
  {derivatives: fc.array(derivative, {minLength: 1, maxLength: 4})},
);
export const poses = fc.array(pose, {maxLength: 8});
