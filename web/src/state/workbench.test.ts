// The one state: what it holds, step by step. The engine behind it is the real one.
import {describe, expect, it} from "vitest";
import {targets} from "../exports/take_away";
import {examples, first_example} from "../gallery/gallery";
import {pinned_in} from "../pins/pinned_in";
import {each_linkage} from "./each_linkage";
import {with_options, with_requirements, type Problem} from "./problem";
import {fresh_function, function_kind} from "../kinds/function/kind";
import {pairs_of, with_named} from "../kinds/function/pairs";
import {new_problem} from "../kinds/motion/kind";
import {poses_of} from "./task";
import {with_pose} from "../kinds/kind_dispatch";
import {bench, digest, settled, until} from "./workbench_bench";

const tailgate = first_example.problem;

describe("the workbench", () => {
  it("starts with the best linkage in hand", async () => {
    const b = bench(tailgate);
    await settled(b);
    expect(b.workbench.can_undo).toBe(false);
    expect(b.workbench.census!.meeting).toBe(25608);
    expect(b.workbench.hand!.min_transmission_angle_deg).toBeCloseTo(83.7, 1);
    await until(() => b.workbench.verified?.verified);
  });

  it("starts with the best linkage of a task that came while the first one's was sought", async () => {
    const b = bench(tailgate),
      other = examples.find(({name}) => name === "log_generator")!.problem;
    b.machine.late_ms.best = 1500; // later than any map
    await until(() => b.asked.some(({kind}) => kind === "best"));
    b.workbench.open(other);
    await settled(b);
    expect(b.workbench.problem.title).toBe(other.title);
    expect(b.workbench.hand!.function).toBeDefined();
  });

  it("says that the best is sought from the moment a map is there until it is picked", async () => {
    const b = bench(tailgate),
      {workbench} = b;
    b.machine.late_ms.best = 200;
    await until(() => workbench.is_current);
    expect([workbench.seeker.seeking, workbench.picked]).toEqual([true, null]);
    await until(() => !workbench.seeker.seeking);
    expect(workbench.picked).not.toBeNull();
    await settled(b);
  });

  it("brings back a pin of pairs from a named function, whose objective pairs have not", async () => {
    const pairs = function_kind.beginnings[0]!.make(),
      b = bench(pairs),
      {workbench} = b;
    await settled(b);
    workbench.pin();
    const [pin] = workbench.pins;
    workbench.edit((problem) =>
      with_options(with_named(problem, fresh_function(pairs_of(workbench))), {objective: "structural_error"}),
    );
    await until(() => workbench.is_current);
    const linkages = each_linkage(workbench),
      pinned = pinned_in(workbench.problem, pin!);
    await linkages.want([pinned]);
    expect(linkages.value_of(pinned)?.lengths).toEqual(pin!.lengths);
    const {problem} = targets(workbench).find((target) => target.pin === pin!.name)!;
    expect(problem).toMatchObject({task: pairs.task, options: {}});
    workbench.pick_pin(pin!);
    await until(() => workbench.is_current || workbench.refusal);
    expect(workbench.refusal).toBeNull();
    expect(workbench.problem.task).toEqual(pairs.task);
    expect(workbench.problem.options).toEqual({});
    await settled(b);
    workbench.undo();
    expect(workbench.problem.options?.objective).toBe("structural_error");
  });

  it("makes one step of a drag, and undo brings back everything to the last bit", async () => {
    const b = bench(tailgate),
      {workbench} = b;
    await settled(b);
    const before = digest(b);
    workbench.begin_gesture();
    for (let i = 1; i <= 8; ++i) {
      workbench.drag((problem) => with_pose(problem, 2, {x: -220 + 2 * i, y: 220 - i}));
      await new Promise((resolve) => setTimeout(resolve, 15));
    }
    workbench.end_gesture();
    await settled(b);
    const after = digest(b);
    expect(after).not.toBe(before);
    expect(workbench.picked!.place).toEqual(JSON.parse(before)[0].picked.place); // it stays in place on the map
    workbench.undo();
    await settled(b);
    expect(digest(b)).toBe(before);
    expect(workbench.can_undo).toBe(false);
    workbench.redo();
    await settled(b);
    expect(digest(b)).toBe(after);
  });

  it("leaves no step where a drag ends where it began, or is cancelled", async () => {
    const b = bench(tailgate),
      {workbench} = b;
    await settled(b);
    const before = digest(b);
    workbench.begin_gesture();
    workbench.drag((problem) => with_pose(problem, 1, {x: -100}));
    workbench.drag((problem) => with_pose(problem, 1, {x: -125}));
    workbench.end_gesture();
    workbench.begin_gesture();
    workbench.drag((problem) => with_pose(problem, 1, {x: -90}));
    workbench.cancel_gesture();
    await settled(b);
    expect(digest(b)).toBe(before);
    expect(workbench.can_undo).toBe(false);
  });

  it("keeps the last good state when a drag ends where the engine refuses", async () => {
    const b = bench(tailgate),
      {workbench} = b,
      poses = poses_of(tailgate.task);
    await settled(b);
    workbench.begin_gesture();
    workbench.drag((problem) => with_pose(problem, 2, {x: -222}));
    await until(() => workbench.is_current);
    workbench.drag((problem) => with_pose(problem, 2, {...poses[1]}));
    await until(() => workbench.refusal !== null);
    expect(workbench.refusal![0]!.code).toBe("repeated_pose");
    expect(workbench.map).not.toBeNull();
    workbench.end_gesture();
    await settled(b);
    expect(poses_of(workbench.problem.task)[2]!.x).toBe(-222);
    expect(workbench.refusal).toBeNull();
    workbench.undo();
    expect(poses_of(workbench.problem.task)[2]!.x).toBe(-220);
    expect(workbench.can_undo).toBe(false);
  });

  it("takes back a typed value that the engine refuses, and only that", async () => {
    const b = bench(tailgate),
      {workbench} = b;
    await settled(b);
    workbench.pin();
    expect(workbench.pins.length).toBe(1);
    workbench.edit((problem) => with_pose(problem, 2, {...poses_of(tailgate.task)[1]}));
    await until(() => workbench.refusal !== null);
    expect(poses_of(workbench.problem.task)).toEqual(poses_of(tailgate.task));
    expect(workbench.pins.length).toBe(1);
    workbench.undo();
    expect(workbench.pins.length).toBe(0); // the pin was the last step: the refused one left none
    expect(workbench.can_undo).toBe(false);
  });

  it("leaves a linkage that a change has cost for the best, says so, and undo brings it back", async () => {
    const b = bench(tailgate),
      {workbench} = b,
      keys = () => workbench.toasts.map(({key}) => key);
    await settled(b);
    const picked = workbench.picked!.tau,
      longest = workbench.picked_linkage!.longest!;
    const limit = (max_length: number) => workbench.edit((problem) => with_requirements(problem, {max_length}));
    limit(Math.ceil(longest) + 1); // it still does
    await settled(b);
    await new Promise((resolve) => setTimeout(resolve, 500));
    expect([workbench.picked!.tau, keys()]).toEqual([picked, []]);
    limit(Math.floor(longest) - 1);
    await until(() => keys().includes("state.went_to_best"));
    await settled(b);
    expect(workbench.picked_linkage!.fails).toBe(0);
    const best = workbench.picked!.tau;
    workbench.undo(); // one step with the change
    await settled(b);
    expect([workbench.picked!.tau, workbench.problem.requirements!.max_length]).toEqual([
      picked,
      Math.ceil(longest) + 1,
    ]);
    workbench.redo();
    await settled(b);
    expect(workbench.picked!.tau).toEqual(best);
    workbench.undo();
    limit(Math.floor(longest) - 1);
    await until(() => keys().includes("state.went_to_best"));
    workbench.toasts[0]!.action!.run(); // keep the old one
    await settled(b);
    expect(workbench.picked!.tau).toEqual(picked);
    expect(workbench.problem.requirements!.max_length).toBe(Math.floor(longest) - 1);
    expect(workbench.picked_linkage!.fails).not.toBe(0);
    limit(Math.floor(longest) - 2); // it failed before: the user has wanted it so
    await settled(b);
    await new Promise((resolve) => setTimeout(resolve, 500));
    expect([workbench.picked!.tau, keys()]).toEqual([picked, []]);
  });

  it("stays with what it has where nothing is left, and after a step back", async () => {
    const b = bench(tailgate),
      {workbench} = b;
    await settled(b);
    const picked = workbench.picked!.tau,
      limit = (max_length: number) => workbench.edit((problem) => with_requirements(problem, {max_length}));
    limit(1);
    await until(() => workbench.census!.meeting === 0);
    await new Promise((resolve) => setTimeout(resolve, 600));
    expect([workbench.picked!.tau, workbench.toasts]).toEqual([picked, []]);
    workbench.undo();
    workbench.redo();
    workbench.undo();
    await settled(b);
    await new Promise((resolve) => setTimeout(resolve, 600));
    expect([workbench.picked!.tau, workbench.toasts]).toEqual([picked, []]);
  });

  it("opens another task as one step", async () => {
    const b = bench(tailgate),
      {workbench} = b;
    await settled(b);
    const before = digest(b);
    workbench.open(new_problem());
    await settled(b);
    expect(poses_of(workbench.problem.task)[1]!.x).toBe(-60);
    workbench.undo();
    await settled(b);
    expect(digest(b)).toBe(before);
  });

  it("opens what it saved as it was: pick, pins and the order of the map", async () => {
    const b = bench(tailgate),
      {workbench} = b;
    await settled(b);
    workbench.pin();
    const saved = JSON.parse(JSON.stringify(workbench.whole_problem)) as Problem;
    const other = bench(saved);
    await settled(other);
    expect(other.workbench.picked!.tau).toEqual(workbench.picked!.tau);
    expect(other.workbench.pins.map((pin) => [pin.name, pin.tau])).toEqual(
      workbench.pins.map((pin) => [pin.name, pin.tau]),
    );
    const types = () => workbench.map!.type,
      types_again = () => other.workbench.map!.type;
    await until(() => types().length === types_again().length); // one may have got its fine map before the other
    expect(Buffer.compare(types(), types_again())).toBe(0); // the difference of two maps takes hours to print
    expect(other.workbench.task!.axes.input).toEqual(workbench.task!.axes.input);
  });
});
