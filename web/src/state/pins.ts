// Pins as values: each belongs to the task in which it was made.
import type {Linkage, TauPair} from "../contract/messages";
import {kept_pivots} from "../kinds/kind_dispatch";
import type {Pin, Problem} from "./problem";
import {same_task, type Task} from "./task";

export function new_pin(linkage: Linkage, problem: Problem, name: string, place: TauPair | null): Pin {
  return {
    name,
    tau: linkage.tau,
    place: place ?? undefined,
    task: problem.task,
    type: linkage.type,
    min_transmission_angle_deg: linkage.min_transmission_angle_deg,
    link_ratio: linkage.link_ratio,
    longest: linkage.longest,
    lengths: linkage.lengths,
    pivots: kept_pivots(problem.task, linkage),
  };
}
/** A … Z, A1 … Z1, A2 …: the first that no pin has. */
export function free_name(pins: readonly Pin[]): string {
  for (let i = 0; ; ++i) {
    const name = String.fromCharCode(65 + (i % 26)) + (i < 26 ? "" : Math.floor(i / 26));
    if (!pins.some((pin) => pin.name === name)) return name;
  }
}
/** The name, or where another pin has it the first that none has. */
export function unused_name(pins: readonly Pin[], name: string): string {
  return pins.some((pin) => pin.name === name) ? free_name(pins) : name;
}
/** The pin that keeps this linkage of the task. */
export function find_pin(pins: readonly Pin[], task: Task, tau: TauPair): Pin | undefined {
  return pins.find((pin) => same_task(pin.task, task) && Math.hypot(pin.tau[0] - tau[0], pin.tau[1] - tau[1]) < 1e-6);
}
