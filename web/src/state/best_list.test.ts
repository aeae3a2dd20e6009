import {expect, it, vi} from "vitest";
import {Cancelled, Crashed, type EngineClient, type Job, type Run} from "../engine/client";
import type {Replies} from "../contract/messages";
import {examples, first_example} from "../gallery/gallery";
import {Workbench} from "./workbench.svelte";

const list = (type: string) => ({linkages: [{type}]}) as unknown as Replies["best"];

it("lists the ten best of the task on screen, asking once for each task, and again where the engine has failed", async () => {
  const workbench = new Workbench(first_example.problem),
    {best_list} = workbench;
  const replies: (() => Promise<Replies["best"]>)[] = [
    () => Promise.resolve(list("crank_rocker")),
    () => Promise.reject(new Crashed("killed")),
    () => Promise.resolve(list("double_crank")),
  ];
  const run = vi.fn((_job: Job<"best">, _run: Run<"best">) => replies.shift()!());
  workbench.engine = {run} as unknown as EngineClient;
  const both = Promise.all([best_list.fetch(), best_list.fetch()]);
  expect(best_list.busy).toBe(true);
  await both;
  expect(best_list.busy).toBe(false);
  expect(run).toHaveBeenCalledTimes(1);
  expect(run.mock.calls[0]).toMatchObject([{kind: "best", most: 10}, {}]);
  expect(best_list.is_current).toBe(true);

  workbench.document = {...workbench.document, problem: {...workbench.problem, requirements: {max_length: 300}}};
  expect(best_list.is_current).toBe(false); // what is listed is of another task, and says so
  await best_list.fetch();
  expect(best_list.is_current).toBe(false);
  await best_list.fetch();
  expect(run).toHaveBeenCalledTimes(3);
  expect(best_list.found?.linkages[0]!.type).toBe("double_crank");
  expect(best_list.is_current).toBe(true);
});

it("lets the list of an earlier task go for that of the present one", async () => {
  const workbench = new Workbench(first_example.problem),
    {best_list} = workbench,
    stopped: boolean[] = [];
  const run = (_job: Job<"best">, {signal}: Run<"best">) =>
    new Promise<Replies["best"]>((_, reject) =>
      signal!.addEventListener("abort", () => reject((stopped.push(true), new Cancelled()))),
    );
  workbench.engine = {run} as unknown as EngineClient;
  const first = best_list.fetch();
  workbench.document = {...workbench.document, problem: {...workbench.problem, requirements: {max_length: 300}}};
  best_list.let_go();
  expect(best_list.busy).toBe(false);
  void best_list.fetch();
  await first;
  best_list.let_go(); // this one is for what is on screen
  expect(best_list.busy).toBe(true);
  expect(stopped).toEqual([true]);
  expect(best_list.found).toBeNull();
});

it("does not keep the list of another task, while that of the same task stays until the next is there", async () => {
  const workbench = new Workbench(first_example.problem),
    {best_list} = workbench;
  const follow = () => new Promise(() => {}),
    run = () => Promise.resolve(list("crank_rocker"));
  workbench.engine = {run, follow} as unknown as EngineClient;
  await best_list.fetch();
  workbench.edit((problem) => ({...problem, requirements: {max_length: 300}}));
  expect(best_list.is_current).toBe(false);
  expect(best_list.found).not.toBeNull();
  const search = examples.find(({name}) => name === "straight_search")!.problem;
  workbench.open(search);
  expect(best_list.found).toBeNull();
  workbench.undo();
  expect(best_list.found).toBeNull();
  await best_list.fetch();
  expect(best_list.found).not.toBeNull();
  workbench.open({...first_example.problem, title: "another of the same kind"});
  expect(best_list.found).toBeNull();
});
