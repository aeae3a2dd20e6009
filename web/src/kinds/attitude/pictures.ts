// What stands in the view of each section: values of the engine as lines, arrows and surfaces about the unit ball.
import {intrinsic_name} from "../../orientation/orientation";
import {triad, type Item, type Label} from "../../sphere/item";
import {
  arc,
  circle,
  column,
  dot,
  identity,
  length,
  minus,
  plus,
  times,
  unit,
  type Rows,
  type Vec3,
} from "../../sphere/vectors";
import {least_of, most_of} from "../../state/ends";
import type {AttitudeReply, Pose, Triple} from "./reply";
import type {AttitudeTask} from "./task";

export interface Picture {
  items: Item[];
  labels: Label[];
}
const fixed_size = 1.14,
  moving_size = 0.9;
const origin: Vec3 = [0, 0, 0];

function together(...parts: (Partial<Picture> | null | false)[]): Picture {
  return {
    items: parts.flatMap((part) => (part && part.items) || []),
    labels: parts.flatMap((part) => (part && part.labels) || []),
  };
}
function fixed_triad(size = fixed_size): Picture {
  return triad("fixed", identity, {size, mark: "₀", faint: true});
}
function body(frame: Rows, opacity = 1): Item {
  return {kind: "craft", key: `craft ${opacity}`, color: "craft", frame, opacity};
}
function ball(): Item[] {
  return [[1, 0, 0] as Vec3, [0, 1, 0] as Vec3, [0, 0, 1] as Vec3].map((axis, k) => ({
    kind: "path",
    key: `ball ${k}`,
    points: circle(axis),
    color: "line",
    width: 1,
    on_ball: true,
  }));
}
export function forms_picture({convert: {matrix}}: AttitudeReply): Picture {
  return together({items: [body(matrix)]}, fixed_triad(), triad("moving", matrix, {size: moving_size}));
}

// ---- three turns ----------------------------------------------------------------------------------------------------

const turn_names = ["t₁", "t₂", "t₃"];
const gimbal = {outer: 1.12, inner: 0.96, thickness: 0.06};

/** The turn that is being made at so many turns, and how far it has come. */
export function turn_at(turns: number): {turn: number; share: number} {
  const turn = Math.min(Math.floor(turns), 2);
  return {turn, share: turns - turn};
}
/** The angles as they stand when so many turns are played. */
export function played_angles(angles: Vec3, turns: number): Vec3 {
  return angles.map((angle, k) => angle * Math.min(Math.max(turns - k, 0), 1)) as unknown as Vec3;
}
/** Two rings, each between two axes that follow one another, outermost first. */
function gimbals([first, second, third]: Triple<Vec3>): Item[] {
  const across = (a: Vec3, b: Vec3): Vec3 =>
    unit([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]);
  const ring = (key: string, axis: Vec3, radius: number): Item => ({
    kind: "band",
    key,
    axis,
    inner: radius - gimbal.thickness / 2,
    outer: radius + gimbal.thickness / 2,
    color: "curve",
    opacity: 0.5,
  });
  const pins = (key: string, axis: Vec3, from: number, to: number): Item[] =>
    [1, -1].map((side) => ({
      kind: "path",
      key: `${key} ${side}`,
      points: [times(side * from, axis), times(side * to, axis)],
      color: "ink2",
      width: 5,
    }));
  return [
    ring("outer gimbal", across(first, second), gimbal.outer),
    ring("inner gimbal", across(second, third), gimbal.inner),
    ...pins("base pin", first, gimbal.outer, gimbal.outer + 0.12),
    ...pins("outer pin", second, gimbal.inner, gimbal.outer),
    ...pins("inner pin", third, gimbal.inner - 0.12, gimbal.inner),
  ];
}
/** A sector that an axis of the frame sweeps in one turn. */
function sector(k: number, axis: Vec3, before: Rows, angle_deg: number): Picture {
  const beside =
      [0, 1, 2].map((i) => column(before, i)).find((one) => Math.abs(dot(one, axis)) < 0.5) ?? column(before, 0),
    radius = 0.42 + 0.1 * k,
    rim = arc(axis, times(radius, beside), (angle_deg * Math.PI) / 180),
    color = (["input", "output", "good"] as const)[k]!;
  return {
    items: [
      {kind: "fan", key: `sector ${k}`, apex: origin, rim, color, opacity: 0.22},
      {kind: "path", key: `sweep ${k}`, points: rim, color, width: 2.5},
    ],
    labels:
      Math.abs(angle_deg) > 4
        ? [{key: `angle ${k}`, at: times(1.12, rim[Math.floor(rim.length / 2)]!), text: turn_names[k]!, color}]
        : [],
  };
}
export function turns_picture(task: AttitudeTask, {turns}: AttitudeReply, at: number): Picture {
  const {now, frames} = turns,
    extrinsic = task.turning === "extrinsic",
    axes = now.axes,
    played = played_angles(turns.angles_deg, at),
    before: Triple<Rows> = [identity, frames[0], frames[1]];
  const outwards = (extrinsic ? axes.toReversed() : axes) as unknown as Triple<Vec3>;
  const turning_axis = (k: number): Vec3 => {
    if (!extrinsic) return axes[k]!;
    const axis: [number, number, number] = [0, 0, 0];
    axis["xyz".indexOf(task.sequence[k]!)] = 1;
    return axis;
  };
  const nodes = axes[1],
    proper = task.sequence[0] === task.sequence[2];
  const {turn} = turn_at(at);
  return together(
    {items: [...gimbals(outwards), body(now.frame)]},
    fixed_triad(1.32),
    triad("moving", now.frame, {size: 0.8}),
    ...[0, 1, 2].map((k) => (extrinsic ? k === turn : k <= turn) && sector(k, turning_axis(k), before[k]!, played[k]!)),
    {
      items: [
        {
          kind: "path",
          key: "nodes",
          points: [times(-1.3, nodes), times(1.3, nodes)],
          color: "accent",
          width: 2,
          dashed: true,
        },
      ],
      labels: [{key: "nodes", at: times(1.3, nodes), text: proper ? "N" : "e₂", color: "accent"}],
    },
  );
}
/** The axes of the gimbals, outermost first: those of the intrinsic sequence. */
export function gimbal_order({sequence, turning}: AttitudeTask): string {
  return intrinsic_name(sequence, turning);
}

