// Formulas as they are written in a line, for MathML: `a_{x}^2`, `\frac{1}{2}`, `\sqrt{…}`, `*p*` for a vector, `"sin"` for an
// upright word, ` ; ` between two formulas, the rest letter by letter.
export type FormulaNode =
  | {kind: "row"; of: FormulaNode[]}
  | {kind: "letter" | "vector" | "number" | "operator" | "word" | "gap"; text: string}
  | {kind: "fraction" | "below" | "above"; of: [FormulaNode, FormulaNode]}
  | {kind: "both"; of: [FormulaNode, FormulaNode, FormulaNode]}
  | {kind: "root"; of: [FormulaNode]};

const token = /\s+|\\(frac|sqrt)|\*([^*\s]+)\*|"([^"]*)"|[_^{}]|[\d.]+°?|\p{L}(?:\p{M}|[′₀₁₂₃₊₋⊥])*|[^\s]/gu;

class Reader {
  private readonly tokens: RegExpMatchArray[];
  private at = 0;

  constructor(text: string) {
    this.tokens = [...text.matchAll(token)].filter(([all]) => all.trim() !== "");
  }
  row(end: string | null): FormulaNode {
    const of: FormulaNode[] = [];
    while (this.at < this.tokens.length && this.tokens[this.at]![0] !== end) of.push(this.scripted());
    if (end !== null) ++this.at;
    return of.length === 1 ? of[0]! : {kind: "row", of};
  }
  private group(): FormulaNode {
    if (this.tokens[this.at]?.[0] !== "{") return this.plain();
    ++this.at;
    return this.row("}");
  }
  private scripted(): FormulaNode {
    const base = this.plain(),
      below = this.script("_"),
      above = this.script("^");
    if (below && above) return {kind: "both", of: [base, below, above]};
    if (below) return {kind: "below", of: [base, below]};
    return above ? {kind: "above", of: [base, above]} : base;
  }
  private script(mark: string): FormulaNode | null {
    if (this.tokens[this.at]?.[0] !== mark) return null;
    ++this.at;
    return this.group();
  }
  private plain(): FormulaNode {
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
export function parsed(text: string): FormulaNode {
  return new Reader(text).row(null);
}
