// What is being looked at of an attitude, how far it is played, and the engine's answer, which follows both.
import {Question} from "../../questions/question.svelte";
import {in_form_of} from "../../orientation/orientation";
import {turn_of, Turning} from "../../orientation/turning.svelte";
import type {Workbench} from "../../state/workbench.svelte";
import {prefers_stillness} from "../../transport/play";
import type {AttitudeReply} from "./reply";
import {is_attitude, type AttitudeTask} from "./task";

export const sections = ["forms", "turns", "rotation", "screw", "rates"] as const;
export type Section = (typeof sections)[number];
type Played = "turns" | "rotation" | "screw";
export const played_to: Record<Played, number> = {turns: 3, rotation: 1, screw: 1};
const ms_each = 1400;

export class AttitudeDesk {
  section = $state<Section>("forms");
  /** How far each is played: turns, and shares of one. */
  at = $state.raw<Record<Played, number>>({...played_to});
  playing = $state(false);
  readonly turning: Turning<AttitudeTask>;
  /** By the text that the engine is given. */
  private readonly question: Question<string, AttitudeReply>;

  constructor(private readonly workbench: Workbench) {
    this.question = new Question(workbench.questions, {follows: true});
    this.turning = new Turning(workbench, {held: () => this.task, ask: () => this.follow(), question: this.question});
  }

  get reply(): AttitudeReply | null {
    return this.question.value;
  }
  get task(): AttitudeTask | null {
    const {task} = this.workbench.problem;
    return is_attitude(task) ? task : null;
  }
  get played(): Played | null {
    const {section} = this;
    return section === "forms" || section === "rates" ? null : section;
  }
  /** An edit of the task: a step. */
  change(change: Partial<AttitudeTask>, merge: string | null = null): void {
    this.workbench.edit((problem) => ({...problem, task: {...problem.task, ...change}}), merge);
  }

  // ---- the engine -----------------------------------------------------------------------------------------------------

  private get asked(): string | null {
    const {task, at} = this,
      {now} = this.turning;
    if (!task) return null;
    return JSON.stringify({...(now?.from ?? task), at, ...(now ? {turn: turn_of(now)} : {})});
  }
  /** Asks for what is to be shown, if that is something else: to be called where task, ring and play are followed. */
  follow(): void {
    const {question, workbench} = this,
      {now} = this.turning,
      {document, driver_client} = workbench,
      text = this.asked;
    if (!text || !driver_client) return;
    if (question.is_of(text)) return question.drop();
    const request = async () => (await driver_client.follow("report", {of: "attitude", text})).report as AttitudeReply;
    void question.ask(text, request, {
      taken: (reply) => {
        if (!now) workbench.accept(document);
        else this.show_turned(reply);
      },
      refused: ({mistakes}) => {
        if (workbench.refuse(document.problem, mistakes) && !this.task) workbench.refresh(); // back to another kind
      },
    });
  }

  /** The task is what the engine says has come of the turn, in the form in which it was given. */
  private show_turned({convert}: AttitudeReply): void {
    const turn = this.turning.now;
    if (!turn) return;
    const orientation = in_form_of(convert, turn.from.orientation);
    this.workbench.drag((problem) => ({...problem, task: {...problem.task, orientation} as AttitudeTask}));
  }

  // ---- play -----------------------------------------------------------------------------------------------------------

  go_to(share: number): void {
    const {played} = this;
    if (played) this.at = {...this.at, [played]: Math.min(Math.max(share, 0), played_to[played])};
  }
  play(): void {
    const {played} = this;
    if (!played) return;
    this.playing = !this.playing;
    if (this.playing && this.at[played] >= played_to[played]) this.go_to(0);
  }
  /** The loop behind ▶; returns how to end it. */
  run(): () => void {
    let before: number | null = null,
      handle = 0;
    const frame = (now: number) => {
      const {played} = this;
      if (!played || !this.playing) return void (this.playing = false);
      const step = before === null ? 0 : Math.min(now - before, 200) / (ms_each * (played === "turns" ? 1 : 1.6));
      before = now;
      this.go_to(prefers_stillness() ? Math.floor(this.at[played] + 1) : this.at[played] + step);
      if (this.at[played] >= played_to[played]) this.playing = false;
      else handle = requestAnimationFrame(frame);
    };
    handle = requestAnimationFrame(frame);
    return () => cancelAnimationFrame(handle);
  }
}

const desks = new WeakMap<Workbench, AttitudeDesk>();
export function desk_of(workbench: Workbench): AttitudeDesk {
  const known = desks.get(workbench) ?? new AttitudeDesk(workbench);
  desks.set(workbench, known);
  return known;
}
