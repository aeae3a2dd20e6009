// What the frame asks the analyses.
import type {Point, RequirementKey} from "../contract/messages";
import type {Problem} from "../state/problem";
import type {JsonObject} from "../state/shape";
import type {TaskKind} from "../kinds/kind";
import type {AnalysisModule, Criteria} from "./analysis";
import {analysis_modules} from "./registry";

/** Of a problem, or of one in the making. */
export function block_of(problem: object, {block}: Pick<AnalysisModule, "block">): object | null {
  return (problem as Record<string, object | undefined>)[block] ?? null;
}
export function with_block<P extends object>(
  problem: P,
  {block}: Pick<AnalysisModule, "block">,
  given: object | null,
): P {
  const {[block]: _, ...bare} = problem as Record<string, unknown>;
  return (given ? {...bare, [block]: given} : bare) as P;
}
export function without_blocks(problem: Problem): Problem {
  return analysis_modules.reduce((bare, analysis) => with_block(bare, analysis, null), problem);
}
/** The blocks of a problem from outside. */
export function read_blocks(problem: JsonObject): object {
  return analysis_modules.reduce(
    (read, analysis) => with_block(read, analysis, analysis.read(problem[analysis.block])),
    {},
  );
}
/** Those that say something of linkages of this kind. */
export function analyses_of(kind: TaskKind): readonly AnalysisModule[] {
  return analysis_modules.filter((analysis) => analysis.criteria(kind) !== null);
}
/** Those whose block the problem has. */
export function given_analyses(problem: object): readonly AnalysisModule[] {
  return analysis_modules.filter((analysis) => block_of(problem, analysis) !== null);
}
/** Whether the problem has of some analysis what something needs. */
export function is_given(problem: object, needs: string): boolean {
  return given_analyses(problem).some((analysis) => analysis.has(block_of(problem, analysis)!, needs));
}
const criteria = new WeakMap<TaskKind, Criteria>();
/** The kind's own, and what analyses add. */
export function criteria_of(kind: TaskKind): Criteria {
  const known = criteria.get(kind);
  if (known) return known;
  const all = [kind, ...analysis_modules.flatMap((analysis) => analysis.criteria(kind) ?? [])];
  const merged: Criteria = {
    properties: Object.assign({}, ...all.map(({properties}) => properties)) as Criteria["properties"],
    requirements: Object.assign({}, ...all.map(({requirements}) => requirements)) as Criteria["requirements"],
    objectives: Object.assign({}, ...all.map(({objectives}) => objectives)) as Criteria["objectives"],
  };
  criteria.set(kind, merged);
  return merged;
}
/** Requirements that linkages of one kind have and that mean something else of the other. */
export function changed_requirements(kind: TaskKind, before: TaskKind): readonly RequirementKey[] {
  return analysis_modules.flatMap((analysis) => analysis.changed(kind, before));
}
/** With the fixed frame seen from elsewhere. */
export function with_moved_blocks<P extends object>(problem: P, move: (point: Point) => Point): P {
  return given_analyses(problem).reduce(
    (moved, analysis) =>
      analysis.moved ? with_block(moved, analysis, analysis.moved(block_of(moved, analysis)!, move)) : moved,
    problem,
  );
}
/** The analysis whose card this is. */
export function analysis_of_card(id: string): AnalysisModule | null {
  return analysis_modules.find(({cards}) => cards.some((card) => card.id === id)) ?? null;
}
