import {describe, expect, it} from "vitest";
import {evaluated, type Quantity} from "./arithmetic";

const value = (text: string, quantity: Quantity = "number", unit = "") => {
  const reading = evaluated(text, quantity, unit);
  return "value" in reading ? reading.value : reading.fault;
};

describe("arithmetic", () => {
  it("reads plain numbers", () => {
    expect(value("410")).toBe(410);
    expect(value(" -12.5 ")).toBe(-12.5);
    expect(value("−12.5")).toBe(-12.5);
    expect(value(".5")).toBe(0.5);
    expect(value("5.")).toBe(5);
    expect(value("1e3")).toBe(1000);
    expect(value("2.5E-2")).toBe(0.025);
    expect(Object.is(value("-0"), 0)).toBe(true);
  });
  it("understands decimal commas and groups", () => {
    expect(value("1,5")).toBe(1.5);
    expect(value("1 234,5")).toBe(1234.5);
    expect(value("1\u202f234.5")).toBe(1234.5);
    expect(value("1.234,5")).toBe(1234.5);
    expect(value("1,234.5")).toBe(1234.5);
    expect(value("1,234")).toBe(1.234);
    expect(value("1,234,567.25")).toBe(1234567.25);
  });
  it("reads full-width digits and signs, as they are typed in Chinese", () => {
    expect(value("１２．５")).toBe(12.5);
    expect(value("－３　＊（１＋１）")).toBe(-6);
    expect(value("９０°", "angle")).toBe(90);
  });
  it("calculates", () => {
    expect(value("=410/2")).toBe(205);
    expect(value("1+2*3")).toBe(7);
    expect(value("(1+2)*3")).toBe(9);
    expect(value("-2^2")).toBe(-4);
    expect(value("2^-1")).toBe(0.5);
    expect(value("2^3^2")).toBe(512);
    expect(value("10-4-3")).toBe(3);
    expect(value("3 × 4 ÷ 2")).toBe(6);
    expect(value("2*-3")).toBe(-6);
    expect(value("pi/2")).toBeCloseTo(Math.PI / 2, 15);
  });
  it("converts angles, and only angles", () => {
    expect(value("95deg", "angle")).toBe(95);
    expect(value("95°", "angle")).toBe(95);
    expect(value("0.5rad", "angle")).toBeCloseTo(28.64788975654116, 12);
    expect(value("pi rad", "angle")).toBeCloseTo(180, 12);
    expect(value("pi/2", "angle")).toBeCloseTo(Math.PI / 2, 12);
    expect(value("-(10deg + 0,5rad)", "angle")).toBeCloseTo(-38.64788975654116, 12);
    expect(value("95deg", "length")).toBe("not_a_number");
  });
  it("takes the unit of lengths", () => {
    expect(value("250 mm", "length", "mm")).toBe(250);
    expect(value("250mm/2", "length", "mm")).toBe(125);
    expect(value("250 in", "length", "mm")).toBe("not_a_number");
  });
  it("says what is wrong", () => {
    expect(value("")).toBe("empty");
    expect(value(" = ")).toBe("empty");
    for (const text of [
      "abc",
      "1+",
      "1//2",
      "(1",
      "1)",
      "1 2",
      "0/0",
      "NaN",
      "1,2,3",
      "--",
      "1;2",
      "alert(1)",
      "__proto__",
      "5 constructor",
    ]) {
      expect(value(text, "angle"), text).toBe("not_a_number");
    }
    expect(value("1e10")).toBe("out_of_range");
    expect(value("1/0")).toBe("out_of_range");
    expect(value("1e999")).toBe("out_of_range");
  });
});
