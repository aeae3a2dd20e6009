import {afterEach, describe, expect, it, vi} from "vitest";
import {preferences} from "../state/preferences.svelte";
import {notice_text, t} from "./texts.svelte";

afterEach(() => void (preferences.language = "en"));

describe("a text with a number", () => {
  it("knows one from several", () => {
    expect(t("chip.four_bars", {n: "1"})).toBe("1 four-bar");
    expect(t("chip.four_bars", {n: "1 204"})).toBe("1 204 four-bars");
    expect(t("state.too_few", {n: 1})).toMatch(/^1 position leaves /);
  });
});

describe("a notice", () => {
  const length = {
    code: "no_side_link_of_length",
    message: "as the program says it",
    values: {side: "output", length: 12.3456, nearest: 40},
  };
  it("is worded with its values", () => {
    expect(notice_text(length)).toBe(
      "No output link of length 12.3 satisfies the positions, in any direction. The nearest length that does is 40.",
    );
    preferences.language = "zh";
    expect(notice_text(length)).toBe("杆长 12.3 的输出杆在任何方向都无法通过各位置。最接近的可行杆长为 40。");
  });
  it("says nothing of what the engine did not give", () => {
    const {nearest: _, ...values} = length.values;
    expect(notice_text({...length, values})).toBe(
      "No output link of length 12.3 satisfies the positions, in any direction.",
    );
    preferences.language = "zh";
    expect(notice_text({...length, values})).toBe("杆长 12.3 的输出杆在任何方向都无法通过各位置。");
  });
  it("of an unknown code is the engine's own sentence", () => {
    expect(notice_text({...length, code: "new"})).toBe(length.message);
  });
});

describe("a language", () => {
  it("is fetched when it is wanted, and until then the one before stays", async () => {
    vi.resetModules();
    const [{preferences}, {load_texts, t}] = await Promise.all([
      import("../state/preferences.svelte"),
      import("./texts.svelte"),
    ]);
    preferences.language = "en";
    await load_texts();
    const english = t("app.bar");
    preferences.language = "zh";
    expect(t("app.bar")).toBe(english);
    await load_texts();
    expect(t("app.bar")).not.toBe(english);
    preferences.language = "en";
    expect(t("app.bar")).toBe(english);
  });
  it("that cannot be had leaves the one before", async () => {
    vi.resetModules();
    vi.doMock("./zh.json", () => {
      throw new Error("the server is gone");
    });
    const [{preferences}, {load_texts, t}] = await Promise.all([
      import("../state/preferences.svelte"),
      import("./texts.svelte"),
    ]);
    preferences.language = "en";
    expect(await load_texts()).toBe(true);
    const english = t("app.bar");
    preferences.language = "zh";
    expect(await load_texts()).toBe(false);
    expect([preferences.language, t("app.bar")]).toEqual(["en", english]);
    vi.doUnmock("./zh.json");
    vi.resetModules();
  });
});
