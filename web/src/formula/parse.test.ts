import {describe, expect, it} from "vitest";
import {parsed} from "./parse";

describe("a formula", () => {
  it("is a row of letters, numbers and operators", () => {
    expect(parsed("θ = 2.5°")).toEqual({
      kind: "row",
      of: [
        {kind: "letter", text: "θ"},
        {kind: "operator", text: "="},
        {kind: "number", text: "2.5°"},
      ],
    });
  });
  it("has scripts, fractions, roots, vectors and words", () => {
    const letter = (text: string) => ({kind: "letter", text});
    expect(parsed("R_{z}^2")).toEqual({kind: "both", of: [letter("R"), letter("z"), {kind: "number", text: "2"}]});
    expect(parsed("\\frac{θ}{2}")).toEqual({kind: "fraction", of: [letter("θ"), {kind: "number", text: "2"}]});
    expect(parsed("\\sqrt{a}")).toEqual({kind: "root", of: [letter("a")]});
    expect(parsed("*p*")).toEqual({kind: "vector", text: "p"});
    expect(parsed('"sin" θ')).toEqual({kind: "row", of: [{kind: "word", text: "sin"}, letter("θ")]});
  });
  it("keeps a prime or an index with its letter", () => expect(parsed("t₁")).toEqual({kind: "letter", text: "t₁"}));
  it("ends where its text ends", () => expect(parsed("a_{b")).toEqual(parsed("a_{b}")));
});
