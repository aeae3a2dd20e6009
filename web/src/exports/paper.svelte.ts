export type Paper = "A4" | "A3";

/** The sheet of the print view. */
class PaperChoice {
  size = $state<Paper>("A4");
}
export const paper = new PaperChoice();
