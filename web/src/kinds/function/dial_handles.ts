// The marks of the dials and the ground pivots, as one takes hold of them on the drawing.
import type {Side} from "../../contract/messages";
import {Way, type Drag} from "../../drawing/drags/drag";
import {task_handle, type Handle} from "../../drawing/handles";
import {angle_note, point_note} from "../../drawing/notes";
import {multiple, wrapped_deg, type Keys} from "../../drawing/snapping";
import {part_drag, type Desk, type Surface} from "../../drawing/surface";
import type {Problem} from "../../state/problem";
import {t} from "../../texts/texts.svelte";
import {angle_scales_of, hold_angle_scales, release_angle_scales, type AngleScale, type Mark} from "./dials";
import {ground_pivots_of} from "./kind";
import {
  angle_keys,
  angles_of,
  function_of,
  pairs_in_hand,
  pairs_of,
  unstretched,
  with_ground_pivot,
  with_pair,
} from "./pairs";

export function mark_id(mark: Pick<Mark, "side" | "pair">): string {
  return `mark_${mark.side}_${mark.pair + 1}`;
}
export function angle_scale_handles(surface: Surface): Handle[] {
  const free = angles_of(surface.workbench.problem).free;
  const is_free = ({side, pair}: Mark) =>
    side === "output" && free?.number === "pair_output" && (free.pair ?? 1) === pair + 1;
  const marks = angle_scales_of(surface).flatMap((dial) =>
    dial.marks.filter((mark) => !is_free(mark)).map((mark) => mark_handle(surface, dial, mark)),
  );
  return [...marks, ground_handle(surface, "input"), ground_handle(surface, "output")];
}

/** An angle as it comes to rest. */
export function snapped_mark(raw: number, on: boolean, keys: Keys): number {
  return multiple(raw, keys.shift ? 15 : keys.alt || !on ? 0.001 : keys.fine ? 0.1 : 1);
}
/** Told once a named function has become pairs. */
export function tell_pairs(workbench: Desk, was_named: boolean): void {
  if (was_named && !angles_of(workbench.problem).function)
    workbench.say("function.now_pairs", {}, {key: "edit.undo", run: () => workbench.undo()});
}

function mark_handle(surface: Surface, dial: AngleScale, mark: Mark): Handle {
  const {workbench} = surface,
    part = mark_id(mark),
    symbol = mark.side === "input" ? "φ" : "ψ";
  const set = (value: number) => {
    const own = pairs_of(workbench),
      shown = pairs_in_hand(workbench);
    const stretched = mark.side === "output" && angles_of(workbench.problem).free?.number === "output_scale";
    return (problem: Problem) =>
      with_pair(problem, own, mark.pair, {
        [angle_keys[mark.side]]: stretched ? unstretched(own, shown, mark.pair, value) : value,
      });
  };
  const is_named = () => angles_of(workbench.problem).function !== undefined;
  return task_handle(
    {
      part,
      label: () =>
        t("function.mark", {n: mark.pair + 1, side: t(`function.${mark.side}`), angle: angle_note(mark.angle_deg)}),
      drag(): Drag {
        const named = is_named();
        let value = mark.angle_deg;
        hold_angle_scales(surface);
        return part_drag(surface, part, {
          move(at, keys) {
            const raw = (Math.atan2(dial.center[1] - at[1], at[0] - dial.center[0]) * 180) / Math.PI - dial.zero_deg;
            value = snapped_mark(value + wrapped_deg(raw - value), surface.space.snaps, keys);
            workbench.drag(set(value));
            surface.tell(at, `${symbol} ${angle_note(value)}`);
          },
          ended(kept) {
            release_angle_scales(surface);
            if (kept) tell_pairs(workbench, named);
          },
        });
      },
      nudge(dx, dy, step) {
        const named = is_named(),
          by = ((dy || -dx) * step) / surface.space.step;
        workbench.edit(set(Number((mark.angle_deg + by).toPrecision(12))), `nudge ${part}`);
        tell_pairs(workbench, named);
      },
    },
    mark.at,
  );
}

function ground_handle(surface: Surface, side: Side): Handle {
  const {workbench} = surface,
    pivots = () => ground_pivots_of(function_of(workbench.problem)),
    place = pivots()[side];
  const part = `pivot_${side}_center`,
    other = side === "input" ? "output" : "input"; // in the place of the linkage's own
  return task_handle(
    {
      part,
      label: () => `${t(`drawing.pivot_${side}_center`)}: ${point_note(place, surface.space.step, workbench.unit)}`,
      drag(from): Drag {
        const start = pivots()[side],
          others = [pivots()[other]],
          way = new Way(surface, from);
        return part_drag(surface, part, {
          move(at, keys) {
            const {space} = surface,
              {point, guides} = space.snapped(start, way.to(at, keys).from(start), keys, others);
            workbench.drag((problem) => with_ground_pivot(problem, pivots(), side, point));
            surface.guides = guides;
            surface.tell(at, point_note(point, space.step, workbench.unit));
          },
        });
      },
      nudge(dx, dy, step) {
        const add = (value: number, by: number) => Number((value + by).toPrecision(12)) + 0,
          [x, y] = pivots()[side];
        workbench.edit(
          (problem) => with_ground_pivot(problem, pivots(), side, [add(x, dx * step), add(y, dy * step)]),
          `nudge ${part}`,
        );
      },
    },
    surface.space.project(place),
    "move",
  );
}
