import type {LinkageOf} from "../state/document";
import type {Pin, Problem} from "../state/problem";
import {with_other_task} from "../kinds/kind_dispatch";

/** A pin in its own task. */
export function pinned_in(problem: Problem, {task, tau}: Pin): LinkageOf {
  return {problem: with_other_task(problem, task), tau};
}