// ---- one turn -------------------------------------------------------------------------------------------------------

export function rotation_picture(task: AttitudeTask, {convert, rotation}: AttitudeReply, at: number): Picture {
  const size = length(task.vector) || 1,
    scaled = (a: Vec3) => times(1 / size, a),
    p = convert.axis,
    path = rotation.path.map(scaled),
    so_far = path.slice(0, Math.max(1, Math.round(at * (path.length - 1))) + 1),
    a0 = path[0]!,
    foot = times(dot(a0, p), p);
  const vector = (key: string, to: Vec3, text: string, color: "ink2" | "accent"): Picture => ({
    items: [{kind: "arrow", key, from: origin, to, color, width: 4}],
    labels: [{key, at: to, text, color}],
  });
  return together(
    {items: ball()},
    fixed_triad(),
    triad("moving", rotation.now.frame, {size: 0.8}),
    convert.axis_defined && {
      items: [
        {kind: "path", key: "axis", points: [times(-1.35, p), times(1.35, p)], color: "bad", width: 3},
        {kind: "fan", key: "cone", apex: origin, rim: path, color: "accent", opacity: 0.14},
        {kind: "fan", key: "cone so far", apex: foot, rim: so_far, color: "accent", opacity: 0.3},
        {kind: "path", key: "rest", points: arc(p, a0, 2 * Math.PI), color: "curve", width: 1, dashed: true},
        {kind: "path", key: "way", points: so_far, color: "accent", width: 3},
      ],
      labels: [
        {key: "axis", at: times(1.35, p), text: "p", color: "bad"},
        {
          key: "angle",
          at: plus(foot, times(0.55, minus(so_far[Math.floor(so_far.length / 2)]!, foot))),
          text: "θ",
          color: "accent",
        },
      ],
    },
    vector("a0", a0, "a₀", "ink2"),
    at > 0.01 && vector("a", scaled(rotation.now.vector), "a", "accent"),
  );
}

// ---- a screw --------------------------------------------------------------------------------------------------------

