/** Which of the cognates of the linkage in hand is drawn beside it; null: none. */
class ShownCognate {
  index = $state<number | null>(null);

  toggle(index: number): void {
    this.index = this.index === index ? null : index;
  }
}
export const shown_cognate = new ShownCognate();
