// Requirements as the panel sees them: which are asked, how one is dropped or relaxed, and the words for it.
import {
  linkage_types,
  type Box,
  type Census,
  type Linkage,
  type MissedBox,
  type Relaxation,
  type RequirementKey,
  type Requirements,
} from "../contract/messages";
import type {Task} from "../state/task";
import type {Workbench} from "../state/workbench.svelte";
import {requirement_descriptions, requirement_of, requirements_of, text_for} from "../kinds/kind_dispatch";
import {grouped, mechanical_unit, percent_text, significant, with_unit} from "../texts/numbers";
import {t} from "../texts/texts.svelte";
import {least_of, most_of} from "../state/ends";
import {defaults} from "../state/defaults";

/** What is asked: the file's own requirements, where they are silent the defaults that the engine used. */
export function in_force({problem, task}: Pick<Workbench, "problem" | "task">): Requirements {
  const defined = Object.fromEntries(
    Object.entries(problem.requirements ?? {}).filter(([, value]) => value !== undefined),
  );
  return {...task?.requirements, ...defined};
}
export function is_asked(requirements: Requirements, key: RequirementKey): boolean {
  const value = requirements[key],
    described = requirement_descriptions[key],
    is_positive = typeof value === "number" && value > 0;
  switch (described.control) {
    case "types":
      return (requirements.types?.length ?? 0) > 0;
    case "no_defects":
      return requirements.no_defects ?? defaults.requirements.no_defects;
    case "transmission_angle":
      return is_positive;
    case "limit":
      return described.bound === "least" && described.from >= 0 ? is_positive : value != null;
    default:
      return value != null;
  }
}
/** The change that drops a requirement. The transmission angle over the task is defined only without defects. */
export function dropped(key: RequirementKey): Partial<Requirements> {
  switch (requirement_descriptions[key].control) {
    case "types":
    case "transmission_angle":
      return {[key]: undefined};
    case "no_defects":
      return {no_defects: false, min_transmission_angle_deg: undefined};
    default:
      return {[key]: null};
  }
}
/** The transmission angle leans on "no defects", which therefore cannot be dropped alone. */
export function is_needed(requirements: Requirements, key: RequirementKey): boolean {
  return key === "no_defects" && is_asked(requirements, "min_transmission_angle_deg");
}
export function relaxed(key: RequirementKey, value: number | Box | null): Partial<Requirements> {
  if (value === null) return dropped(key);
  return {[key]: typeof value === "number" ? Number(value.toPrecision(10)) : value};
}
export function all_dropped(keys: readonly RequirementKey[]): Partial<Requirements> {
  return Object.assign({}, ...keys.map(dropped));
}
/** Of which task, and in what unit its lengths are. */
export type Units = Pick<Workbench, "problem" | "unit">;
/** The unit of what can be typed in. */
export function unit_of(key: RequirementKey, {problem, unit}: Units): string {
  const described = requirement_of(problem.task, key);
  if (described.control === "transmission_angle") return "°";
  if (described.control !== "limit" || described.quantity === "ratio") return "";
  if (described.quantity === "percent") return "%";
  if (described.quantity === "angle" || described.in_degrees) return "°";
  return mechanical_unit(described.quantity, unit) ?? unit;
}
export function value_text(key: RequirementKey, value: number | Box, units: Units): string {
  if (typeof value !== "number")
    return (["x", "y"] as const)
      .map((axis) => `${axis} ${value[axis].map((end) => significant(end, 4)).join(" … ")}`)
      .join(", ");
  const of = unit_of(key, units);
  if (of === "%") return percent_text(value);
  const described = requirement_of(units.problem.task, key),
    is_fine = of !== "°" || (described.control === "limit" && described.quantity === "error");
  return with_unit(is_fine ? significant(value, 6) : significant(Number(value.toFixed(2)), 4), of);
}

/** Requirements that a linkage fails. A defect stands for itself: the transmission angle is not defined then. */
export function failing(linkage: Linkage, task: Task): RequirementKey[] {
  if (linkage.type === "degenerate") return [];
  const keys = requirements_of(task).filter((_, bit) => linkage.fails & (1 << bit));
  const {order, branch, circuit} = linkage.defects;
  return order || branch || circuit
    ? keys.filter((key) => key !== "min_transmission_angle_deg" && key !== "no_defects")
    : keys;
}

// ---- sentences ------------------------------------------------------------------------------------------------------

