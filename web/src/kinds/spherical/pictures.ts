// What stands on the stage of a spherical task, part by part: each is made anew only when what it shows has changed.
import type {Linkage, Live, Side, TaskAnswer} from "../../contract/messages";
import {task_rows} from "../../figure/mechanism";
import {row_count} from "../../state/drive";
import type {Pin} from "../../state/problem";
import type {Item, Label, SphereColor} from "../../sphere/item";
import {triad} from "../../sphere/item";
import {circle, column, dot, great_circle, times, type Rows, type Vec3} from "../../sphere/vectors";
import {is_axis} from "./figure";
import {link_solid, hub_reaches, shells, type ShellOrder, type Sizes} from "./link_solid";
import type {Cone, LinkName} from "./replies";
import {after, all_rows, axis_names, link_angle, link_ends, link_frame, link_names, stands, type Stand} from "./space";

export interface Picture {
  items: Item[];
  labels: Label[];
}
const nothing: Picture = {items: [], labels: []};

// ---- the ball -------------------------------------------------------------------------------------------------------

const directions: readonly Vec3[] = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];
export const ball: readonly Item[] = [
  {kind: "ball", key: "ball", radius: 1, color: "line", opacity: 0.6},
  ...directions.map((axis, k): Item => ({
    kind: "path",
    key: `meridian ${k}`,
    points: circle(axis),
    color: "line",
    width: 1,
    on_ball: true,
  })),
];

// ---- curves ---------------------------------------------------------------------------------------------------------

/** Of a curve of axes the stretches between neighbours (`is_shown` by index), and opposite them once more: an axis is a
 *  line. Each branch is closed. */
export function stretches(
  points: Float64Array,
  branch: Uint8Array,
  is_shown: (index: number) => boolean = () => true,
): Vec3[] {
  const at = (i: number): Vec3 => [points[3 * i]!, points[3 * i + 1]!, points[3 * i + 2]!];
  return kept_by_branch(branch, (i, j) => dot(at(i), at(j)), is_shown).flatMap((list) => {
    const ends: Vec3[] = [];
    let last: Vec3 | null = null;
    list.forEach((i, k) => {
      const next = list[(k + 1) % list.length]!;
      if (next === i || !is_shown(i) || !is_shown(next)) return void (last = null);
      const from: Vec3 = last ?? at(i),
        to = dot(from, at(next)) < 0 ? times(-1, at(next)) : at(next);
      ends.push(from, to);
      last = to;
    });
    return [...ends, ...opposite(ends)];
  });
}
/** What was joined stays so. */
function opposite(ends: readonly Vec3[]): Vec3[] {
  const turned: Vec3[] = [];
  ends.forEach((end, i) => turned.push(i > 0 && end === ends[i - 1] ? turned[i - 1]! : times(-1, end)));
  return turned;
}
const near = Math.cos(0.025);
/** Of each branch as many samples as are seen: those that lie apart, and where what is shown begins and ends. */
function kept_by_branch(
  branch: Uint8Array,
  cosine: (i: number, j: number) => number,
  is_shown: (index: number) => boolean,
): number[][] {
  const branches: number[][] = [];
  for (let i = 0; i < branch.length; ++i) {
    const list = branches.at(-1),
      last = list?.at(-1);
    if (!list || last === undefined || branch[last] !== branch[i]) {
      branches.push([i]);
      continue;
    }
    const changes = is_shown(i) !== is_shown(i - 1) || (i + 1 < branch.length && is_shown(i) !== is_shown(i + 1));
    if (changes || branch[i + 1] !== branch[i] || Math.abs(cosine(last, i)) < near) list.push(i);
  }
  return branches;
}
const curve_colors = {center: "ink2", circle: "curve"} as const satisfies Record<string, SphereColor>;
export const curve_names = ["center", "circle"] as const;

