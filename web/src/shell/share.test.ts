import {deflateSync, strToU8} from "fflate";
import {describe, expect, it} from "vitest";
import {type Problem} from "../state/problem";
import {new_problem} from "../kinds/motion/kind";
import {check_sum, fragment_of, is_local, link_of, longest_link, read_fragment} from "./share";

const page = "https://example.org/linkwright/";
const problem: Problem = {
  ...new_problem(),
  title: '尾门 · "hinge"',
  view: {
    picked: [0.25, 1.5],
    outline: [
      [0, 0],
      [1, 0],
      [1, 1],
    ],
  },
};

function packed(text: string): string {
  const data = Buffer.from(deflateSync(strToU8(text), {level: 9})).toString("base64url");
  return `#1.${check_sum(data)}.${data}`;
}

describe("a link", () => {
  it("holds the whole problem", () => {
    const read = read_fragment(fragment_of(problem));
    expect(read).toEqual({text: JSON.stringify(problem)});
  });
  it("is short for an ordinary task", () => {
    expect(link_of(problem, page)!.length).toBeLessThan(600);
    expect(link_of(problem, page + "#old")).toBe(link_of(problem, page));
  });
  it("to this computer opens nowhere else", () => {
    for (const address of [
      "http://127.0.0.1:4179/",
      "http://localhost/",
      "http://a.localhost:8/",
      "http://[::1]:80/",
      "file:///x.html",
    ])
      expect(is_local(new URL(address)), address).toBe(true);
    for (const address of [page, "https://localhost.example.org/", "http://10.0.0.7/", "https://127.example.org/"])
      expect(is_local(new URL(address)), address).toBe(false);
  });
  it("has CRC-32 as its check sum", () => {
    expect(check_sum("123456789")).toBe("cbf43926");
  });
  it("leaves the picture out", () => {
    const with_picture: Problem = {
      ...problem,
      view: {...problem.view, background: {image: "data:image/png;base64,AAAA", x: 0, y: 0, width: 1, aspect: 1}},
    };
    expect(read_fragment(fragment_of(with_picture))).toEqual({text: JSON.stringify(problem)});
  });
  it("shows every broken character", () => {
    const fragment = fragment_of(problem);
    for (let i = 3; i < fragment.length; ++i) {
      const broken = fragment.slice(0, i) + (fragment[i] === "A" ? "B" : "A") + fragment.slice(i + 1);
      expect(read_fragment(broken), `character ${i}`).toEqual({mistake: "damaged"});
    }
  });
  it("shows that it was cut short", () => {
    const fragment = fragment_of(problem);
    for (const length of [2, 5, 12, 40, fragment.length - 1])
      expect(read_fragment(fragment.slice(0, length))).toEqual({mistake: "damaged"});
  });
  it("is nothing where there is none", () => {
    expect(read_fragment("")).toBeNull();
    expect(read_fragment("#")).toBeNull();
  });
  it("of another version says so", () => {
    expect(read_fragment("#2.abc")).toEqual({mistake: "newer"});
    expect(read_fragment("#0.abc")).toEqual({mistake: "damaged"});
  });
  it("that is too long is neither made nor read", () => {
    const notes = Array.from({length: 12_000}, () => Math.random().toString(36)).join("");
    expect(link_of({...problem, title: notes}, page)).toBeNull();
    expect(read_fragment("#1." + "A".repeat(longest_link))).toEqual({mistake: "too_long"});
  });
  it("that unpacks to more than a file may have is stopped on the way", () => {
    const bomb = packed("[".repeat(40 * 1024 * 1024));
    expect(bomb.length).toBeLessThan(longest_link);
    expect(read_fragment(bomb)).toEqual({mistake: "too_large"});
  });
});
