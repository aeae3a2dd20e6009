// Formulas as they are written in a line, for MathML: `a_{x}^2`, `\frac{1}{2}`, `\sqrt{…}`, `*p*` for a vector, `"sin"` for an
// upright word, ` ; ` between two formulas, the rest letter by letter.
export type Node =
  | {kind: "row"; of: Node[]}
  | {kind: "letter" | "vector" | "number" | "operator" | "word" | "gap"; text: string}
  | {kind: "fraction" | "below" | "above"; of: [Node, Node]}
  | {kind: "both"; of: [Node, Node, Node]}
  | {kind: "root"; of: [Node]};

const token = /\s+|\\(frac|sqrt)|\*([^*\s]+)\*|"([^"]*)"|[_^{}]|[\d.]+°?|\p{L}(?:\p{M}|[′₀₁₂₃₊₋⊥])*|[^\s]/gu;

class Reader {
  private readonly tokens: RegExpMatchArray[];
  private at = 0;

  constructor(text: string) {
    this.tokens = [...text.matchAll(token)].filter(([all]) => all.trim() !== "");
  }
  row(end: string | null): Node {
    const of: Node[] = [];
    while (this.at < this.tokens.length && this.tokens[this.at]![0] !== end) of.push(this.scripted());
    if (end !== null) ++this.at;
    return of.length === 1 ? of[0]! : {kind: "row", of};
  }
  private group(): Node {
    if (this.tokens[this.at]?.[0] !== "{") return this.plain();
    ++this.at;
    return this.row("}");
  }
  private scripted(): Node {
    const base = this.plain(),
      below = this.script("_"),
      above = this.script("^");
    if (below && above) return {kind: "both", of: [base, below, above]};
    if (below) return {kind: "below", of: [base, below]};
    return above ? {kind: "above", of: [base, above]} : base;
  }
  private script(mark: string): Node | null {
    if (this.tokens[this.at]?.[0] !== mark) return null;
    ++this.at;
    return this.group();
  }
  private plain(): Node {
    const found = this.tokens[this.at++];
    if (!found) return {kind: "row", of: []};
    const [all, command, vector, word] = found;
    if (all === "{") return this.row("}");
    if (command === "frac") return {kind: "fraction", of: [this.group(), this.group()]};
    if (command === "sqrt") return {kind: "root", of: [this.group()]};
    if (vector !== undefined) return {kind: "vector", text: vector};
    if (word !== undefined) return {kind: "word", text: word};
    if (all === ";") return {kind: "gap", text: ""};
    if (/^[\d.]/.test(all)) return {kind: "number", text: all};
    return {kind: /^\p{L}/u.test(all) ? "letter" : "operator", text: all};
  }
}
export function parsed(text: string): Node {
  return new Reader(text).row(null);
}