export function curves_picture({curves}: TaskAnswer): Item[] {
  return curve_names.flatMap((curve): Item[] => [
    {
      kind: "strokes",
      key: `curve ${curve}`,
      ends: stretches(curves[curve], curves.branch),
      color: curve_colors[curve],
      width: curve === "center" ? 2.2 : 1.8,
    },
    ...single_axes(curves[curve], curves.branch).map((at, k): Item => ({
      kind: "dot",
      key: `axis of ${curve} ${k}`,
      at,
      color: curve_colors[curve],
      size: 0.016,
    })),
  ]);
}
/** Both ends of each axis that is a branch of its own: of a few dyads, or beside a curve. */
export function single_axes(points: Float64Array, branch: Uint8Array): Vec3[] {
  const at = (i: number): Vec3 => [points[3 * i]!, points[3 * i + 1]!, points[3 * i + 2]!];
  return kept_by_branch(
    branch,
    (i, j) => dot(at(i), at(j)),
    () => true,
  ).flatMap(([first, last]) =>
    last === undefined || Math.abs(dot(at(first!), at(last))) > near ? [at(first!), times(-1, at(first!))] : [],
  );
}
/** Where one side can go with the other held, everything still met. */
export function live_picture({curves}: TaskAnswer, live: Live): Item[] {
  return (["input", "output"] as const).flatMap((side: Side) => {
    const bits = live[side];
    if (bits.length !== curves.branch.length) return [];
    return curve_names.map((curve): Item => ({
      kind: "strokes",
      key: `live ${side} ${curve}`,
      ends: stretches(curves[curve], curves.branch, (i) => bits[i] === 0),
      color: side,
      width: 4.2,
    }));
  });
}

// ---- the body -------------------------------------------------------------------------------------------------------

export type Corners = readonly number[] | Float32Array | null;
/** The body as a ghost in each orientation, its number at its tip. */
export function orientations_picture(
  frames: readonly (Rows | null)[],
  corners: Corners,
  tip: number,
  selected: number | null,
  mark: (index: number) => Label["button"],
): Picture {
  const items: Item[] = [],
    labels: Label[] = [];
  frames.forEach((frame, index) => {
    if (!frame) return;
    const is_selected = index === selected,
      key = `orientation ${index}`;
    if (corners)
      items.push({
        kind: "solid",
        key,
        corners,
        frame,
        color: is_selected ? "accent" : "body",
        opacity: is_selected ? 0.5 : 0.2,
      });
    if (!corners || is_selected)
      items.push(...triad(key, frame, {size: is_selected ? 0.9 : 0.75, faint: !is_selected}).items);
    labels.push({
      key,
      at: times(0.9, column(frame, tip)),
      text: String(index + 1),
      color: "ink",
      button: mark(index),
    });
  });
  return {items, labels};
}
/** Where the drive has got to. */
export function body_now(frame: Rows, corners: Corners): Item[] {
  if (corners) return [{kind: "solid", key: "body", corners, frame, color: "accent"}];
  return triad("body", frame, {size: 0.85}).items;
}

// ---- the linkage ----------------------------------------------------------------------------------------------------

/** Of the drawing, in radii of the ball. */
const sizes: Sizes = {
  inner: 1.004,
  thickness: 0.026,
  half_width: 0.024,
  hub: 0.044,
  bore: 0.014,
  clearance: 0.004,
  corners: 12,
  step_deg: 6,
};
const order: ShellOrder = ["ground", "input", "coupler", "output"];
const link_colors: Record<LinkName, SphereColor> = {ground: "ink3", input: "input", coupler: "body", output: "output"};

