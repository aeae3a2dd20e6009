// The document as it is edited: steps and undo, gestures that become a step when they end, and what happens to a step
// that the engine refuses.
import type {Mistake, Picked} from "../contract/messages";
import {differs, from_problem, with_problem, type TaskDocument} from "./document";
import {UndoHistory} from "./history";
import {engine_text, same_question, type Pin, type Problem} from "./problem";
import type {Steps} from "./steps";

export abstract class Editing {
  document = $state.raw<TaskDocument>({problem: null as unknown as Problem, picked: null, pins: [], order: null});
  can_undo = $state(false);
  can_redo = $state(false);
  /** A drag is under way: changes are not steps yet. */
  gesture = $state(false);
  refusal = $state.raw<Mistake[] | null>(null);
  /** Counts the ways through the history, back and forth: what was typed and not taken goes with them. */
  moves = $state(0);
  /** The last step was of the task or what is required, and what became of the picked linkage is not known yet. */
  just_changed = false;

  private readonly history: UndoHistory<TaskDocument>;
  private last_good: TaskDocument;
  private good_text = ""; // what the engine read of it
  private refused: Problem | null = null;
  private readonly listeners: (() => void)[] = [];
  private readonly amended: (() => unknown)[] = [];

  /** Begins with a problem, or where a visit before left off. */
  constructor(start: Problem | Steps, now: () => number = () => performance.now()) {
    const {past, present, future} = "present" in start ? start : {past: [], present: from_problem(start), future: []};
    this.document = present;
    this.history = new UndoHistory(this.document, now, [...past], [...future]);
    [this.can_undo, this.can_redo] = [past.length > 0, future.length > 0];
    this.last_good = this.document;
  }

  /** Brings what is on screen up to the document. */
  abstract refresh(): void;

  get problem(): Problem {
    return this.document.problem;
  }
  get pins(): readonly Pin[] {
    return this.document.pins;
  }
  get picked(): Picked | null {
    return this.document.picked;
  }
  /** The map on screen is the engine's answer for the problem in force. */
  get is_current(): boolean {
    return engine_text(this.problem) === this.good_text;
  }

  /** The document with all its steps, to be kept. */
  get steps(): Steps {
    return this.history.steps;
  }

  /** Told after every committed change. */
  on_commit(listener: () => void): void {
    this.listeners.push(listener);
  }
  /** Hears of what is added to the last step. */
  on_amend(listener: () => unknown): void {
    this.amended.push(listener);
  }

  // ---- steps --------------------------------------------------------------------------------------------------

  /** One undoable step. Steps with the same `merge` label within a second are one. */
  edit(change: (problem: Problem) => Problem, merge: string | null = null): void {
    this.edit_document((document) => with_problem(document, change(document.problem)), merge);
  }
  edit_document(change: (document: TaskDocument) => TaskDocument, merge: string | null = null): void {
    const before = this.document,
      after = change(before);
    this.note_change(before, after);
    this.commit(after, merge);
  }
  private note_change(before: TaskDocument, after: TaskDocument): void {
    if (after.picked !== before.picked)
      this.just_changed = false; // it is the user's own choice
    else this.just_changed ||= !same_question(before.problem, after.problem);
  }
  undo(): void {
    this.cancel_gesture();
    ++this.moves;
    this.just_changed = false;
    this.show(this.history.undo());
    this.told();
  }
  redo(): void {
    this.cancel_gesture();
    ++this.moves;
    this.just_changed = false;
    this.show(this.history.redo());
    this.told();
  }
  protected commit(document: TaskDocument, merge: string | null = null): void {
    this.history.commit(document, merge);
    this.show(document);
    this.told();
  }
  private told(): void {
    this.can_undo = this.history.can_undo;
    this.can_redo = this.history.can_redo;
    for (const listener of this.listeners) listener();
  }
  private show(document: TaskDocument): void {
    this.document = document;
    this.keep_good();
    this.refresh();
  }

  // ---- gestures -----------------------------------------------------------------------------------------------

  begin_gesture(): void {
    this.gesture = true;
  }
  /** A change inside a gesture: shown at once, not a step. Nothing once the gesture has ended under the pointer: undone. */
  drag(change: (problem: Problem) => Problem): void {
    this.drag_document((document) => with_problem(document, change(document.problem)));
  }
  drag_document(change: (document: TaskDocument) => TaskDocument): void {
    if (this.gesture) this.show(change(this.document));
  }
  end_gesture(): void {
    if (!this.gesture) return;
    this.gesture = false;
    const kept = this.refusal && this.refused === this.problem ? this.last_good : this.document;
    this.refusal = null;
    const before = this.history.present;
    if (!differs(kept, before)) return this.show(before);
    this.just_changed = !same_question(before.problem, kept.problem);
    this.commit(kept);
  }
  cancel_gesture(): void {
    if (!this.gesture) return;
    this.gesture = false;
    this.refusal = null;
    if (this.document !== this.history.present) this.show(this.history.present);
  }

  // ---- what the engine says -----------------------------------------------------------------------------------

  /** It has read this document, which stands when a later one is refused, with what has been pinned since it was asked. */
  accept(document: TaskDocument): void {
    this.refusal = null;
    if (!same_question(document.problem, this.last_good.problem)) this.last_good = document;
    this.good_text = engine_text(document.problem);
    this.keep_good();
  }
  /** It is not asked: the document stands as it is. */
  protected accept_unread(): void {
    this.refusal = null;
    this.last_good = this.document;
  }
  /** Whether the last good document is in force instead. */
  refuse(problem: Problem, mistakes: Mistake[]): boolean {
    if (this.problem !== problem) return false;
    this.refusal = mistakes;
    this.refused = problem;
    if (this.gesture) return false; // the last good state stays on screen until the drag moves on or ends
    this.document = this.last_good;
    this.history.retract(this.last_good, (a, b) => !differs(a, b));
    this.told();
    return true;
  }
  /** What it adds to the document in force: no step. */
  amend(change: Partial<TaskDocument>): void {
    const before = this.document;
    this.document = {...before, ...change};
    this.keep_good();
    if (this.gesture || this.history.present !== before) return;
    this.history.amend(this.document);
    for (const listener of this.amended) listener();
  }
  /** Pins, pick and view are no matter of the engine's: they stay when it refuses the task. */
  private keep_good(): void {
    if (this.is_current) this.last_good = this.document;
  }
}
