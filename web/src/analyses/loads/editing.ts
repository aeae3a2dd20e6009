// Loads of a problem as the page gives and takes them.
import type {Point} from "../../contract/messages";
import {read_outs, type ReadOut} from "../../contract/problem";
import type {Problem} from "../../state/problem";
import {with_analysis} from "../../kinds/kind_dispatch";
import {cases_of, counts_for, is_between_studs, loads_of, type LoadCase, type Loads, type Spring} from "./block";
import {loads as analysis} from "./index";

/** With other loads, or none; what is asked of linkages only with those that there were goes with them. */
export function loaded_with(problem: Problem, loads: Loads | null): Problem {
  return with_analysis(problem, analysis, loads);
}
/** With a change of the loads there are. */
export function with_loads(problem: Problem, change: (loads: Loads) => Loads): Problem {
  const loads = loads_of(problem);
  return loads ? loaded_with(problem, change(loads)) : problem;
}
/** With members changed; undefined takes one away. */
export function changed<T extends object>(of: T, change: Partial<T>): T {
  const all = {...of, ...change};
  for (const key of Object.keys(change) as (keyof T)[]) if (all[key] === undefined) delete all[key];
  return all;
}

function replaced<T>(list: readonly T[], index: number, item: T): T[] {
  return list.map((one, i) => (i === index ? item : one));
}
function without<T>(list: readonly T[], index: number): T[] {
  return list.filter((_, i) => i !== index);
}
export function with_spring(loads: Loads, index: number, change: Partial<Spring>): Loads {
  const {springs = []} = loads,
    spring = springs[index];
  return spring
    ? {...loads, springs: replaced(springs, index, changed(spring, change as Partial<typeof spring>))}
    : loads;
}
export function with_stud(loads: Loads, index: number, end: "from" | "to", at: Point): Loads {
  const spring = loads.springs?.[index];
  if (!spring || !is_between_studs(spring)) return loads;
  return with_spring(loads, index, {[end]: {...spring[end], at}});
}
export function without_spring(loads: Loads, index: number): Loads {
  const springs = without(loads.springs ?? [], index);
  return changed(loads, {springs: springs.length ? springs : undefined});
}
export function with_case(loads: Loads, index: number, change: Partial<LoadCase>): Loads {
  const cases = cases_of(loads);
  return {...loads, cases: replaced(cases, index, changed(cases[index]!, change))};
}
export function with_extra(loads: Loads, index: number, change: object): Loads {
  const {extra = []} = loads,
    one = extra[index];
  return one ? {...loads, extra: replaced(extra, index, changed(one, change))} : loads;
}
/** The cases that name it name it so; each load has a name of its own. */
export function renamed_extra(loads: Loads, index: number, name: string): Loads {
  const before = loads.extra?.[index]?.name;
  if (!name || before === undefined || loads.extra!.some((one) => one.name === name)) return loads;
  const cases = loads.cases?.map((of) =>
    of.extra ? {...of, extra: of.extra.map((one) => (one === before ? name : one))} : of,
  );
  return with_extra(changed(loads, {cases}), index, {name});
}
export function without_extra(loads: Loads, index: number): Loads {
  const {name} = loads.extra![index]!,
    extra = without(loads.extra!, index);
  const cases = loads.cases?.map((of) => acting_in(of, name, false));
  return changed(loads, {extra: extra.length ? extra : undefined, cases});
}
function acting_in(of: LoadCase, name: string, acts: boolean): LoadCase {
  const others = (of.extra ?? []).filter((one) => one !== name),
    extra = acts ? [...others, name] : others;
  return changed(of, {extra: extra.length ? extra : undefined});
}
export function with_extra_in_case(loads: Loads, index: number, name: string, acts: boolean): Loads {
  return with_case(loads, index, acting_in(cases_of(loads)[index]!, name, acts));
}
/** None named: it counts for all of them. */
export function with_read_out(loads: Loads, index: number, read_out: ReadOut, counts: boolean): Loads {
  const of = cases_of(loads)[index]!,
    counted = read_outs.filter((one) => (one === read_out ? counts : counts_for(of, one)));
  const some = counted.length > 0 && counted.length < read_outs.length;
  return with_case(loads, index, {for: some ? counted : undefined});
}
/** There is always one. */
export function without_case(loads: Loads, index: number): Loads {
  const cases = without(cases_of(loads), index);
  return changed(loads, {cases: cases.length ? cases : undefined});
}
