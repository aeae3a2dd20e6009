// What tolerances do to the linkage in hand, once it rests there: by all samples, some of which are drawn.
import type {EngineClient} from "../engine/client";
import type {Linkage, TauPair, ToleranceAnswer, ToleranceFigures} from "../engine/protocol";
import {same_tau} from "./document";
import {engine_text, type Problem} from "./problem";
import {tolerances_of} from "./tolerances";

interface Studied {
  readonly driver_client: EngineClient | null;
  readonly problem: Problem;
  readonly hovered: TauPair | null;
  readonly tau_in_hand: TauPair | null;
  readonly hand: Linkage | null;
  readonly answers: {readonly hand_is_of_present: boolean};
}
export const magnifications = [1, 10, 100] as const;
export type Magnification = (typeof magnifications)[number];

const bins = 40,
  drawn = 200;
const shortest_rest_ms = 80,
  longest_rest_ms = 600; // of the pointer, before it is worth the engine's while: as long as the last answer took

export class ToleranceStudy {
  found = $state.raw<{text: string; tau: TauPair; answer: ToleranceAnswer} | null>(null);
  /** How much larger than they are the samples' deviations are drawn; nobody is to come upon the page with them so. */
  magnification = $state<Magnification>(1);
  private took_ms = 0;
  private asked = "";
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly studied: Studied) {}

  /** It is of the very linkage in hand, made to the tolerances as they are or, for a moment, were. */
  get of_hand(): ToleranceAnswer | null {
    return this.found && same_tau(this.found.tau, this.studied.tau_in_hand) ? this.found.answer : null;
  }
  /** Of all samples, or of the few that come with the linkage. */
  get figures(): ToleranceFigures | null {
    const {problem, hand, tau_in_hand} = this.studied;
    if (!tolerances_of(problem)) return null;
    const {found} = this,
      is_of_hand = found && found.text === engine_text(problem) && same_tau(found.tau, tau_in_hand);
    return is_of_hand ? found.answer.tolerance : (hand?.tolerance ?? null);
  }

  /** The linkage in hand, or what it is made to, may be another. */
  follow(): void {
    clearTimeout(this.timer);
    const {problem, hand, hovered, tau_in_hand, answers} = this.studied;
    if (!tolerances_of(problem)) {
      this.found = null;
      this.asked = "";
      return;
    }
    if (!hand || !answers.hand_is_of_present || !same_tau(hand.tau, tau_in_hand)) return; // it comes back with it
    if (!hovered) return void this.fetch(problem, hand.tau);
    const rest_ms = Math.min(Math.max(this.took_ms, shortest_rest_ms), longest_rest_ms);
    this.timer = setTimeout(() => void this.fetch(problem, hand.tau), rest_ms);
  }
  private async fetch(problem: Problem, tau: TauPair): Promise<void> {
    const text = engine_text(problem),
      asked = text + tau.join();
    if (asked === this.asked) return;
    this.asked = asked;
    const start = performance.now(),
      reply = await this.studied.driver_client
        ?.follow("tolerance", {problem: text, tau, bins, drawn})
        .catch(() => null);
    if (this.asked !== asked) return;
    this.took_ms = performance.now() - start;
    if (!reply) this.asked = ""; // once more with the next change
    this.found = reply?.tolerance ? {text, tau, answer: reply as ToleranceAnswer} : null;
  }
}
