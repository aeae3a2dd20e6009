import {describe, expect, it} from "vitest";
import en from "../texts/en.json";
import zh from "../texts/zh.json";
import {preferences} from "../state/preferences.svelte";
import {is_key, key_groups} from "./keyboard";
import {begins_no_number, may_act} from "./single_keys";

function press(key: string, ...held: ("ctrl" | "meta" | "shift" | "alt")[]) {
  return {
    key,
    ctrlKey: held.includes("ctrl"),
    metaKey: held.includes("meta"),
    shiftKey: held.includes("shift"),
    altKey: held.includes("alt"),
  };
}

describe("a key", () => {
  it("is told from others by what is held", () => {
    expect(is_key(press("z", "ctrl"), "Ctrl+Z")).toBe(true);
    expect(is_key(press("z", "meta"), "Ctrl+Z")).toBe(true);
    expect(is_key(press("Z", "ctrl", "shift"), "Ctrl+Z")).toBe(false);
    expect(is_key(press("Z", "ctrl", "shift"), "Ctrl+Shift+Z")).toBe(true);
    expect(is_key(press("z"), "Ctrl+Z")).toBe(false);
    expect(is_key(press("s", "ctrl"), "S")).toBe(false);
    expect(is_key(press("s", "alt"), "S")).toBe(false);
    expect(is_key(press("S", "shift"), "S")).toBe(false);
  });
  it("has a name where it has no letter", () => {
    expect(is_key(press(" "), "Space")).toBe(true);
    expect(is_key(press("ArrowRight"), "→")).toBe(true);
    expect(is_key(press("ArrowRight", "shift"), "→")).toBe(false);
    expect(is_key(press("ArrowRight", "shift"), "Shift+→")).toBe(true);
    expect(is_key(press("Escape"), "Esc")).toBe(true);
  });
  it("that is a sign is meant wherever the keyboard has it", () => {
    expect(is_key(press("?", "shift"), "?")).toBe(true);
    expect(is_key(press("?"), "?")).toBe(true);
    expect(is_key(press("/"), "?")).toBe(false);
  });
});

describe("a key of one character", () => {
  const inside = {closest: () => ({})} as unknown as Element,
    outside = {closest: () => null} as unknown as Element;
  it("acts in the drawing and on the map only where the user has said so", () => {
    for (const on of [true, false]) {
      preferences.single_keys = on;
      expect(
        [press("b"), press("?", "shift"), press("0")].map((key) => [
          may_act(key, inside),
          may_act(key, outside),
          may_act(key, null),
        ]),
      ).toEqual(Array(3).fill([true, on, on]));
      for (const key of [press(" "), press("ArrowLeft"), press("Escape"), press("z", "ctrl"), press("s", "meta")])
        expect(may_act(key, null)).toBe(true);
    }
    preferences.single_keys = true;
  });
  it("is none of a number's, unless a number, a formula or π begins with it", () => {
    expect([..."bcfhimnrstxBX?"].filter((key) => !begins_no_number(press(key)))).toEqual([]);
    expect([..."0123456789+-=.,(pπ "].filter((key) => begins_no_number(press(key)))).toEqual([]);
    expect(begins_no_number(press("a", "ctrl"))).toBe(false);
  });
});

describe("the table of keys", () => {
  it("gives every key one meaning", () => {
    const keys = key_groups
      .flatMap((g) => g.entries)
      .filter((e) => e.run)
      .flatMap((e) => e.keys);
    expect(new Set(keys).size).toBe(keys.length);
  });
  it("has words for every entry in both languages", () => {
    for (const {title, entries} of key_groups)
      for (const key of [title, ...entries.map((e) => e.text)]) {
        expect(en).toHaveProperty([key]);
        expect(zh).toHaveProperty([key]);
      }
  });
});
