// How the drive runs by itself: which stretch, how fast, what happens at its ends. Time comes in, an angle goes out.
import type {Drive} from "../contract/messages";
import {angle_of_row, travel} from "../state/drive";
import type {Workbench} from "../state/workbench.svelte";
import {least_of, most_of} from "../state/ends";

export type Repeat = "reverse" | "loop" | "once";
export type Span = readonly [low: number, high: number];
export interface Run {
  angle: number;
  sense: 1 | -1;
  ended: boolean;
}

const task_ms = 2000,
  travel_ms = 4000; // one way at speed 1
const lit_ms = 250,
  longest_frame_ms = 200;

/** Driver angles of the prescribed stretch; nothing where a defect keeps its ends apart. */
export function task_span(drive: Drive): Span | null {
  if (drive.task[0] < 0 || drive.task[1] < 0) return null;
  const ends = drive.task.map((row) => angle_of_row(drive, row));
  const span: Span = [least_of(ends), most_of(ends)];
  return span[1] > span[0] ? span : null;
}
export function played_span(drive: Drive, whole: boolean): Span {
  return (whole ? null : task_span(drive)) ?? travel(drive);
}
export function degrees_per_ms(drive: Drive, whole: boolean, speed: number): number {
  const [low, high] = played_span(drive, whole);
  return (speed * (high - low)) / (whole || !task_span(drive) ? travel_ms : task_ms);
}

/** Where the run stands `by` degrees later. From outside the span it comes back into it. */
export function advanced(run: Run, by: number, [low, high]: Span, repeat: Repeat): Run {
  if (!(high > low)) return {...run, ended: true};
  const beyond = run.sense > 0 ? run.angle > high : run.angle < low;
  if (beyond && repeat === "reverse") {
    return {angle: run.angle - run.sense * by, sense: run.sense > 0 ? -1 : 1, ended: false};
  }
  const angle = run.angle + run.sense * by;
  if (run.sense > 0 ? angle < high : angle > low) return {...run, angle};
  const over = run.sense > 0 ? angle - high : low - angle;
  if (repeat === "once") return {...run, angle: run.sense > 0 ? high : low, ended: true};
  const rest = Math.min(over, by) % (high - low);
  if (repeat === "loop") return {...run, angle: run.sense > 0 ? low + rest : high - rest};
  return {angle: run.sense > 0 ? high - rest : low + rest, sense: run.sense > 0 ? -1 : 1, ended: false};
}

export interface Stop {
  pose: number; // from 0
  angle: number;
}
/** The positions the drive reaches, in the order in which it meets them. */
export function stops_of(drive: Drive): Stop[] {
  const stops = drive.ticks.flatMap((tick) =>
    tick.reached && tick.state >= 0 ? [{pose: tick.position - 1, angle: angle_of_row(drive, tick.state)}] : [],
  );
  return stops.sort((a, b) => a.angle - b.angle);
}
export function unreached_poses(drive: Drive): number[] {
  return drive.ticks.flatMap((tick) => (tick.reached && tick.state >= 0 ? [] : [tick.position - 1]));
}
/** The stops that are passed on the way from one angle to another, in that order; where the way begins does not count. */
export function passed(stops: readonly Stop[], from: number, to: number): Stop[] {
  if (from < to) return stops.filter((s) => s.angle > from && s.angle <= to);
  return stops.filter((s) => s.angle >= to && s.angle < from).reverse();
}
/** The next stop in a sense, the first one again after the last. */
export function next_stop(stops: readonly Stop[], angle: number, sense: 1 | -1): Stop | null {
  const near = 1e-9;
  if (sense > 0) return stops.find((s) => s.angle > angle + near) ?? stops[0] ?? null;
  return stops.findLast((s) => s.angle < angle - near) ?? stops.at(-1) ?? null;
}

let dark: ReturnType<typeof setTimeout> | undefined;
/** Lets the outline of a position light up for a moment. */
export function light(workbench: Workbench, pose: number): void {
  clearTimeout(dark);
  workbench.lit_pose = pose;
  dark = setTimeout(() => (workbench.lit_pose = null), lit_ms);
}
/** Moves the drive as a hand does, lighting what is passed. */
export function move_to(workbench: Workbench, angle: number): void {
  const drive = workbench.hand?.drive;
  if (!drive) return;
  const on_way = passed(stops_of(drive), workbench.angle, angle);
  workbench.set_angle(angle);
  for (const stop of on_way) light(workbench, stop.pose);
}
export function step(workbench: Workbench, sense: 1 | -1): void {
  const drive = workbench.hand?.drive;
  const stop = drive && next_stop(stops_of(drive), workbench.angle, sense);
  if (!stop) return;
  workbench.playing = false;
  workbench.set_angle(stop.angle);
  light(workbench, stop.pose);
}

export function prefers_stillness(): boolean {
  return globalThis.matchMedia?.("(prefers-reduced-motion: reduce)").matches ?? false;
}
const opening_ms = 2000,
  resting_stage = 2.45;
/** The first start: the linkage opens once from its first position to its last and rests between 3 and 4. Whatever else
 *  moves the drive meanwhile ends it. */
export function open_once(workbench: Workbench): void {
  const last = (workbench.hand?.drive && stops_of(workbench.hand.drive).length - 1) ?? 0;
  if (prefers_stillness() || workbench.playing || last < 1) return;
  const rest = Math.min(resting_stage, last - 0.55);
  let began: number | null = null,
    set = workbench.stage;
  const frame = (now: number) => {
    if (workbench.playing || workbench.stage !== set) return;
    began ??= now;
    const share = Math.min((now - began) / opening_ms, 1);
    const turn_back = Math.min(Math.max((now - began - opening_ms) / 300, 0), 1);
    set = workbench.stage = share < 1 ? share * last : last - turn_back * (last - rest);
    if (turn_back < 1) requestAnimationFrame(frame);
  };
  requestAnimationFrame(frame);
}

/** The loop behind ▶: runs until told to stop. Returns how to. */
export function run(workbench: Workbench, speed: () => number, repeat: () => Repeat): () => void {
  let sense: 1 | -1 = 1,
    before: number | null = null,
    handle = 0;
  const begin = workbench.hand?.drive;
  if (begin && repeat() === "once") {
    const [low, high] = played_span(begin, workbench.whole_travel);
    if (workbench.angle >= high - 1e-9) workbench.set_angle(low);
  }
  const advance = (ms: number) => {
    const drive = workbench.hand?.drive;
    if (!drive) return;
    const whole = workbench.whole_travel,
      angle = workbench.angle;
    const now = advanced(
      {angle, sense, ended: false},
      ms * degrees_per_ms(drive, whole, speed()),
      played_span(drive, whole),
      repeat(),
    );
    sense = now.sense;
    move_to(workbench, now.angle);
    if (now.ended) workbench.playing = false;
  };
  const still = prefers_stillness() ? setInterval(() => jump(), 900 / speed()) : undefined;
  const jump = () => {
    const drive = workbench.hand?.drive;
    const stop = drive && next_stop(stops_of(drive), workbench.angle, 1);
    if (!stop) return;
    workbench.set_angle(stop.angle);
    light(workbench, stop.pose);
  };
  const frame = (now: number) => {
    advance(before === null ? 0 : Math.min(now - before, longest_frame_ms)); // a page that was hidden does not leap
    before = now;
    if (workbench.playing) handle = requestAnimationFrame(frame);
  };
  if (still === undefined) handle = requestAnimationFrame(frame);
  return () => {
    cancelAnimationFrame(handle);
    clearInterval(still);
  };
}
