import {describe, expect, it} from "vitest";
import en from "../texts/en.json";
import zh from "../texts/zh.json";
import {linkage_types, type Linkage} from "../contract/messages";
import {pictures, type Stroke} from "./pictures";
import {term_of_defects, term_of_linkage, term_of_type} from "./terms.svelte";

const names = Object.keys(pictures) as (keyof typeof pictures)[];

describe("terms", () => {
  it("have one sentence each, in both languages", () => {
    for (const texts of [en, zh] as Record<string, string>[]) {
      for (const name of names) expect(texts[`term.${name}`], name).toMatch(/[.。]$/);
      expect(Object.keys(texts).filter((key) => key.startsWith("term.") && !(key.slice(5) in pictures))).toEqual([]);
    }
  });
  it("have a picture that stays within its frame", () => {
    for (const name of names) {
      const strokes: readonly Stroke[] = pictures[name];
      expect(strokes.length, name).toBeGreaterThan(1);
      for (const [, d] of strokes) expect(d, name).toMatch(/^M-?\d/);
      const corners = strokes.flatMap(([, d]) =>
        [...d.matchAll(/[ML](-?[\d.]+) (-?[\d.]+)/g)].map(([, x, y]) => [Number(x), Number(y)]),
      );
      for (const [x, y] of corners)
        expect(x! >= -1 && x! <= 97 && y! >= -1 && y! <= 65, `${name} ${x} ${y}`).toBe(true);
    }
  });
  it("are found for every type and defect", () => {
    for (const type of linkage_types) expect(names).toContain(term_of_type(type));
    expect(term_of_type("degenerate")).toBe("slider");
    expect(term_of_linkage({type: "crank_rocker", six_bar: {topology: "stephenson_2"}} as Linkage)).toBe("stephenson");
    expect(term_of_defects({order: true, branch: true, circuit: true})).toBe("circuit_defect");
    expect(term_of_defects({order: false, branch: false, circuit: false})).toBe("no_defects");
  });
});
