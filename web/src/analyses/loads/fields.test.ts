// Each field gives back what it shows, and what is typed into it is what a file has.
import {expect, it} from "vitest";
import {four_bar_loading} from "./making";
import {cases_of, read_loads, type Loads} from "./block";
import {renamed_extra, with_extra_in_case, with_read_out, without_extra} from "./editing";
import {all, stud, strut} from "./example";
import * as fields from "./fields";
import {put_on} from "./places";

const unit = "mm";
const lines: fields.NumberLine[] = [
  ...fields.body_lines(all, unit),
  ...four_bar_loading.links.flatMap((side) => fields.link_lines(all, side, unit)),
  ...fields.rare_lines(all, unit),
  ...all.extra!.flatMap((extra, i) => fields.extra_lines(all, i, extra, unit)),
  ...all.springs!.flatMap((spring, i) => fields.spring_lines(spring, all, i, unit)),
  ...fields.rare_gas_lines(strut, all, 0, unit),
  ...cases_of(all).flatMap((of, i) => [...fields.case_lines(all, i, of), fields.exponent_line(all, i, of)]),
];

it.each(lines)("what stands in $key is what is given, and another number is taken", (line) => {
  const typed = line.with_value(line.high === undefined ? 1234 : line.high);
  expect(read_loads(typed)).toEqual(typed);
  expect(typed).not.toEqual(all);
  if (line.value === null) return;
  const same = read_loads(line.with_value(line.value))!;
  const without_defaults = (loads: Loads) => JSON.stringify(loads, (_, value: unknown) => value ?? undefined);
  const change = without_defaults(same).length - without_defaults(all).length;
  expect(Math.abs(change)).toBeLessThan(40); // at most what was not written is
});
it("what may be nothing can be taken away", () => {
  for (const line of lines.filter(({optional, value}) => optional && value !== null)) {
    const typed = line.with_value(null);
    expect(read_loads(typed), line.key).toEqual(typed);
    expect(typed).not.toEqual(all);
  }
});
it("compressing is told by one number or two", () => {
  expect(fields.with_compressing(strut, false)).toEqual({F3: undefined, F4: undefined, friction: 25});
  const one = {...strut, F3: undefined, F4: undefined, friction: 20};
  expect(fields.with_compressing(one, true)).toEqual({friction: undefined, F3: 415, F4: 540});
});
it("loads have names that cases know", () => {
  const wet = renamed_extra(all, 0, "wet snow");
  expect([wet.extra![0]!.name, wet.cases![1]!.extra]).toEqual(["wet snow", ["wet snow"]]);
  expect(renamed_extra(all, 0, "wind")).toBe(all);
  expect(renamed_extra(all, 0, "")).toBe(all);
  const bare = without_extra(wet, 0);
  expect([bare.extra!.length, bare.cases![1]]).toEqual([2, expect.not.objectContaining({extra: expect.anything()})]);
  expect(with_extra_in_case(all, 0, "wind", true).cases![0]).toEqual({name: "room", extra: ["wind"]});
});
it("a case counts for some read-outs or all", () => {
  expect(with_read_out(all, 1, "hump", true).cases![1]!.for).toEqual(["hold_open", "hump"]);
  expect(with_read_out(all, 1, "hold_open", false).cases![1]).not.toHaveProperty("for");
  expect(with_read_out(all, 0, "hump", false).cases![0]!.for).not.toContain("hump");
});
it("a stud that is put on another body stays where it is, if anybody knows", () => {
  const first = {x: 10, y: 0, theta_deg: 90};
  expect(put_on(stud("ground", 10, 5), "body", first)).toEqual(stud("body", 5, 0));
  expect(put_on(stud("body", 5, 0), "ground", first)).toEqual(stud("ground", 10, 5));
  expect(put_on(stud("body", 5, 0), "coupler", first)).toEqual(stud("coupler", 0, 0));
  expect(put_on(stud("input", 5, 0), "input", first)).toEqual(stud("input", 5, 0));
});
