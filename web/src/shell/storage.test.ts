import {describe, expect, it} from "vitest";
import {with_view, type Problem} from "../state/problem";
import {new_problem} from "../tasks/motion/kind";
import {read_work, write_work, type Store} from "./storage";

function store_of(most = 1e9): Store & {items: Map<string, string>} {
  const items = new Map<string, string>();
  return {
    items,
    getItem: (key) => items.get(key) ?? null,
    setItem(key, value) {
      if (value.length > most) throw new DOMException("full", "QuotaExceededError");
      items.set(key, value);
    },
  };
}
const problem: Problem = with_view(new_problem(), {picked: [0.5, 1.25], outline: [[0, 0], [2, 0], [1, 1]], order: 3});

describe("the browser's store", () => {
  it("gives back what was kept", () => {
    const store = store_of();
    expect(write_work("work", problem, store)).toBe(true);
    expect(read_work("work", store)).toEqual(problem);
    expect(read_work("before", store)).toBeNull();
  });
  it("leaves a picture out that is too large for it", () => {
    const image = `data:image/png;base64,${"A".repeat(5000)}`;
    const store = store_of(4000);
    expect(write_work("work", with_view(problem, {background: {image, x: 0, y: 0, width: 1, aspect: 1}}), store)).toBe(true);
    expect(read_work("work", store)).toEqual(problem);
  });
  it("says when nothing can be kept", () => {
    expect(write_work("work", problem, store_of(10))).toBe(false);
    expect(write_work("work", problem, null)).toBe(false);
  });
  it.each(["", "{", "null", "[]", "{\"version\": 1}", "{\"version\": 2, \"problem\": {}}", "{\"version\":1,\"problem\":{\"linkwright\":1,\"task\":{\"kind\":\"motion\",\"mechanism\":\"four_bar\",\"poses\":[{\"x\":null}]}}}"])(
    "takes a damaged entry for none: %s", (text) => {
      const store = store_of();
      store.items.set("linkwright.work", text);
      expect(read_work("work", store)).toBeNull();
    });
});
