// What is being looked at of orientations: the engine's word on each, and the ring that is being dragged.
import {EachOnce} from "../../questions/each_once.svelte";
import {Question} from "../../questions/question.svelte";
import {in_form_of, type Converted, type Orientation} from "../../orientation/orientation";
import {turn_of, Turning, type Turn} from "../../orientation/turning.svelte";
import type {Workbench} from "../../state/workbench.svelte";
import {
  is_spherical,
  turned,
  with_orientations,
  without_rates,
  type PrescribedOrientation,
  type SphericalTask,
} from "./task";

interface Held {
  task: SphericalTask;
  index: number;
}
const first_turn_deg = 10; // of one that is added, about z

export class SphericalDesk {
  private readonly orientations: EachOnce<PrescribedOrientation, Converted>;
  readonly turning: Turning<Held>;
  private readonly turned: Question<Turn<Held>, Converted>;
  private readonly next: Question<PrescribedOrientation, Converted>;

  constructor(private readonly workbench: Workbench) {
    this.orientations = new EachOnce(workbench, text_of, async (client, one, signal) => {
      const text = JSON.stringify({orientation: without_rates(one)}),
        {report} = await client.run({kind: "report", of: "orientation", text}, {signal});
      return (report as {convert: Converted}).convert;
    });
    this.turned = new Question(workbench.questions, {follows: true});
    this.turning = new Turning(workbench, {
      held: () => (this.task && this.selected !== null ? {task: this.task, index: this.selected} : null),
      ask: (turn) => void this.follow_turn(turn),
      question: this.turned,
    });
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
    const text = turn_text(orientation, {axis: 2, angle_deg: first_turn_deg}),
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

  /** The task is what the engine says has come of the turn, in the form in which it was given. */
  private async follow_turn(turn: Turn<Held>): Promise<void> {
    const client = this.workbench.driver_client,
      {task, index} = turn.from,
      before = task.orientations[index];
    if (!client || !before) return;
    const text = turn_text(before, turn);
    const request = async () =>
      ((await client.follow("report", {of: "orientation", text})).report as {convert: Converted}).convert;
    const taken = (convert: Converted) => {
      if (this.turning.now?.from !== turn.from) return;
      const after = turned(before, in_form_of(convert, without_rates(before)));
      this.orientations.put(after, convert);
      this.workbench.drag((problem) => ({
        ...problem,
        task: {...task, orientations: task.orientations.toSpliced(index, 1, after)} as SphericalTask,
      }));
    };
    await this.turned.ask(turn, request, {taken});
  }
}
function turn_text(orientation: PrescribedOrientation, turn: Pick<Turn<unknown>, "axis" | "angle_deg">): string {
  return JSON.stringify({orientation: without_rates(orientation), turn: turn_of(turn)});
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