function place_of(pose: Pose): Vec3 {
  return [pose[0][3], pose[1][3], pose[2][3]];
}
function frame_of(pose: Pose): Rows {
  return [0, 1, 2].map((i) => pose[i]!.slice(0, 3)) as unknown as Rows;
}
/** Of what is to be seen of a displacement, the middle, and half of its extent. */
export function span_of({motion, screw}: AttitudeReply): {middle: Vec3; size: number} {
  const point = screw.screw.point,
    points = [...motion.path, ...(point && length(point) < 4 * (1 + length(screw.translation)) ? [point] : [])];
  const middle = [0, 1, 2].map((k) => {
    const along = points.map((one) => one[k]!);
    return (least_of(along) + most_of(along)) / 2;
  }) as unknown as Vec3;
  const size = most_of(points.map((one) => length(minus(one, middle))));
  return {middle, size: size > 0 ? size / 0.95 : 1};
}
export function screw_picture(reply: AttitudeReply, at: number): Picture {
  const {motion, screw} = reply,
    {middle, size} = span_of(reply),
    placed = (a: Vec3) => times(1 / size, minus(a, middle)),
    path = motion.path.map(placed),
    so_far = path.slice(0, Math.max(1, Math.round(at * (path.length - 1))) + 1);
  const pose = (key: string, of: Pose, mark: string, faint: boolean): Picture =>
    together(
      {
        items: [
          {
            kind: "craft",
            key,
            color: "craft",
            frame: frame_of(of),
            at: placed(place_of(of)),
            size: 0.42,
            opacity: faint ? 0.28 : 1,
          },
        ],
      },
      triad(key, frame_of(of), {size: 0.36, at: placed(place_of(of)), mark}),
    );
  const {axis, point, axis_defined} = screw.screw;
  const to: Pose = end_pose(reply);
  return together(
    {items: ball_origin(placed(origin))},
    point && {
      items: [
        {
          kind: "path",
          key: "screw axis",
          points: [plus(placed(point), times(-1.5, axis)), plus(placed(point), times(1.5, axis))],
          color: "bad",
          width: 3,
        },
        {kind: "dot", key: "nearest", at: placed(point), color: "bad", size: 0.03},
      ],
      labels: [
        {key: "screw axis", at: plus(placed(point), times(1.2, axis)), text: "p", color: "bad"},
        {key: "nearest", at: placed(point), text: "c", color: "bad"},
      ],
    },
    axis_defined && {
      items: [
        {kind: "path", key: "helix", points: path, color: "curve", width: 1.5, dashed: true},
        {kind: "path", key: "helix so far", points: so_far, color: "accent", width: 3},
      ],
    },
    pose("first", motion.from, "₁", true),
    at < 0.985 && pose("second", to, "₂", true),
    pose("now", motion.now, at < 0.985 ? "" : "₂", false),
  );
}
function ball_origin(at: Vec3): Item[] {
  return [{kind: "dot", key: "origin", at, color: "ink3", size: 0.02}];
}
function end_pose({convert, motion}: AttitudeReply): Pose {
  const place = motion.path.at(-1)!;
  return [...convert.matrix.map((row, i) => [...row, place[i]!]), [0, 0, 0, 1]] as unknown as Pose;
}

// ---- rates ----------------------------------------------------------------------------------------------------------

export function rates_picture(task: AttitudeTask, {convert, turns, rates}: AttitudeReply): Picture {
  const omega = rates.fixed.velocity,
    parts = turns.axes.map((axis, k) => times((task.rates_deg[k]! * Math.PI) / 180, axis)),
    chain = [parts[0]!, plus(parts[0]!, parts[1]!)],
    most = most_of([omega, ...parts, ...chain].map(length)),
    scale = most > 0 ? 1.15 / most : 0,
    colors = ["input", "output", "good"] as const;
  const starts: Vec3[] = [origin, ...chain];
  return together(
    {items: [body(convert.matrix, 0.35)]},
    fixed_triad(),
    triad("moving", convert.matrix, {size: 0.7}),
    ...parts.map((part, k) => ({
      items: [
        {
          kind: "arrow",
          key: `rate ${k}`,
          from: times(scale, starts[k]!),
          to: times(scale, plus(starts[k]!, part)),
          color: colors[k]!,
          width: 3,
        },
      ] as Item[],
      labels:
        length(part) * scale > 0.12
          ? [
              {
                key: `rate ${k}`,
                at: times(scale, plus(starts[k]!, times(0.5, part))),
                text: `ṫ${"₁₂₃"[k]}`,
                color: colors[k]!,
              },
            ]
          : [],
    })),
    most > 0 && {
      items: [{kind: "arrow", key: "omega", from: origin, to: times(scale, omega), color: "accent", width: 5}],
      labels: [{key: "omega", at: times(scale, omega), text: "ω", color: "accent"}],
    },
  );
}
