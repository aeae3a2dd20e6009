import {describe, expect, it} from "vitest";
import {best_of, compared, sorted_by, table_csv, type Column, type Compared} from "./compare";

const column = (name: string, angle: number | null, ratio: number, note = "") =>
  ({
    pin: {name, note, min_transmission_angle_deg: angle, link_ratio: ratio, longest: 100, lengths: null},
    linkage: null,
  }) as unknown as Column;
const columns = [column("A", 40, 3), column("B", 80, 5), column("C", null, 2)];
const names = (list: Column[]) => list.map((c) => c.pin.name).join("");

describe("compare", () => {
  it("finds the best of a row", () => {
    expect(best_of([40, 80, null], "high")).toEqual([false, true, false]);
    expect(best_of([3, 5, 2], "low")).toEqual([false, false, true]);
    expect(best_of([3, 2, 2], "low")).toEqual([false, true, true]);
    expect(best_of([2, 2], "low")).toEqual([false, false]);
    expect(best_of([2, null], "low")).toEqual([false, false]);
    expect(best_of([1, 2], undefined)).toEqual([false, false]);
  });
  it("sorts, the better first, the unknown last", () => {
    expect(names(sorted_by(columns, "min_transmission_angle_deg", false))).toBe("BAC");
    expect(names(sorted_by(columns, "min_transmission_angle_deg", true))).toBe("ABC");
    expect(names(sorted_by(columns, "link_ratio", false))).toBe("CAB");
    expect(names(sorted_by(columns, "longest", false))).toBe("ABC");
  });
  it("writes a table that a spreadsheet opens without harm", () => {
    const rows = Object.fromEntries(compared.map((key) => [key, key])) as Record<Compared, string>;
    const text = table_csv(
      [column("=A1", 40.5, 3, 'say "hi", or\nnot'), column("-x", null, 2, "-5")],
      {name: "Name", note: "Note", type: "Type", rows},
      () => "crank",
    );
    const lines = text.split("\r\n");
    expect(lines[0]).toBe("Name,'=A1,'-x");
    expect(lines[2]).toBe("min_transmission_angle_deg,40.5,");
    expect(text).toContain('Note,"say ""hi"", or\nnot",-5\r\n');
  });
});
