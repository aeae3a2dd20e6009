import fc from "fast-check";
import {afterEach, describe, expect, it, vi} from "vitest";
import {property} from "./arbitrary";
import {Preferences, speeds} from "./preferences.svelte";

const key = "linkwright.preferences";
function browser(stored: string | null = null) {
  const items = new Map(stored === null ? [] : [[key, stored]]);
  const store = {
    getItem: (name: string) => items.get(name) ?? null,
    setItem: (name: string, text: string) => void items.set(name, text),
  };
  return {opened: () => new Preferences(() => store), stored: () => JSON.parse(items.get(key)!) as object};
}
const flag = fc.boolean(),
  width = fc.integer({min: 240, max: 2000});
const all = fc.record({
  language: fc.constantFrom("en", "zh"),
  theme: fc.constantFrom("light", "dark"),
  snap: flag,
  grid: flag,
  construction: flag,
  instant: flag,
  contours: flag,
  defect_kinds: flag,
  only_meeting: flag,
  ridges: flag,
  colour_by: property,
  speed: fc.constantFrom(...speeds),
  repeat: fc.constantFrom("reverse", "loop", "once"),
  left_width: width,
  right_width: width,
  toured: flag,
  single_keys: flag,
});

afterEach(() => vi.unstubAllGlobals());

describe("preferences", () => {
  it("come back as they were", () => {
    fc.assert(
      fc.property(all, (wanted) => {
        const {opened} = browser(),
          page = Object.assign(opened(), wanted);
        page.store();
        expect({...wanted, ...opened()}).toMatchObject(wanted);
      }),
      {seed: 1},
    );
  });
  it("are read one by one: what is none of its kind leaves the default", () => {
    vi.stubGlobal("navigator", {language: "zh-CN"});
    const bad = {
      language: "fr",
      theme: 3,
      snap: "yes",
      speed: 0,
      colour_by: "<b>",
      repeat: null,
      left_width: 1e300,
      grid: false,
    };
    const {language, theme, snap, speed, colour_by, repeat, left_width, grid} = browser(JSON.stringify(bad)).opened();
    expect({language, theme, snap, speed, colour_by, repeat, left_width, grid}).toEqual({
      language: "zh",
      theme: "light",
      snap: true,
      speed: 1,
      colour_by: "type",
      repeat: "reverse",
      left_width: 268,
      grid: false,
    });
  });
  it.each(["", "{", "null", "[]", "3", '"fr"'])("are the defaults where the entry is damaged: %s", (text) => {
    vi.stubGlobal("navigator", {language: "en"});
    expect(browser(text).opened().language).toBe("en");
  });
  it("of two tabs do not undo each other", () => {
    const {opened, stored} = browser('{"of a later version": 1}'),
      one = opened(),
      two = opened();
    one.grid = false;
    one.store();
    two.speed = 2;
    two.store();
    expect(stored()).toEqual({"of a later version": 1, grid: false, speed: 2});
    two.speed = 1; // back to what the default is
    two.store();
    expect([opened().grid, opened().speed]).toEqual([false, 1]);
  });
});
