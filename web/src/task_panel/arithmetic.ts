// What a person types where a number belongs: "410", "=410/2", "1 234,5", "95deg", "0.5rad", "250 mm".

export type Quantity = "length" | "angle" | "number";
export type Fault = "empty" | "not_a_number" | "out_of_range";
export type Reading = {value: number} | {fault: Fault};

/** Engine and files take no larger coordinates and angles. */
export const largest_number = 1e9;

const degrees_per: Record<string, number> = {deg: 1, "°": 1, º: 1, rad: 180 / Math.PI};

/** The value in degrees (angles) or in the user's unit (lengths). A comma is a decimal comma unless both comma and
 *  point occur: then the last of them is decimal and the others group. */
export function evaluated(text: string, quantity: Quantity = "number", unit = ""): Reading {
  const value = plain.test(text) ? Number(text.replace(",", ".")) : calculated(normalised(text), quantity, unit);
  if (value === undefined) return {fault: "empty"};
  if (value === null || Number.isNaN(value)) return {fault: "not_a_number"};
  return Math.abs(value) <= largest_number ? {value: value === 0 ? 0 : value} : {fault: "out_of_range"};
}

/** What most numbers of a long table are: they need no reading. */
const plain = /^[-+]?(?:\d+[.,]?\d*|[.,]\d+)(?:[eE][-+]?\d+)?$/;

function calculated(source: string, quantity: Quantity, unit: string): number | null | undefined {
  if (source === "") return undefined;
  const tokens = tokens_of(source);
  return tokens && new Expression(tokens, quantity, unit.trim().toLowerCase()).value();
}
/** As Chinese input methods write digits and signs: the same of ASCII. */
function half_width(wide: string): string {
  return String.fromCharCode(wide.charCodeAt(0) - 0xfee0);
}
function normalised(text: string): string {
  return text
    .replace(/[\uff01-\uff5e]/g, half_width)
    .replaceAll("\u3000", " ")
    .trim()
    .replace(/^=/, "")
    .replace(/[\u2212\u2013]/g, "-")
    .replace(/[×·∙]/g, "*")
    .replace(/[÷∶]/g, "/")
    .replace(/(\d)[ \u00a0\u2009\u202f'’](?=\d{3}(?!\d))/g, "$1")
    .replace(/\d{1,3}(?:,\d{3})+\.\d*/g, (grouped) => grouped.replaceAll(",", ""))
    .replace(/\d{1,3}(?:\.\d{3})+,\d*/g, (grouped) => grouped.replaceAll(".", ""))
    .trim();
}

type Token = {number: number} | {sign: string} | {word: string};

function tokens_of(source: string): Token[] | null {
  const pattern = /\s*(?:((?:\d+(?:[.,]\d*)?|[.,]\d+)(?:[eE][+-]?\d+)?)|([-+*/^()])|([^\s\d.,()*/^+-]+))/y;
  const tokens: Token[] = [];
  while (pattern.lastIndex < source.length) {
    const match = pattern.exec(source);
    if (!match) return null;
    if (match[1] !== undefined) tokens.push({number: Number(match[1].replace(",", "."))});
    else if (match[2] !== undefined) tokens.push({sign: match[2]});
    else tokens.push({word: match[3]!.toLowerCase()}); // one of the three
  }
  return tokens;
}

/** Sums of products of powers; null where the tokens make no sense. */
class Expression {
  private at = 0;

  constructor(
    private readonly tokens: readonly Token[],
    private readonly quantity: Quantity,
    private readonly unit: string,
  ) {}

  value(): number | null {
    const value = this.sum();
    return this.at === this.tokens.length ? value : null;
  }
  private takes(signs: string): string | null {
    const token = this.tokens[this.at];
    if (!token || !("sign" in token) || !signs.includes(token.sign)) return null;
    ++this.at;
    return token.sign;
  }
  private sum(): number | null {
    let value = this.product();
    for (let sign = this.takes("+-"); sign && value !== null; sign = this.takes("+-")) {
      const next = this.product();
      value = next === null ? null : sign === "+" ? value + next : value - next;
    }
    return value;
  }
  private product(): number | null {
    let value = this.signed();
    for (let sign = this.takes("*/"); sign && value !== null; sign = this.takes("*/")) {
      const next = this.signed();
      value = next === null ? null : sign === "*" ? value * next : value / next;
    }
    return value;
  }
  private signed(): number | null {
    const sign = this.takes("+-");
    if (!sign) return this.power();
    const value = this.signed();
    return value === null ? null : sign === "-" ? -value : value;
  }
  private power(): number | null {
    const base = this.measured();
    if (base === null || !this.takes("^")) return base;
    const exponent = this.signed();
    return exponent === null ? null : base ** exponent;
  }
  private measured(): number | null {
    const value = this.atom(),
      token = this.tokens[this.at];
    if (value === null || !token || !("word" in token)) return value;
    ++this.at;
    const degrees = this.quantity === "angle" ? degrees_per[token.word] : undefined;
    if (degrees !== undefined) return value * degrees;
    return this.quantity === "length" && this.unit !== "" && token.word === this.unit ? value : null;
  }
  private atom(): number | null {
    const token = this.tokens[this.at];
    if (this.takes("(")) {
      const value = this.sum();
      return this.takes(")") ? value : null;
    }
    ++this.at;
    if (token && "number" in token) return token.number;
    return token && "word" in token && (token.word === "pi" || token.word === "π") ? Math.PI : null;
  }
}
