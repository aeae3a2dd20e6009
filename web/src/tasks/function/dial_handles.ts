// The marks of the dials and the ground pivots, as one takes hold of them on the drawing.
import type {Point, Side} from "../../engine/protocol";
import {finish, grid, pixel, Way, type Bench, type Drag} from "../../drawing/drags/drag";
import {task_handle, type Handle} from "../../drawing/handles";
import type {Scene} from "../../drawing/scene.svelte";
import {multiple, snapped_point, wrapped_deg, type Keys} from "../../drawing/snapping";
import {to_screen} from "../../drawing/viewport";
import {angle_note, point_note} from "../../drawing/words";
import {mistake_sentence} from "../../task/mistakes";
import {t} from "../../texts/texts.svelte";
import {dials_of, hold_dials, release_dials, type Dial, type Mark} from "./dials";
import {ground_pivots_of} from "./kind";
import {angle_keys, function_of, pairs_in_hand, pairs_of, unstretched, with_ground_pivot, with_pair} from "./pairs";

export function mark_id(mark: Pick<Mark, "side" | "pair">): string {
  return `mark_${mark.side}_${mark.pair + 1}`;
}
export function dial_handles(scene: Scene): Handle[] {
  const free = function_of(scene.workbench.problem).free;
  const is_free = ({side, pair}: Mark) =>
    side === "output" && free?.number === "pair_output" && (free.pair ?? 1) === pair + 1;
  const marks = dials_of(scene).flatMap((dial) =>
    dial.marks.filter((mark) => !is_free(mark)).map((mark) => mark_handle(scene, dial, mark)),
  );
  return [...marks, ground_handle(scene, "input"), ground_handle(scene, "output")];
}

/** An angle as it comes to rest. */
export function snapped_mark(raw: number, on: boolean, keys: Keys): number {
  return multiple(raw, keys.shift ? 15 : keys.alt || !on ? 0.001 : keys.fine ? 0.1 : 1);
}
/** Told once a named function has become pairs. */
export function tell_pairs({workbench}: Pick<Bench, "workbench">, was_named: boolean): void {
  if (was_named && !function_of(workbench.problem).function)
    workbench.say("function.now_pairs", {}, {key: "edit.undo", run: () => workbench.undo()});
}
function note({workbench, scene}: Bench, at: Point, text: string): void {
  const [mistake] = workbench.refusal ?? [];
  scene.note = {at, text, reason: mistake ? mistake_sentence(mistake) : null};
}

function mark_handle(scene: Scene, dial: Dial, mark: Mark): Handle {
  const {workbench} = scene,
    part = mark_id(mark),
    symbol = mark.side === "input" ? "φ" : "ψ";
  const set = (value: number) => {
    const own = pairs_of(workbench),
      shown = pairs_in_hand(workbench);
    const stretched = mark.side === "output" && function_of(workbench.problem).free?.number === "output_scale";
    return (problem: typeof workbench.problem) =>
      with_pair(problem, own, mark.pair, {
        [angle_keys[mark.side]]: stretched ? unstretched(own, shown, mark.pair, value) : value,
      });
  };
  return task_handle(
    {
      part,
      label: () =>
        t("function.mark", {n: mark.pair + 1, side: t(`function.${mark.side}`), angle: angle_note(mark.angle_deg)}),
      drag(bench): Drag {
        const named = function_of(workbench.problem).function !== undefined;
        let value = mark.angle_deg;
        workbench.begin_gesture();
        hold_dials(scene);
        scene.held = scene.handles.find(({id}) => id === part)?.target ?? null;
        const end = (keep: boolean) => {
          release_dials(scene);
          finish(bench, keep);
          if (keep) tell_pairs(bench, named);
        };
        return {
          cursor: "grabbing",
          move(at, keys) {
            const raw = (Math.atan2(dial.center[1] - at[1], at[0] - dial.center[0]) * 180) / Math.PI - dial.zero_deg;
            value = snapped_mark(value + wrapped_deg(raw - value), grid(scene).on, keys);
            workbench.drag(set(value));
            note(bench, at, `${symbol} ${angle_note(value)}`);
          },
          end: () => end(true),
          cancel: () => end(false),
        };
      },
      nudge(bench, dx, dy, step) {
        const named = function_of(workbench.problem).function !== undefined,
          by = ((dy || -dx) * step) / scene.step;
        workbench.edit(set(Number((mark.angle_deg + by).toPrecision(12))), `nudge ${part}`);
        tell_pairs(bench, named);
      },
    },
    mark.at,
  );
}

function ground_handle(scene: Scene, side: Side): Handle {
  const {workbench} = scene,
    pivots = () => ground_pivots_of(function_of(workbench.problem)),
    place = pivots()[side];
  const part = `pivot_${side}_center`,
    other = side === "input" ? "output" : "input"; // in the place of the linkage's own
  return task_handle(
    {
      part,
      label: () => `${t(`drawing.pivot_${side}_center`)}: ${point_note(place, scene.step, workbench.unit)}`,
      drag(bench, from): Drag {
        const start = pivots()[side],
          [ox, oy] = pivots()[other],
          way = new Way(scene, from);
        workbench.begin_gesture();
        scene.held = scene.handles.find(({id}) => id === part)?.target ?? null;
        return {
          cursor: "grabbing",
          move(at, keys) {
            const {x, y} = way.to(at, keys);
            const {point, guides} = snapped_point(
              start,
              [start[0] + x, start[1] + y],
              grid(scene, [{x: ox, y: oy}]),
              keys,
              pixel(scene.view),
            );
            workbench.drag((problem) => with_ground_pivot(problem, pivots(), side, point));
            scene.guides = guides;
            note(bench, at, point_note(point, scene.step, workbench.unit));
          },
          end: () => finish(bench, true),
          cancel: () => finish(bench, false),
        };
      },
      nudge(_, dx, dy, step) {
        const add = (value: number, by: number) => Number((value + by).toPrecision(12)) + 0,
          [x, y] = pivots()[side];
        workbench.edit(
          (problem) => with_ground_pivot(problem, pivots(), side, [add(x, dx * step), add(y, dy * step)]),
          `nudge ${part}`,
        );
      },
    },
    to_screen(scene.view, place),
    "move",
  );
}
