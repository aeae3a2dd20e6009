import {describe, expect, it} from "vitest";
import type {TextKey} from "../texts/texts.svelte";
import {after_change, with_toast, type Toast} from "./toasts";

const toast = (key: TextKey, action?: TextKey): Toast => ({
  id: 0,
  key,
  values: {},
  action: action && {key: action, run() {}},
});
const said = (...keys: TextKey[]) =>
  keys.reduce<Toast[]>((all, key) => with_toast(all, toast(key)), []).map(({key}) => key);

describe("toasts", () => {
  it("do not contradict each other", () => {
    expect(said("state.went_to_best", "state.nothing_to_go_to")).toEqual(["state.nothing_to_go_to"]);
    expect(said("state.link_copied", "state.local_link")).toEqual(["state.local_link"]);
    expect(said("state.engine_stopped", "state.pinned", "state.engine_gave_up")).toEqual([
      "state.pinned",
      "state.engine_gave_up",
    ]);
  });
  it("are three at most, of different things", () => {
    expect(said("state.link_copied", "state.pinned", "state.exported", "file.opened")).toEqual([
      "state.pinned",
      "state.exported",
      "file.opened",
    ]);
  });
  it("go with the state of which they spoke, and never undo another step than they meant", () => {
    const all = [
      toast("state.pinned", "edit.undo"),
      toast("file.opened", "edit.undo"),
      toast("state.cannot_improve"),
      toast("state.exported"),
      toast("state.engine_gave_up", "state.again"),
    ];
    expect(after_change(all).map(({key}) => key)).toEqual(["state.exported", "state.engine_gave_up"]);
  });
});
