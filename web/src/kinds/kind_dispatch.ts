// What the frame asks the kind of the task at hand.
import {
  requirement_keys_of,
  type Linkage,
  type LinkageType,
  type Notice,
  type Point,
  type Property,
  type RequirementKey,
  type Requirements,
} from "../contract/messages";
import {with_options, with_requirements, with_task, type Objective, type Pin, type Problem} from "../state/problem";
import {is_object, type JsonObject} from "../state/shape";
import {diagonal_of, poses_of, type Pose, type Task} from "../state/task";
import {
  block_of,
  changed_requirements,
  criteria_of,
  given_analyses,
  is_given,
  with_block,
} from "../analyses/analysis_dispatch";
import type {Analysis} from "../analyses/analysis";
import {notice_text, type TextKey} from "../texts/texts.svelte";
import type {TermName} from "../terms/pictures";
import type {
  AtPlace,
  Incomplete,
  NamedJoint,
  NamedLength,
  ObjectiveDescription,
  PropertyDescription,
  RequirementDescription,
  TaskKind,
} from "./kind";
import {task_modules} from "./registry";

/** None is asked of another's task. */
export const task_kinds = task_modules as unknown as readonly TaskKind[];

export function kind_of(task: Task): TaskKind {
  return task_kinds.find((kind) => kind.is(task)) ?? (task_modules[0] as unknown as TaskKind);
}
/** The same object is the same task: the steps of undo share what they have in common. */
export function read_task(value: unknown): Task | null {
  if (!is_object(value)) return null;
  const known = read_before.get(value);
  if (known !== undefined) return known;
  let task: Task | null = null;
  for (const kind of task_kinds) task ??= kind.read(value);
  read_before.set(value, task);
  return task;
}
const read_before = new WeakMap<object, Task | null>();

/** A body's poses, where a file has no more of a task than them. */
export function task_of_poses(poses: unknown): Task | null {
  return first_told((kind) => kind.of_poses?.(poses));
}
/** What a file of the program's holds that is no problem file. */
export function task_of_file(file: JsonObject): Task | null {
  return first_told((kind) => kind.of_file?.(file));
}
/** As it is saved for the program. */
export function filed(problem: Problem): object {
  return kind_of(problem.task).filed?.(problem) ?? problem;
}
function first_told<T>(ask: (kind: TaskKind) => T | null | undefined): T | null {
  for (const kind of task_kinds) {
    const told = ask(kind);
    if (told != null) return told;
  }
  return null;
}

/** Whether links have lengths: otherwise they are angles, in degrees. */
export function has_lengths(task: Task): boolean {
  return !kind_of(task).without_lengths;
}
/** What new tasks require, and what is gone back to. */
export function first_requirements(problem: Problem): Requirements {
  const size = has_lengths(problem.task) ? {max_length: default_max_length(problem)} : {};
  return {min_transmission_angle_deg: 30, ...size};
}
/** Whether linkages are sought. */
export function has_linkages(task: Task): boolean {
  return !kind_of(task).without_linkages;
}
/** Whether the task is a linkage itself. */
export function gives_linkage(task: Task): boolean {
  return kind_of(task).gives_linkage === true;
}
/** Whether linkages are looked for: then there is a map, and something to require of them. */
export function seeks_linkages(task: Task): boolean {
  return has_linkages(task) && !gives_linkage(task);
}

// ---- of a task ------------------------------------------------------------------------------------------------------

