import {expect, it, vi} from "vitest";
import type {EngineClient} from "../engine/client";
import type {Replies} from "../engine/protocol";
import {first_example} from "../gallery/gallery";
import {Workbench} from "./workbench.svelte";

const list = (type: string) => ({linkages: [{type}]}) as unknown as Replies["best"];

it("lists the ten best of the task on screen, asking once for each task, and again where the engine drops it", async () => {
  vi.useFakeTimers();
  const workbench = new Workbench(first_example.problem),
    {best_list} = workbench;
  const replies: (() => Promise<Replies["best"]>)[] = [
    () => Promise.resolve(list("crank_rocker")),
    () => Promise.reject(new Error("superseded")),
    () => Promise.resolve(list("double_crank")),
  ];
  const request = vi.fn((_kind: string, _content: object) => replies.shift()!());
  workbench.engine = {request} as unknown as EngineClient;
  await Promise.all([best_list.fetch(), best_list.fetch()]);
  expect(request).toHaveBeenCalledTimes(1);
  expect(request.mock.calls[0]).toMatchObject(["best", {most: 10}]);
  expect(best_list.is_current).toBe(true);

  workbench.document = {...workbench.document, problem: {...workbench.problem, requirements: {max_length: 300}}};
  expect(best_list.is_current).toBe(false); // what is listed is of another task, and says so
  const fetched = best_list.fetch();
  await vi.runAllTimersAsync();
  await fetched;
  expect(request).toHaveBeenCalledTimes(3);
  expect(best_list.found?.linkages[0].type).toBe("double_crank");
  expect(best_list.is_current).toBe(true);
  vi.useRealTimers();
});
