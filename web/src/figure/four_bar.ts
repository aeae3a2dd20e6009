// Four-bars, whatever they are for.
import type {Linkage, Point, Side} from "../contract/messages";
import {row_state, type State} from "../state/drive";
import {body_point, placed, type Pin} from "../state/problem";
import {t, type TextKey} from "../texts/texts.svelte";
import {
  empty_figure,
  ground,
  type Body,
  type End,
  type Ends,
  type Figure,
  type Joint,
  type Place,
  type Slider,
} from "./figure";
import {in_plane, reached_rows, type Carrier, type Configuration, type Mechanism, type PlateWords} from "./mechanism";

const sides = ["input", "output"] as const,
  coupler = "coupler";

function ends_of({input, output}: Linkage, a = input.circle, b = output.circle): Ends {
  return {input: {center: input.center, circle: a}, output: {center: output.center, circle: b}};
}
function ends_at(linkage: Linkage, {ax, ay, bx, by}: State): Ends {
  return ends_of(linkage, [ax, ay], [bx, by]);
}
/** The moving pivots of `first` as the body carries them to another pose. */
function carried({input, output}: Ends, first: Place, pose: Place): Ends {
  const moved = (point: Point | null) => point && placed(body_point(point, first), pose);
  return {
    input: {center: input.center, circle: moved(input.circle)},
    output: {center: output.center, circle: moved(output.circle)},
  };
}
const at_rest: Place = {x: 0, y: 0, theta_deg: 0};
function nearest(poses: readonly Place[], stage: number): Place | undefined {
  return poses[Math.min(Math.max(Math.round(stage), 0), poses.length - 1)];
}
function pivots_of({input, output}: Ends): Point[] {
  return [input.center, output.center, input.circle, output.circle].filter((point) => point !== null);
}
function bodies_of({input, output}: Ends): Body[] {
  const bar = (name: "coupler" | Side, from: Point | null, to: Point | null): Body[] =>
    from && to ? [{name, role: name, corners: [from, to]}] : [];
  return [
    ...bar(coupler, input.circle, output.circle),
    ...bar("input", input.center, input.circle),
    ...bar("output", output.center, output.circle),
  ];
}
function joints_of(ends: Ends): Joint[] {
  const joint = (side: Side, end: End): Joint[] => {
    const at = ends[side][end],
      to = end === "center" ? ground : coupler;
    const kind = end === "center" ? "ground_pivot" : "moving_pivot";
    return at ? [{name: `${side}_${to}`, kind, role: side, at, joins: [to, side], end: {side, end}}] : [];
  };
  return (["center", "circle"] as const).flatMap((end) => sides.flatMap((side) => joint(side, end)));
}
/** That of a moving pivot at infinity turns with the body, by so much since position 1. */
function sliders_of(linkage: Linkage, ends: Ends, turned_deg: number): Slider[] {
  const turn = (turned_deg * Math.PI) / 180;
  return sides.flatMap((side): Slider[] => {
    const {center, circle, center_homogeneous, circle_homogeneous} = linkage[side];
    if (!circle_homogeneous.some((value) => value !== 0)) return []; // there is no grounded link at all
    const found: Slider[] = [];
    if (!center) {
      const [, x, y] = center_homogeneous;
      found.push({role: side, side, end: "center", at: ends[side].circle, away: unit(x, y), fixed: true});
    }
    if (!circle) {
      const [, x, y] = circle_homogeneous,
        c = Math.cos(turn),
        s = Math.sin(turn);
      const away = unit(x * c - y * s, x * s + y * c);
      found.push({role: side, side, end: "circle", at: ends[side].center, away, fixed: false});
    }
    return found;
  });
}
function unit(x: number, y: number): Point {
  const size = Math.hypot(x, y) || 1;
  return [x / size, y / size];
}
function linked(ends: Ends): Figure {
  return {...empty_figure, bodies: bodies_of(ends), joints: joints_of(ends)};
}

export const four_bar_words: PlateWords = {
  body: (name) => t(`num.${name}` as TextKey),
  pin: (name) => t(`solid.${name}_pin` as TextKey),
};

export const four_bar: Mechanism = {
  has_instant: true,
  driven(linkage, state): Configuration {
    const ends = ends_at(linkage, state);
    return {pose: state, turned_deg: state.coupler_deg, ends, joints: pivots_of(ends)};
  },
  still(linkage, poses, stage) {
    const [first = at_rest] = poses,
      pose = nearest(poses, stage) ?? first;
    const ends = carried(ends_of(linkage), first, pose);
    return {pose, turned_deg: pose.theta_deg - first.theta_deg, ends, joints: pivots_of(ends)};
  },
  figure(linkage, {pose, turned_deg, ends}, outline = []) {
    return {
      ...linked(ends),
      sliders: sliders_of(linkage, ends, turned_deg),
      guided: outline.length ? {pose, outline, on: coupler} : null,
    };
  },
  /** Where the poses have the moving pivots, else where the drive gets to. */
  visits(linkage, poses) {
    const [first] = poses,
      {drive} = linkage;
    if (first) return poses.map((pose) => bodies_of(carried(ends_of(linkage), first, pose)));
    if (!drive) return [];
    return reached_rows(linkage).map((row) => bodies_of(ends_at(linkage, row_state(drive, row))));
  },
  pivot_visits(circle, poses) {
    const [first] = poses;
    return first ? poses.map((pose) => placed(body_point(circle, first), pose)) : [circle];
  },
  /** Without poses the links are to turn by given angles: each carries its own end. */
  carrier(linkage, side, end, now, first): Carrier | null {
    if (end === "center") return null;
    if (first) return {first, now: now.pose};
    const {center, circle} = linkage[side],
      moved = now.ends[side].circle;
    return center && circle && moved && {first: frame(center, circle), now: frame(center, moved)};
  },
  pivots: (linkage) => pivots_of(ends_of(linkage)),
  sketch(pivots) {
    const [a0, a, b0, b, ...more] = pivots.map(in_plane);
    if (!a0 || !a || !b0 || !b || more.length) return empty_figure;
    return linked({input: {center: a0, circle: a}, output: {center: b0, circle: b}});
  },
  ghost({input_center, input_circle, output_center, output_circle}: Pin["pivots"], poses, stage) {
    const [first = at_rest] = poses,
      pose = nearest(poses, stage) ?? first;
    const ends: Ends = {
      input: {center: in_plane(input_center), circle: in_plane(input_circle)},
      output: {center: in_plane(output_center), circle: in_plane(output_circle)},
    };
    return linked(carried(ends, first, pose));
  },
  dimensions({lengths, input, output}) {
    const pivots = [
      {side: input, role: "input"},
      {side: output, role: "output"},
    ] as const;
    return [
      ...(lengths
        ? ([
            {name: t("num.ground"), value: lengths.ground},
            {name: t("num.input"), value: lengths.input, role: "input"},
            {name: t("num.coupler"), value: lengths.coupler, role: "body"},
            {name: t("num.output"), value: lengths.output, role: "output"},
          ] as const)
        : []),
      ...pivots.flatMap(({side, role}) => [
        {name: t("num.fixed_pivot"), value: side.center, role},
        {name: t("num.moving_pivot"), value: side.circle, role},
      ]),
    ];
  },
  plate_words: four_bar_words,
};

/** A frame at a point, its x axis towards another. */
export function frame([x, y]: Point, to: Point): Place {
  return {x, y, theta_deg: (Math.atan2(to[1] - y, to[0] - x) * 180) / Math.PI};
}
