import {expect, it} from "vitest";
import type {Pin} from "../state/problem";
import {first_example} from "../gallery/gallery";
import {six_bar_kind} from "../kinds/six_bar/kind";
import {file_name, file_stem, slug} from "./names";

const pins = [{name: "B", tau: [1.25, 0.5]}] as unknown as Pin[];

it("names files by title and pin, or what the linkage is", () => {
  const {task} = first_example.problem;
  const titled = {title: "Tailgate hinge", task};
  expect(file_stem(titled, {tau: [1.25, 0.5], type: "double_crank"}, pins)).toBe("tailgate-hinge-B");
  expect(file_stem(titled, {tau: [1.3, 0.5], type: "double_crank"}, pins)).toBe("tailgate-hinge-double_crank");
  expect(file_stem({task}, null)).toBe("linkage");
  const six_bar = six_bar_kind.beginnings[0]!.make();
  expect(file_stem({title: "Loader", task: six_bar.task}, {tau: [1.3, 0.5], type: "double_crank"})).toBe(
    "loader-stephenson_3",
  );
});
it("takes of a pin's name what a file system takes, and one dot before the extension", () => {
  const stem = (name: string) =>
    file_stem({title: "Hinge", task: first_example.problem.task}, {tau: [1.25, 0.5], type: "double_crank"}, [
      {...pins[0]!, name},
    ]);
  expect(stem("lid / 2nd: try…")).toBe("hinge-lid-2nd-try");
  expect(stem("….")).toBe("hinge-double_crank");
  expect(file_name("hinge-B", ".dxf")).toBe("hinge-B.dxf");
  expect(file_name("hinge-B", "dxf")).toBe("hinge-B.dxf");
});
it("keeps letters of any script and nothing that a file system minds", () => {
  expect(slug("尾门铰链 2")).toBe("尾门铰链-2");
  expect(slug("../../etc/passwd\0")).toBe("etc-passwd");
  expect(slug("  <b>Café</b> : * ")).toBe("b-café-b");
  expect(slug("…")).toBe("linkage");
  expect(slug("x".repeat(500)).length).toBe(60);
});