export function incompleteness({task}: Problem): Incomplete | null {
  return kind_of(task).incompleteness(task);
}
export function default_max_length(problem: Problem): number {
  return kind_of(problem.task).default_max_length(problem);
}
export function anchors_of(task: Task): Point[] {
  return kind_of(task).anchors(task);
}
/** How large the task is: the diagonal of the box around it. */
export function extent_of(task: Task): number {
  return diagonal_of(anchors_of(task)) || 1;
}
/** Of a problem, with the blocks of analyses, what says what can be asked of its linkages. */
type Asked = Pick<Problem, "task">;
/** Keys of what this problem has of a kind's list. */
function keys_of<K extends string>(
  list: Partial<Record<K, {is_of?(task: Task): boolean; needs?: string}>>,
  problem: Asked,
): K[] {
  return (Object.keys(list) as K[]).filter(
    (key) => (list[key]!.is_of?.(problem.task) ?? true) && has_needed(problem, list[key]!.needs),
  );
}
/** In words and numbers, as linkages of this task have it. */
export function property_of(task: Task, property: Property): PropertyDescription {
  return criteria_of(kind_of(task)).properties[property] ?? property_descriptions[property];
}
export function requirement_of(task: Task, key: RequirementKey): RequirementDescription {
  return criteria_of(kind_of(task)).requirements[key] ?? requirement_descriptions[key];
}
/** What a colour of the map can stand for, beside the type. */
export function properties_of(problem: Asked): Property[] {
  return keys_of(criteria_of(kind_of(problem.task)).properties, problem);
}
/** Of which the map knows what has been sampled. */
export function sampled_properties(task: Task): Property[] {
  const {properties} = criteria_of(kind_of(task));
  return (Object.keys(properties) as Property[]).filter((key) => properties[key]!.sampled);
}
/** What a linkage of this task can be, degenerate left out. */
export function types_of(task: Task): readonly LinkageType[] {
  return kind_of(task).types;
}
/** What can be required of a linkage of this task: a requirement's place among them is its bit. */
export function requirements_of(task: Task): readonly RequirementKey[] {
  const of_engine: Readonly<Record<string, readonly RequirementKey[]>> = requirement_keys_of;
  const known = criteria_of(kind_of(task)).requirements,
    of_kind = of_engine[`${task.kind} ${task.mechanism}`] ?? (Object.keys(known) as RequirementKey[]);
  return of_kind.filter((key) => known[key]?.is_of?.(task) ?? true); // what not all tasks have comes last
}
export function requirement_bit(task: Task, key: RequirementKey): number {
  const place = requirements_of(task).indexOf(key);
  return place < 0 ? 0 : 1 << place;
}
export function objectives_of(problem: Asked): Objective[] {
  return keys_of(criteria_of(kind_of(problem.task)).objectives, problem);
}
export function objective_of({task, options}: Problem): Objective {
  const usual = kind_of(task).default_objective ?? "min_transmission_angle";
  return options?.objective ?? (typeof usual === "string" ? usual : usual(task));
}
/** What is asked of the engine while a hand moves. */
export function hurried(problem: Problem): Problem {
  return kind_of(problem.task).hurried?.(problem) ?? problem;
}
/** What the objective is measured by, where the map has it. */
export function measure_of(problem: Problem): Property {
  const {task} = problem,
    has = properties_of(problem),
    measure = criteria_of(kind_of(task)).objectives[objective_of(problem)]?.measure;
  return measure && has.includes(measure) ? measure : (has[0] ?? "min_transmission_angle_deg");
}
/** Of all kinds, in words and numbers. */
export const property_descriptions = in_all("properties") as Record<Property, PropertyDescription>;
export const requirement_descriptions = in_all("requirements") as Record<RequirementKey, RequirementDescription>;
export const objective_descriptions = in_all("objectives") as Record<Objective, ObjectiveDescription>;
function in_all(list: "properties" | "requirements" | "objectives"): object {
  return Object.assign({}, ...task_kinds.map((kind) => criteria_of(kind)[list]));
}
/** The problem with another task, without what goes only with the old one: an objective, requirements of another kind,
 *  what analyses say of what its linkages do not have. */
export function with_other_task<T extends Task>(problem: Problem, task: T): Problem {
  const changed = with_fitting_analyses(with_task(problem, task), kind_of(problem.task)),
    has = objectives_of(changed),
    lost = objectives_of(problem).filter((objective) => !has.includes(objective)),
    fitting = kind_of(problem.task) === kind_of(task) ? changed : with_known_requirements(changed);
  return lost.some((objective) => objective === problem.options?.objective)
    ? with_options(fitting, {objective: undefined})
    : fitting;
}
/** Only what can be required of a linkage of its task. */
function with_known_requirements(problem: Problem): Problem {
  const {task, requirements} = problem,
    has = criteria_of(kind_of(task)).requirements;
  if (!requirements) return problem;
  const kept: Requirements = Object.fromEntries(
    Object.entries(requirements).filter(([key]) => key in has || key === "respect_direction"),
  );
  const types = kept.types?.filter((type) => types_of(task).includes(type));
  return {...problem, requirements: types ? {...kept, types} : kept};
}
// ---- analyses -------------------------------------------------------------------------------------------------------

