import {readdirSync, readFileSync} from "node:fs";
import {join} from "node:path";
import {describe, expect, it} from "vitest";
import en from "../src/texts/en.json";
import zh from "../src/texts/zh.json";

const source_folder = join(import.meta.dirname, "../src");
const sources = readdirSync(source_folder, {recursive: true, encoding: "utf8"}).filter(
  (name) => /\.(ts|svelte)$/.test(name) && !name.endsWith(".test.ts"),
);
const code = sources.map((name) => readFileSync(join(source_folder, name), "utf8")).join("\n");
const english: Record<string, string> = en,
  chinese: Record<string, string> = zh;
const placeholders = (text: string) => [...text.matchAll(/\{(\w*)\}/g)].map((match) => match[1]).sort();
const without_placeholders = (text: string) => text.replace(/\{\w+(:[^{}|]+\|[^{}|]+)?\}/g, "");

const shows_json = (key: string) => /^(mistake|word)\./.test(key);

describe("texts", () => {
  it("have the same keys in both languages", () => {
    expect(Object.keys(zh).sort()).toEqual(Object.keys(en).sort());
  });

  it("have the same placeholders in both languages", () => {
    for (const key of Object.keys(en))
      expect([key, ...placeholders(chinese[key]!)]).toEqual([key, ...placeholders(english[key]!)]);
  });

  it("are written out", () => {
    for (const [key, text] of [...Object.entries(en), ...Object.entries(zh)]) {
      expect(text.trim(), key).not.toBe("");
      if (!shows_json(key)) expect(without_placeholders(text), key).not.toMatch(/[{}]/);
    }
  });

  it("are in their language", () => {
    const without_words = ["view.language"]; // says the other language's name
    const latin_only = Object.entries(chinese).filter(
      ([key, text]) =>
        !without_words.includes(key) && text === english[key] && /[a-z]{4}/i.test(without_placeholders(text)),
    );
    expect(latin_only).toEqual([]);
    const han_in_english = Object.entries(english).filter(
      ([key, text]) => !without_words.includes(key) && /\p{Script=Han}/u.test(text),
    );
    expect(han_in_english).toEqual([]);
  });

  it("exist wherever the page asks for one", () => {
    const asked = [...code.matchAll(/\bt\(\s*"([^"]+)"|\bsay\(\s*"([^"]+)"|\bkey: "([a-z]+\.[a-z_]+)"/g)].map(
      (match) => match[1] ?? match[2] ?? match[3],
    );
    expect(asked.length).toBeGreaterThan(0);
    expect(asked.filter((key) => !(key! in en))).toEqual([]);
  });
});