/** "transmission angle (89° at least)" */
function asked_for(key: RequirementKey, requirements: Requirements, units: Units): string {
  const described = requirement_descriptions[key],
    name = t(described.short),
    value = requirements[key];
  if (typeof value !== "number") return name;
  const at_most = described.control === "limit" && described.bound === "most";
  return t(at_most ? "req.at_most" : "req.at_least", {name, value: value_text(key, value, units)});
}
/** "Not met: link ratio (8 at most), box for fixed pivots", or nothing. */
export function unmet_text(linkage: Linkage, workbench: Pick<Workbench, "problem" | "task" | "unit">): string | null {
  const requirements = in_force(workbench);
  const names = failing(linkage, workbench.problem.task).map((key) => asked_for(key, requirements, workbench));
  return names.length > 0 ? t("req.unmet", {names: names.join(t("req.comma"))}) : null;
}
/** "The link ratio is the most restrictive; 8.2 leaves 34." `value` stands for the relaxed value. */
export function relaxation_text(
  {requirement, value: relaxed, leaves}: Relaxation,
  dearest: boolean,
  value: string,
): string {
  const values = {name: t(requirement_descriptions[requirement].short), value, n: grouped(leaves)};
  if (relaxed === null) return t(dearest ? "state.without_leaves" : "state.also_without", values);
  return t(dearest ? "state.costs_most" : "state.also", values);
}
/** "No single requirement is to blame: without the longest link and the box for fixed pivots together, 12 are left." */
export function together_text({requirements, leaves}: NonNullable<Census["relax_together"]>): string {
  const names = requirements.map((key) => t(requirement_descriptions[key].short)),
    last = names.pop()!;
  return t("req.relax_together", {
    names: names.length ? `${names.join(t("req.comma"))}${t("req.and")}${last}` : last,
    n: grouped(leaves),
  });
}
/** "The centre-point curve does not enter the box for fixed pivots; nearest is (250, 210), 60 mm further down." */
export function missed_box_text({requirement, nearest, beyond}: MissedBox, unit: string): string {
  const length = (value: number) => significant(Math.abs(value), 3) + (unit ? ` ${unit}` : "");
  const ways = (
    [
      [beyond[0], "left", "right"],
      [beyond[1], "down", "up"],
    ] as const
  ).flatMap(([by, back, ahead]) => (by === 0 ? [] : [t(`req.further_${by < 0 ? back : ahead}`, {length: length(by)})]));
  const described = requirement_descriptions[requirement],
    of_centers = described.control === "box" && described.end === "center";
  return t("req.missed_box", {
    curve: t(of_centers ? "req.curve_center" : "req.curve_circle"),
    name: t(described.short),
    place: nearest.map((v) => significant(v, 4)).join(", "),
    way: ways.join(t("req.comma")),
  });
}
export function none_defect_free_text({pairs, types, order, branch}: Census, task: Task): string {
  const four_bars = Math.max(pairs - types[linkage_types.indexOf("degenerate")]!, 1),
    percent = (part: number) => Math.round((100 * part) / four_bars);
  return t(text_for(task, "state.none_defect_free"), {order: percent(order), branch: percent(branch)});
}

/** Where the map has linkages without defects and none meets all requirements: what was looked at, and what is proved. */
export function none_left_text({defect_free, inside}: Census): string {
  if (inside.proved_empty) return t("notice.windows_empty");
  if (inside.looked_at > 0) return t("notice.none_inside", {count: inside.looked_at});
  return t(defect_free === 1 ? "state.none_left_of_one" : "state.none_left", {n: grouped(defect_free)});
}

// ---- boxes ----------------------------------------------------------------------------------------------------------

/** A box to begin with where none was drawn: around these points, with room. */
export function box_around(points: readonly (readonly [number, number])[]): Box {
  const around = (values: number[]): [number, number] => {
    const low = least_of(values),
      high = most_of(values),
      size = Math.max(high - low, 1e-3 * Math.max(Math.abs(high), 1));
    const step = 10 ** Math.floor(Math.log10(size)),
      tidy = (value: number) => Number(value.toPrecision(12));
    return [tidy(Math.floor((low - 0.5 * size) / step) * step), tidy(Math.ceil((high + 0.5 * size) / step) * step)];
  };
  return {x: around(points.map((p) => p[0])), y: around(points.map((p) => p[1]))};
}
