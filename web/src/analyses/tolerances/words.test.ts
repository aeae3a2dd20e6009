import {describe, expect, it} from "vitest";
import type {ToleranceFigures} from "../../contract/messages";
import {figures_text} from "./figure_words";

const figures = {
  unit: "length",
  error: 0.65727,
  error_sampled: 0.9,
  beyond_first_order: false,
  worst_case: 8.23,
  yield: null,
};
const text = (change: object) => figures_text({...figures, ...change} as ToleranceFigures, "mm");

describe("what tolerances do to a linkage", () => {
  it("is told in a line", () => {
    expect(text({})).toBe("0.657 mm RMS, 8.23 mm at worst");
    expect(text({yield: 0.984})).toBe("0.657 mm RMS, 8.23 mm at worst · yield 98.4\u00a0%");
    expect(text({unit: "degrees", yield: 1})).toBe("0.657° RMS, 8.23° at worst · yield 100\u00a0%");
  });
  it("goes by the samples where the linear figure is off", () => {
    expect(text({beyond_first_order: true})).toBe("0.9 mm RMS, 8.23 mm at worst");
  });
});
