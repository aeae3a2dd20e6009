// The one state: what it shows of the engine's answers, and when. The engine behind it is the real one.
import {describe, expect, it} from "vitest";
import {examples, first_example} from "../gallery/gallery";
import {engine_text, with_requirements, type Problem} from "./problem";
import {poses_of} from "./task";
import {task_kinds, with_pose, with_poses} from "../kinds/kind_dispatch";
import {bench, settled, until} from "./workbench_bench";

const beginnings = task_kinds.flatMap((kind) => kind.beginnings);
const tailgate = first_example.problem,
  footrest = examples.find(({name}) => name === "footrest")!.problem;

describe("the answers on the workbench", () => {
  it("shows no map that comes late to a task without one", async () => {
    const b = bench(tailgate),
      {workbench} = b;
    await settled(b);
    workbench.edit((problem) => with_pose(problem, 2, {x: -219}));
    workbench.edit((problem) => with_poses(problem, poses_of(problem.task).slice(1)));
    await new Promise((resolve) => setTimeout(resolve, 300));
    expect(workbench.incomplete?.state).toBe("no_given");
    expect([workbench.task, workbench.map, workbench.hand]).toEqual([null, null, null]);
    workbench.undo();
    await settled(b);
    expect(poses_of(workbench.problem.task)[2]!.x).toBe(-219);
  });

  it("shows nothing of a linkage beside a task that has none", async () => {
    const b = bench(tailgate),
      {workbench} = b;
    await settled(b);
    await until(() => workbench.verified);
    const shown = () => [
      workbench.map,
      workbench.census,
      workbench.hand,
      workbench.picked_linkage,
      workbench.live,
      workbench.verified,
    ];
    workbench.hover([1.3125, 1.1125]); // asked of the old task, answered after the new one
    workbench.edit((problem) => ({...problem, task: {...footrest.task, given: {side_length: 5}} as Problem["task"]}));
    await until(() => workbench.task?.reason?.code === "no_side_link_of_length");
    for (let i = 0; i < 20; ++i) {
      expect(shown()).toEqual([null, null, null, null, null, null]);
      await new Promise((resolve) => setTimeout(resolve, 5));
    }
    workbench.hover(null);
    workbench.undo();
    await settled(b);
    await until(() => workbench.verified?.verified);
    expect(shown()).not.toContain(null);
  });

  it("never says that driving has checked what it has not: another linkage, another task", async () => {
    const b = bench(tailgate),
      {workbench} = b;
    await settled(b);
    await until(() => workbench.verified?.verified);
    workbench.hover([1.3125, 1.1125]);
    await until(() => workbench.hand!.tau[0] === 1.3125);
    expect(workbench.verified).toBeNull();
    workbench.hover(null);
    expect(workbench.verified).not.toBeNull();
    workbench.begin_gesture();
    workbench.drag((problem) => with_pose(problem, 2, {x: -219}));
    expect(workbench.verified).toBeNull();
    await until(() => workbench.is_current);
    expect(workbench.verified).toBeNull();
    workbench.cancel_gesture();
    await settled(b);
    await until(() => workbench.verified?.verified);
  });

  it("pins the linkage of the task as it is, not the one that is still on screen", async () => {
    const b = bench(tailgate),
      {workbench} = b;
    await settled(b);
    const before = workbench.hand!;
    workbench.edit((problem) => with_pose(problem, 2, {x: -219}));
    workbench.pin();
    expect(workbench.pins).toEqual([]);
    await until(() => workbench.pins.length > 0);
    const [pin] = workbench.pins,
      {linkage} = await workbench.driver_client!.follow("linkage", {
        problem: engine_text(workbench.problem),
        tau: pin!.tau,
      });
    expect([pin!.task, pin!.lengths]).toEqual([workbench.problem.task, linkage.lengths]);
    expect(pin!.lengths).not.toEqual(before.lengths);
  });

  it("asks once to a frame of a drag: map, linkage where that map has it, and its live part come together", async () => {
    const b = bench(tailgate),
      {workbench, asked, machine} = b,
      {answers} = workbench;
    machine.map_ms = 5; // no coarse map comes before the even one
    await settled(b);
    const at_rest = engine_text(workbench.problem); // its fine map may still ask for its linkage
    workbench.begin_gesture();
    for (const x of [-219, -224, -230]) {
      const before = asked.length;
      workbench.drag((problem) => with_pose(problem, 2, {x}));
      const text = engine_text(workbench.problem),
        {live} = workbench;
      await until(() => {
        expect(answers.hand_is_of_present).toBe(answers.map_is_of_present); // never one of them alone
        return answers.map_is_of_present;
      });
      expect(workbench.hand!.tau).toEqual(workbench.picked!.tau);
      expect(workbench.live).not.toBe(live);
      await new Promise((resolve) => setTimeout(resolve, 100)); // nothing comes after
      const frame = asked.slice(before).filter((message) => !("problem" in message) || message.problem !== at_rest);
      expect(frame.map(({kind}) => kind)).toEqual(["explore"]);
      expect(frame[0]).toMatchObject({problem: text, samples: 400, live: true});
      const {linkage} = await workbench.driver_client!.follow("linkage", {problem: text, tau: workbench.picked!.tau});
      expect(workbench.hand).toEqual(linkage);
    }
    workbench.end_gesture();
    await settled(b);
  });

  it("has what is pointed at on a map that a newer one is to replace in hand as that map has it", async () => {
    const b = bench(tailgate),
      {workbench, machine} = b,
      tau = [1.3125, 1.1125] as const;
    await settled(b);
    const before = engine_text(workbench.problem);
    machine.late_ms.explore = 400;
    workbench.edit((problem) => with_pose(problem, 2, {x: -219}));
    workbench.hover([...tau]);
    await until(() => workbench.hand!.tau[0] === tau[0]);
    expect([workbench.answers.map_is_of_present, workbench.answers.hand_is_of_present]).toEqual([false, false]);
    const asked = b.asked.filter(({kind}) => kind === "linkage") as unknown as {problem: string; tau: number[]}[];
    expect(asked.at(-1)).toMatchObject({problem: before, tau});
    await until(() => workbench.answers.map_is_of_present && workbench.answers.hand_is_of_present);
    expect(workbench.hand!.tau).toEqual(tau);
    workbench.hover(null);
    await settled(b);
  });

  it("keeps the linkage that a map has brought where one that was asked for before comes after", async () => {
    const b = bench(tailgate),
      {workbench, machine} = b;
    await settled(b);
    machine.late_ms.linkage = 400;
    workbench.pick([1.3125, 1.1125]);
    await until(() => b.asked.at(-1)!.kind === "linkage");
    workbench.edit((problem) => with_requirements(problem, {max_length: 1})); // τ stays as it is
    await until(() => workbench.answers.hand_is_of_present);
    const {fails} = workbench.hand!;
    await new Promise((resolve) => setTimeout(resolve, 600));
    expect(workbench.answers.hand_is_of_present).toBe(true);
    expect([workbench.hand!.tau, workbench.hand!.fails]).toEqual([[1.3125, 1.1125], fails]);
  });

  it("has no linkage of another kind in hand, which would be put together otherwise", async () => {
    const b = bench(tailgate),
      {workbench} = b;
    await settled(b);
    const six_bar = beginnings.find(({id}) => id === "six_bar")!.make();
    workbench.open(six_bar);
    expect([workbench.hand, workbench.picked_linkage]).toEqual([null, null]);
    await settled(b);
    expect(workbench.hand!.six_bar).toBeDefined();
    workbench.undo();
    expect(workbench.hand).toBeNull();
    await settled(b);
    expect(workbench.hand!.six_bar).toBeUndefined();
  });

  it("marks what is shown as outdated where no answer comes", async () => {
    const b = bench(tailgate),
      {workbench} = b,
      {answers} = workbench;
    await settled(b);
    const marks = () => [answers.map_outdated, answers.census_outdated, answers.hand_outdated];
    b.machine.mute = true;
    workbench.edit((problem) => with_pose(problem, 2, {x: -219}));
    expect(marks()).toEqual([false, false, false]); // not at once: in a drag the next answer is on its way
    await until(() => !marks().includes(false)); // each waits for itself
    workbench.undo();
    expect(marks()).toEqual([false, false, false]);
    workbench.redo();
    await until(() => answers.map_outdated);
    b.machine.mute = false;
    workbench.engine!.restart();
    workbench.driver_client!.restart();
    await until(() => workbench.is_current && !marks().includes(true));
    await settled(b);
    workbench.hover([1.3125, 1.1125]);
    await until(() => workbench.hand!.tau[0] === 1.3125);
    expect(marks()).toEqual([false, false, false]);
  });

  it("lives with a task whose dyads are no curve", async () => {
    const b = bench(tailgate),
      {workbench} = b;
    await settled(b);
    workbench.edit((problem) =>
      with_poses(
        problem,
        [
          [200, 0],
          [0, 200],
          [-200, 0],
          [120, 160],
        ].map(([x, y]) => ({x: x!, y: y!, theta_deg: 0})),
      ),
    );
    await until(() => workbench.task?.status === "degenerate");
    expect(workbench.map).toBeNull();
    expect(workbench.task!.reason!.code).toBe("translations_on_circle");
    workbench.undo();
    await settled(b);
    expect(workbench.picked).not.toBeNull();
  });

  it("follows the pointer and comes back to what is picked", async () => {
    const b = bench(tailgate),
      {workbench} = b;
    await settled(b);
    const picked = workbench.picked!.tau;
    workbench.hover([1.3125, 1.1125]);
    await until(() => workbench.hand!.tau[0] === 1.3125);
    expect(workbench.hand!.min_transmission_angle_deg).toBeCloseTo(73.5, 1);
    workbench.edit((problem) => with_requirements(problem, {max_link_ratio: 7}));
    workbench.hover(null);
    await until(() => workbench.hand!.tau.join() === picked.join());
    workbench.hover([1.3125, 1.1125]);
    workbench.pick([1.3125, 1.1125]);
    await until(() => workbench.picked_linkage!.tau[0] === 1.3125); // picked while hovered
    workbench.hover(null);
    expect(workbench.hand!.tau).toEqual([1.3125, 1.1125]);
  });

  it("works with one worker as well, counts of the whole region included", async () => {
    const b = bench(tailgate, 1),
      {workbench} = b;
    await settled(b);
    const {census} = workbench;
    workbench.zoom({input: [0.2, 0.4], output: [0.5, 0.7]});
    await until(() => workbench.map!.samples === 1000 && workbench.map!.window.input[0] === 0.2);
    expect(workbench.census).toEqual(census);
    workbench.hover([1.3125, 1.1125]);
    await until(() => workbench.hand!.tau[0] === 1.3125);
  });

  it("asks the map once for what it shows already", async () => {
    const b = bench(tailgate);
    await settled(b);
    await until(() => b.workbench.map!.samples === 1000);
    await new Promise((resolve) => setTimeout(resolve, 400));
    const maps = b.asked
      .filter((message) => message.kind === "explore")
      .map((message) => (message as {samples: number}).samples);
    expect(maps).toEqual([400, 1000]);
    b.workbench.pin();
    b.workbench.pick([1.3125, 1.1025]);
    await settled(b);
    await new Promise((resolve) => setTimeout(resolve, 400));
    expect(b.asked.filter((message) => message.kind === "explore")).toHaveLength(2);
    expect(b.workbench.map!.samples).toBe(1000);
  });

  it("shows where a held position may go, closer where that is near", async () => {
    const b = bench(tailgate),
      {workbench} = b;
    await settled(b);
    workbench.begin_gesture();
    const wide = workbench.fetch_halo(2, "move", 120);
    await until(() => workbench.halo);
    const counts = (): number[] => Array.from(workbench.halo!.counts);
    expect(counts()[13 * 6 + 6 + 2]).toBe(0); // +40 mm in x
    await until(() => workbench.halo!.reach === 30);
    expect(counts().filter((count) => count > 0).length).toBeGreaterThan(20);
    workbench.cancel_gesture();
    await wide;
  });

  it("counts on the even map where that comes later than the fine one is wanted", async () => {
    const b = bench(tailgate),
      {workbench, machine} = b;
    await settled(b);
    machine.map_ms = 200; // coarse maps in a drag from now on
    workbench.begin_gesture();
    workbench.drag((problem) => with_pose(problem, 2, {x: -219}));
    await until(() => workbench.is_current);
    machine.late_ms.explore = 1200;
    workbench.drag((problem) => with_pose(problem, 2, {x: -218})); // a coarse one, and while that is on its way:
    await until(() => (b.asked.at(-1) as {samples?: number}).samples === 100);
    await new Promise((resolve) => setTimeout(resolve, 650)); // the drag rests and wants its even one, which waits
    workbench.end_gesture();
    await until(() => workbench.map!.samples === 1000 && workbench.is_current);
    expect(workbench.census!.pairs).toBeGreaterThan(100 ** 2);
  });

  it("draws coarser maps in a drag when three in a row were slow or one very slow, and tries again", async () => {
    const b = bench(tailgate),
      {workbench, machine} = b;
    machine.map_ms = 5; // the first map, too
    await settled(b);
    const dragged = async (steps: number): Promise<number[]> => {
      const seen: number[] = [];
      for (let i = 1; i <= steps; ++i) {
        workbench.drag((problem) => with_pose(problem, 2, {x: poses_of(workbench.problem.task)[2]!.x - 0.01}));
        await until(() => workbench.is_current);
        seen.push(workbench.map!.samples);
      }
      return seen;
    };
    workbench.begin_gesture();
    machine.map_ms = 40;
    const slow = await dragged(13);
    expect(slow.filter((samples) => samples === 100).length).toBeGreaterThanOrEqual(8);
    expect(slow.slice(0, 3)).toEqual([400, 400, 400]);
    machine.map_ms = 5;
    const fast = await dragged(14);
    expect(fast.slice(-4)).toEqual([400, 400, 400, 400]);
    machine.map_ms = 100; // one of these is enough, and makes the next trial as much rarer
    const slower = await dragged(34);
    expect(slower.filter((samples) => samples === 400)).toHaveLength(2);
    workbench.cancel_gesture();
  });
});