/** Linkages that are searched for have no map on which they could be ranked by what an analysis says. */
function is_searched(task: Task): boolean {
  const state = kind_of(task).incompleteness(task)?.state;
  return state === "no_chain" || state === "to_be_sought";
}
export function has_needed(problem: Asked, needs: string | undefined): boolean {
  return !needs || (!is_searched(problem.task) && is_given(problem, needs));
}
/** With another block of an analysis, or none; what is asked of linkages only with the one there was goes with it. */
export function with_analysis(problem: Problem, analysis: Pick<Analysis, "block">, given: object | null): Problem {
  return without_unmet(with_block(problem, analysis, given));
}
/** Without requirements and an objective that need what is not given. */
export function without_unmet(problem: Problem): Problem {
  const {requirements, objectives} = criteria_of(kind_of(problem.task)),
    objective = problem.options?.objective,
    unmet = (needs: string | undefined) => !has_needed(problem, needs);
  const asked = Object.keys(problem.requirements ?? {}) as RequirementKey[],
    lost = asked.filter((key) => unmet(needs_of(requirements[key])));
  const kept = without_requirements(problem, lost);
  return objective && unmet(objectives[objective]?.needs) ? with_options(kept, {objective: undefined}) : kept;
}
function without_requirements(problem: Problem, keys: readonly RequirementKey[]): Problem {
  if (keys.length === 0) return problem;
  return with_requirements(problem, Object.fromEntries(keys.map((key) => [key, undefined])));
}
export function needs_of(described: RequirementDescription | undefined): string | undefined {
  return described?.control === "limit" ? described.needs : undefined;
}
/** With what goes with the task's linkages; `before`: with those of which it was said. */
function with_fitting_analyses(problem: Problem, before: TaskKind): Problem {
  const kind = kind_of(problem.task);
  const fitting = given_analyses(problem).reduce(
    (changed, analysis) => with_block(changed, analysis, analysis.fitted(block_of(changed, analysis)!, kind)),
    problem,
  );
  const lost = given_analyses(problem).length ? changed_requirements(kind, before) : [];
  return without_requirements(without_unmet(fitting), lost);
}

// ---- poses and words -------------------------------------------------------------------------------------------

/** The task with other poses, and without what does not go with them. */
export function with_task_poses(task: Task, poses: readonly Pose[]): Task {
  return kind_of(task).with_poses?.(task, poses) ?? task;
}
export function with_pose(problem: Problem, index: number, change: Partial<Pose>): Problem {
  const poses = poses_of(problem.task).map((pose, i) => (i === index ? {...pose, ...change} : pose));
  return with_poses(problem, poses);
}
export function with_pose_moved(problem: Problem, index: number, [dx, dy]: Point): Problem {
  const {x, y} = poses_of(problem.task)[index]!,
    tidy = (value: number) => Number(value.toPrecision(12));
  return with_pose(problem, index, {x: tidy(x + dx), y: tidy(y + dy)});
}
export function with_poses(problem: Problem, poses: readonly Pose[]): Problem {
  const changed = with_task(problem, with_task_poses(problem.task, poses));
  return kind_of(changed.task).fitting?.(changed) ?? changed;
}
/** A text of the frame, as this kind of task says it. */
export function text_for(task: Task, key: TextKey): TextKey {
  return kind_of(task).texts?.[key] ?? key;
}
/** A sentence of the engine, as this kind of task says it. */
export function told(task: Task, notice: Notice): string {
  return notice_text(notice, text_for(task, `notice.${notice.code}` as TextKey));
}
/** What a linkage of this task is called: a text's key. */
export function name_of(task: Task, type: LinkageType): TextKey {
  return kind_of(task).make_up?.(task) ?? `type.${type}`;
}
export function map_of(task: Task): string {
  return kind_of(task).map_of(task);
}

/** What a pin of this task keeps of a linkage. */
export function kept_pivots(task: Task, linkage: Linkage): Pin["pivots"] {
  const own = kind_of(task).kept_pivots?.(linkage);
  if (own) return own;
  const {input, output} = linkage;
  return {
    input_center: input.center,
    input_circle: input.circle,
    output_center: output.center,
    output_circle: output.circle,
  };
}

/** The same of a linkage in a file of the program's; null: a four-bar of the plane. */
export function filed_pivots(task: Task, linkage: JsonObject): Pin["pivots"] | null {
  return kind_of(task).filed_pivots?.(linkage) ?? null;
}

// ---- of a linkage, which tells by what it carries whose it is -------------------------------------------------------

/** What it is called: a text's key. */
export function called(linkage: Pick<Linkage, "type">): TextKey {
  return made_up(linkage) ?? `type.${linkage.type}`;
}
/** What it is called where that is more than its type. */
export function made_up(linkage: Pick<Linkage, "type">): TextKey | null {
  return first_told((kind) => kind.called?.(linkage as Linkage));
}
/** The term that explains it, where its type does not. */
export function term_of_kind(linkage: Pick<Linkage, "type">): TermName | null {
  return first_told((kind) => kind.term?.(linkage as Linkage));
}
export function linkages_at_place(linkage: Linkage): AtPlace | null {
  return first_told((kind) => kind.at_place?.(linkage));
}
/** Null: of a four-bar, whose links and pivots all know. */
export function lengths_of(linkage: Linkage): NamedLength[] | null {
  return first_told((kind) => kind.lengths?.(linkage));
}
export function joints_of(linkage: Linkage): NamedJoint[] | null {
  return first_told((kind) => kind.joints?.(linkage));
}
