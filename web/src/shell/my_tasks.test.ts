import {describe, expect, it} from "vitest";
import type {Linkage, MapAnswer} from "../contract/messages";
import {first_example} from "../gallery/gallery";
import {Workbench} from "../state/workbench.svelte";
import {with_pose} from "../kinds/kind_dispatch";
import {keep_task, my_tasks, picture_of, put_task, remove_task} from "./my_tasks";
import type {Store} from "./storage";

function store_of(): Store & {items: Map<string, string>} {
  const items = new Map<string, string>();
  return {
    items,
    get length() {
      return items.size;
    },
    key: (i) => [...items.keys()][i] ?? null,
    getItem: (key) => items.get(key) ?? null,
    removeItem: (key) => void items.delete(key),
    setItem: (key, text) => void items.set(key, text),
  };
}
const map = {
  rows: 200,
  columns: 100,
  type: Uint8Array.from({length: 20_000}, (_, cell) => Math.floor(cell / 100) % 7),
  fails: Uint32Array.from({length: 20_000}, (_, cell) => cell % 300),
} as MapAnswer;
const linkage = {
  tau: [0.5, 1.5],
  type: "crank_rocker",
  input: {center: [0, 0], circle: [0, 50]},
  output: {center: [100, 0], circle: [100, 80]},
} as unknown as Linkage;

describe("the user's own tasks", () => {
  it("are kept when they are his own, each once, the last first", async () => {
    const store = store_of(),
      workbench = new Workbench(first_example.problem);
    await keep_task(workbench, store, 1);
    expect(my_tasks(store)).toEqual([]); // an example as it is
    workbench.edit((problem) => with_pose({...problem, title: "Hatch"}, 1, {x: -130}));
    await keep_task(workbench, store, 2);
    workbench.edit((problem) => with_pose({...problem, title: "Other"}, 1, {x: -140}));
    await keep_task(workbench, store, 3);
    expect(my_tasks(store).map(({problem, at}) => [problem.title, at])).toEqual([
      ["Other", 3],
      ["Hatch", 2],
    ]);
    workbench.undo();
    await keep_task(workbench, store, 4);
    expect(my_tasks(store).map(({problem, at}) => [problem.title, at])).toEqual([
      ["Hatch", 4],
      ["Other", 3],
    ]);
    for (let i = 0; i < 70; ++i) {
      workbench.edit((problem) => with_pose(problem, 1, {x: -200 - i}));
      await keep_task(workbench, store, 10 + i);
    }
    expect(my_tasks(store)).toHaveLength(60);
    expect(my_tasks(store)[0]!.at).toBe(79);
  });
  it("are renamed, deleted and put back as they were", async () => {
    const store = store_of(),
      picture = picture_of(map, linkage);
    await put_task({key: "linkwright.task.a", at: 7, problem: first_example.problem, picture}, store);
    const [task] = my_tasks(store);
    expect(task).toEqual({
      key: "linkwright.task.a",
      at: 7,
      problem: expect.objectContaining({task: first_example.problem.task}),
      picture,
    });
    await put_task({...task!, problem: {...task!.problem, title: "Renamed"}}, store);
    expect(my_tasks(store).map(({problem}) => problem.title)).toEqual(["Renamed"]);
    remove_task(task!, store);
    expect(my_tasks(store)).toEqual([]);
    await put_task(task!, store);
    expect(my_tasks(store)).toEqual([task]);
  });
  it("have pictures in small of their map and linkage", () => {
    const picture = picture_of(map, linkage);
    expect([picture.rows, picture.columns, picture.type.length]).toEqual([64, 64, 4096]);
    const row = 10,
      column = 20,
      from = 100 * Math.floor(((row + 0.5) * 200) / 64) + Math.floor(((column + 0.5) * 100) / 64);
    expect([picture.type[row * 64 + column], picture.fails[row * 64 + column]]).toEqual([
      map.type[from],
      map.fails[from],
    ]);
    expect(picture.linkage?.pivots).toEqual([
      [0, 0],
      [0, 50],
      [100, 0],
      [100, 80],
    ]);
    expect(picture_of(null, null)).toMatchObject({rows: 0, linkage: null});
  });
  it("that are damaged are left out", async () => {
    const store = store_of();
    await put_task({key: "linkwright.task.a", at: 7, problem: first_example.problem, picture: null}, store);
    store.items.set("linkwright.task.b", "{");
    store.items.set("linkwright.task.c", '{"version":1,"at":9,"problem":{}}');
    expect(my_tasks(store).map(({key}) => key)).toEqual(["linkwright.task.a"]);
  });
});