/** The bodies of the links, which stay the same while it moves. */
export function link_bodies(stand: Stand): Record<LinkName, readonly number[]> {
  const of = shells(order, sizes);
  return Object.fromEntries(
    link_names.map((link) => [
      link,
      link_solid(link_angle(link, stand), of[link], hub_reaches(link, order, sizes), sizes).flat(),
    ]),
  ) as unknown as Record<LinkName, readonly number[]>;
}
export function linkage_picture(bodies: Record<LinkName, readonly number[]>, stand: Stand): Item[] {
  return [
    ...link_names.map((link): Item => ({
      kind: "solid",
      key: `link ${link}`,
      corners: bodies[link],
      frame: link_frame(link, stand),
      color: link_colors[link],
    })),
    ...axis_names.flatMap((axis): Item[] => {
      const color = axis.startsWith("input") ? "input" : "output",
        [from, to] = [times(-1, stand[axis]), stand[axis]];
      return [
        {kind: "path", key: `axis ${axis}`, points: [from, to], color, width: 1, opacity: 0.45},
        {kind: "dot", key: `opposite ${axis}`, at: from, color, size: axis.endsWith("fixed") ? 0.024 : 0.018},
      ];
    }),
  ];
}
/** The way of the body's tip on the ball, over all the drive and over the task; the places where the drive ends. */
export function ways_picture(linkage: Linkage, first: Rows | null, tip: number): Picture {
  const {drive} = linkage;
  if (!drive) return nothing;
  const items: Item[] = [];
  const place = (row: number): Vec3 => {
    const [{turn}] = stands(linkage, [row, row]) as [Stand];
    return first ? column(after(turn, first), tip) : [0, 0, 1];
  };
  const way = ([from, to]: readonly [number, number]) => {
    const points = first ? smooth_way(place, from, to) : [];
    return points.slice(1).flatMap((point, k) => [points[k]!, point]);
  };
  const task = task_rows(drive);
  items.push({kind: "strokes", key: "way", ends: way(all_rows(drive)), color: "accent", width: 1.2, opacity: 0.5});
  if (task) items.push({kind: "strokes", key: "way of the task", ends: way(task), color: "accent", width: 3});
  const last = row_count(drive) - 1;
  const ends = [drive.limits.low && 0, drive.limits.high && last].filter((row) => typeof row === "number");
  for (const row of ends) {
    const [stand] = stands(linkage, [row, row]);
    if (stand)
      items.push({
        kind: "dot",
        key: `dead point ${row ? "high" : "low"}`,
        at: times(1.045, stand.input_moving),
        color: "bad",
        size: 0.034,
      });
  }
  return {items, labels: []};
}
const coarse = 8, // rows
  fine = Math.cos(0.09);
/** Places at rows from the first to the last, the closer the faster they follow each other. */
export function smooth_way(place: (row: number) => Vec3, first: number, last: number): Vec3[] {
  const between = (from: number, a: Vec3, to: number, b: Vec3): Vec3[] => {
    const middle = Math.floor((from + to) / 2);
    if (middle === from || (to - from <= coarse && dot(a, b) > fine)) return [b];
    const c = place(middle);
    return [...between(from, a, middle, c), ...between(middle, c, to, b)];
  };
  const start = place(first);
  return first < last ? [start, ...between(first, start, last, place(last))] : [];
}
/** Pinned linkages, thin, as in position 1. */
export function ghosts_picture(pins: readonly Pin[]): Item[] {
  return pins.flatMap(({name, pivots, shown}) => {
    if (!shown) return [];
    return (["input", "coupler", "output"] as const).flatMap((link): Item[] => {
      const [from, to] = link_ends[link].map((axis) => pivots[axis]);
      if (!is_axis(from) || !is_axis(to)) return [];
      return [
        {
          kind: "path",
          key: `pin ${name} ${link}`,
          points: great_circle(from, to),
          color: link_colors[link],
          width: 2,
          dashed: true,
          on_ball: true,
        },
      ];
    });
  });
}

// ---- cones ----------------------------------------------------------------------------------------------------------

export const cone_colors = {fixed_axes_within: "good", moving_axes_within: "warn"} as const;
export type ConeKey = keyof typeof cone_colors;

/** Both caps of a cone: its rims, and a veil over them. */
export function cone_picture(key: ConeKey, axis: Vec3, {half_angle_deg}: Cone): Item[] {
  const half = (half_angle_deg * Math.PI) / 180,
    rim = circle(axis, Math.sin(half)).map((point): Vec3 => {
      const along = times(Math.cos(half), axis);
      return [point[0] + along[0], point[1] + along[1], point[2] + along[2]];
    });
  return [1, -1].flatMap((sense): Item[] => {
    const points = rim.map((point) => times(sense, point));
    return [
      {kind: "path", key: `${key} rim ${sense}`, points, color: cone_colors[key], width: 2.4, on_ball: true},
      {kind: "fan", key: `${key} cap ${sense}`, apex: [0, 0, 0], rim: points, color: cone_colors[key], opacity: 0.06},
    ];
  });
}
