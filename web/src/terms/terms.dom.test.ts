// The words that explain themselves.
import {beforeEach, expect, test} from "vitest";
import {get, is_there, open_settled, send, text, until, until_there} from "../../tests/page/support";

const word = "type.double_rocker";
const point = (): Promise<boolean> => send(word, new PointerEvent("pointerenter", {pointerType: "mouse"}));
const leave = (): Promise<boolean> => send(word, new PointerEvent("pointerleave", {pointerType: "mouse"}));
const scroll = (what: Node): Promise<boolean> => send(what as HTMLElement, new Event("scroll"));

beforeEach(open_settled);

test("a word that is pointed at is explained", async () => {
  await point();
  await until_there("term.tip");
  expect(text("term.tip")).toContain("the coupler turns fully");
  await leave();
  await until(() => !is_there("term.tip"));
});

test("a word that is scrolled away is explained no longer; another list that scrolls does not matter", async () => {
  await point();
  await until_there("term.tip");
  await scroll(get("task.kind"));
  expect(is_there("term.tip")).toBe(true);
  await scroll(get(word).parentElement!);
  expect(is_there("term.tip")).toBe(false);
});
