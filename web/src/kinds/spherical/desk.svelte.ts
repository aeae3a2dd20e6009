// What is being looked at of orientations: the engine's word on each, and the ring that is being dragged.
import {EachOnce} from "../../questions/each_once.svelte";
import {Question} from "../../questions/question.svelte";
import {in_form_of, type Converted, type Orientation} from "../../orientation/orientation";
import type {Workbench} from "../../state/workbench.svelte";
import {
  is_spherical,
  turned,
  with_orientations,
  without_rates,
  type PrescribedOrientation,
  type SphericalTask,
} from "./task";

interface Ring {
  from: SphericalTask;
  index: number;
  axis: number;
  angle_deg: number;
}
const first_turn_deg = 10; // of one that is added, about z

export class SphericalDesk {
  private readonly orientations: EachOnce<PrescribedOrientation, Converted>;
  private readonly ring_turned: Question<Ring, Converted>;
  private readonly next: Question<PrescribedOrientation, Converted>;
  private ring: Ring | null = null;

  constructor(private readonly workbench: Workbench) {
    this.orientations = new EachOnce(workbench, text_of, async (client, one, signal) => {
      const text = JSON.stringify({orientation: without_rates(one)}),
        {report} = await client.run({kind: "report", of: "orientation", text}, {signal});
      return (report as {convert: Converted}).convert;
    });
    this.ring_turned = new Question(workbench.questions, {follows: true});
    this.next = new Question(workbench.questions);
  }

  get task(): SphericalTask | null {
    const {task} = this.workbench.problem;
    return is_spherical(task) ? task : null;
  }
  get selected(): number | null {
    const {selected_pose} = this.workbench,
      count = this.task?.orientations.length ?? 0;
    return selected_pose !== null && selected_pose < count ? selected_pose : null;
  }
  select(index: number | null): void {
    this.workbench.selected_pose = index;
  }
  /** What the engine says of an orientation; null: nothing yet. */
  converted(prescribed: PrescribedOrientation): Converted | null {
    return this.orientations.value_of(prescribed);
  }

  // ---- edits ----------------------------------------------------------------------------------------------------------

  change(
    to: (orientations: readonly PrescribedOrientation[]) => readonly PrescribedOrientation[],
    merge: string | null = null,
  ): void {
    this.workbench.edit((problem) => {
      const {task} = problem;
      return is_spherical(task) ? {...problem, task: with_orientations(task, to(task.orientations))} : problem;
    }, merge);
  }
  change_one(
    index: number,
    to: (one: PrescribedOrientation) => PrescribedOrientation,
    merge: string | null = null,
  ): void {
    this.change((orientations) => orientations.map((one, i) => (i === index ? to(one) : one)), merge);
  }

  /** One more, in the form of the last and turned a little from it: the same twice is no task. */
  async add(): Promise<void> {
    if (this.next.busy) return; // a second one would be turned from the same
    const last = this.task?.orientations.at(-1),
      next: PrescribedOrientation = last ? await this.beside(last) : {euler_deg: [0, 0, 0], sequence: "zyx"};
    this.change((all) => [...all, next]);
    this.select((this.task?.orientations.length ?? 1) - 1);
  }
  /** The same where there is no engine to turn it. */
  private async beside(orientation: PrescribedOrientation): Promise<PrescribedOrientation> {
    const text = turn_text(orientation, 2, first_turn_deg),
      bare = without_rates(orientation),
      client = this.workbench.driver_client;
    if (!client) return bare;
    const turned = await this.next.ask(orientation, async (signal) => {
      const {report} = await client.run({kind: "report", of: "orientation", text}, {signal});
      return (report as {convert: Converted}).convert;
    });
    return turned ? in_form_of(turned, bare) : bare;
  }

  // ---- the engine -----------------------------------------------------------------------------------------------------

  /** Asks of what is not known yet: to be called where the task is followed. */
  follow(): void {
    void this.orientations.want(this.task?.orientations ?? []);
  }

  // ---- rings ----------------------------------------------------------------------------------------------------------

  take_ring(axis: number): void {
    const {task, selected} = this;
    if (!task || selected === null) return;
    this.workbench.playing = false;
    this.workbench.begin_gesture();
    this.ring = {from: task, index: selected, axis, angle_deg: 0};
  }
  turn_ring(angle_deg: number): void {
    if (!this.ring) return;
    if (!this.workbench.gesture) return void (this.ring = null); // taken back meanwhile
    const rounded = Math.round(angle_deg * 10) / 10;
    if (rounded === this.ring.angle_deg) return;
    this.ring = {...this.ring, angle_deg: rounded};
    void this.follow_ring(this.ring);
  }
  /** The task is what the engine says has come of the turn, in the form in which it was given. */
  private async follow_ring(ring: Ring): Promise<void> {
    const client = this.workbench.driver_client,
      before = ring.from.orientations[ring.index];
    if (!client || !before) return;
    const text = turn_text(before, ring.axis, ring.angle_deg);
    const request = async () =>
      ((await client.follow("report", {of: "orientation", text})).report as {convert: Converted}).convert;
    const taken = (convert: Converted) => {
      if (this.ring?.from !== ring.from) return;
      const after = turned(before, in_form_of(convert, without_rates(before)));
      this.orientations.put(after, convert);
      this.workbench.drag((problem) => ({
        ...problem,
        task: {...ring.from, orientations: ring.from.orientations.toSpliced(ring.index, 1, after)} as SphericalTask,
      }));
    };
    await this.ring_turned.ask(ring, request, {taken});
  }
  async leave_ring(): Promise<void> {
    await this.ring_turned.underway;
    this.ring = null;
    this.workbench.end_gesture();
  }
  drop_ring(): void {
    this.ring = null;
    this.workbench.cancel_gesture();
  }
  /** By keys: a turn at once. */
  async step_ring(axis: number, angle_deg: number): Promise<void> {
    if (this.ring) return;
    this.take_ring(axis);
    this.turn_ring(angle_deg);
    await this.leave_ring();
  }
}
function turn_text(orientation: PrescribedOrientation, about: number, angle_deg: number): string {
  const axis = [0, 1, 2].map((k) => Number(k === about));
  return JSON.stringify({orientation: without_rates(orientation), turn: {axis, angle_deg}});
}
function text_of(prescribed: PrescribedOrientation): string {
  const bare: Orientation = without_rates(prescribed);
  return JSON.stringify(bare);
}

const desks = new WeakMap<Workbench, SphericalDesk>();
export function desk_of(workbench: Workbench): SphericalDesk {
  const known = desks.get(workbench) ?? new SphericalDesk(workbench);
  desks.set(workbench, known);
  return known;
}
