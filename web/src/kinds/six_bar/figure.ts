// A six-bar as it is drawn: bodies 1 to 3 of the chain, and the two added links in the colours of the map's axes.
import type {Linkage, Point, Side} from "../../contract/messages";
import {row_joints} from "../../state/drive";
import {empty_figure, ground, type Body, type Ends, type Figure, type Joint, type Role} from "../../figure/figure";
import {frame} from "../../figure/four_bar";
import {in_plane, reached_rows, type Configuration, type Mechanism} from "../../figure/mechanism";
import type {SixBar} from "./replies";
import {added, end_joints, role_of_body, role_of_joint} from "./roles";
import {t} from "../../texts/texts.svelte";
import {body_name, joint_mark, joint_words, length_words} from "./names";

const guided_body = 3;

/** As the engine calls it. */
function name_of(body: number): string {
  return body === 0 ? ground : `body_${body}`;
}
function points_at(places: readonly Point[], joints: readonly number[]): Point[] {
  return joints.flatMap((joint) => {
    const place = places[joint];
    return place ? [place] : [];
  });
}
/** The bodies but the ground, hinges at these places. */
function bodies_of({bodies}: SixBar, places: readonly Point[]): Body[] {
  return bodies.slice(1).map((list, i) => {
    const body = i + 1;
    return {
      name: name_of(body),
      role: role_of_body(body),
      corners: points_at(places, list),
      label: {sign: String(body), words: body_name(body)},
    };
  });
}
function joints_of(six_bar: SixBar, places: readonly Point[]): Joint[] {
  return six_bar.joints.flatMap(({name, ground: at_rest}, joint): Joint[] => {
    const at = places[joint],
      [one = 0, other = 0] = six_bar.bodies.flatMap((list, body) => (list.includes(joint) ? [body] : []));
    if (!at) return [];
    return [
      {
        name,
        kind: at_rest ? "ground_pivot" : "moving_pivot",
        role: role_of_joint(joint),
        at,
        joins: [name_of(one), name_of(other)],
        end: end_joints[joint],
        label: {sign: joint_mark(name), words: joint_words(six_bar, joint)},
      },
    ];
  });
}
function ends_of(places: readonly Point[]): Ends {
  const [, , , c4 = null, z4 = null, c5 = null, z5 = null] = places;
  return {input: {center: c4, circle: z4}, output: {center: c5, circle: z5}};
}
function pivots_of({six_bar}: Linkage): Point[] {
  return six_bar?.joints.map(({at}) => at) ?? [];
}
function bar(name: Role, corners: readonly Point[]): Body {
  return {name, role: name, corners};
}
/** A hinge without a name. */
function hinge(role: Role, at: Point): Joint {
  return {name: "", kind: "moving_pivot", role, at, joins: ["", ""]};
}

export const six_bar: Mechanism = {
  sampled_links: ({six_bar}) =>
    (six_bar?.bodies ?? []).slice(1).map((joints, i) => ({role: role_of_body(i + 1), joints})),
  driven: (_, state, hinges): Configuration => ({
    pose: state,
    turned_deg: state.coupler_deg,
    ends: ends_of(hinges),
    joints: hinges,
  }),
  still(linkage, poses) {
    const {input, output} = linkage,
      ends = {
        input: {center: input.center, circle: input.circle},
        output: {center: output.center, circle: output.circle},
      };
    return {pose: poses[0] ?? {x: 0, y: 0, theta_deg: 0}, turned_deg: 0, ends, joints: pivots_of(linkage)};
  },
  figure({six_bar: parts}, {pose, joints}, outline = []) {
    if (!parts) return empty_figure;
    return {
      ...empty_figure,
      bodies: bodies_of(parts, joints),
      joints: joints_of(parts, joints),
      guided: outline.length ? {pose, outline, on: name_of(guided_body)} : null,
    };
  },
  visits(linkage) {
    const {six_bar: parts, drive} = linkage;
    return parts && drive ? reached_rows(linkage).map((row) => bodies_of(parts, row_joints(drive, row))) : [];
  },
  pivot_visits: (circle) => [circle],
  carrier({six_bar: parts}, side, end, {joints: places}) {
    const joint = end_joints.findIndex((joined) => joined?.side === side && joined.end === end),
      body = parts?.bodies.findIndex((list, k) => k !== added[side] && list.includes(joint)) ?? -1;
    if (!parts || body <= 0) return null;
    const on_body = parts.bodies[body] ?? [],
      [from, to] = points_at(pivots_of({six_bar: parts} as Linkage), on_body),
      [from_now, to_now] = points_at(places, on_body);
    return from && to && from_now && to_now ? {first: frame(from, to), now: frame(from_now, to_now)} : null;
  },
  pivots: pivots_of,
  sketch(pivots): Figure {
    const [a, b, d, c4, z4, c5, z5, ...more] = pivots.map(in_plane);
    if (!a || !b || !d || !c4 || !z4 || !c5 || !z5 || more.length) return empty_figure;
    return {
      ...empty_figure,
      bodies: [bar("coupler", [a, b]), bar("coupler", [b, d]), bar("input", [c4, z4]), bar("output", [c5, z5])],
      joints: [a, b, d, c4, z4, c5, z5].map((at, joint) => hinge(role_of_joint(joint), at)),
    };
  },
  /** A pin keeps the added links in position 1. */
  ghost({input_center, input_circle, output_center, output_circle}) {
    const link = (role: Side, center: Point | null, circle: Point | null): Figure => ({
      ...empty_figure,
      bodies: center && circle ? [bar(role, [center, circle])] : [],
      joints: [center, circle].flatMap((at) => (at ? [hinge(role, at)] : [])),
    });
    const input = link("input", in_plane(input_center), in_plane(input_circle)),
      output = link("output", in_plane(output_center), in_plane(output_circle));
    return {
      ...empty_figure,
      bodies: [...input.bodies, ...output.bodies],
      joints: [...input.joints, ...output.joints],
    };
  },
  dimensions({six_bar: parts}) {
    if (!parts) return [];
    return [
      ...parts.lengths.map(({name, length}) => ({name: length_words(name), value: length})),
      ...parts.joints.map(({at}, joint) => ({name: joint_words(parts, joint), value: at})),
    ];
  },
  plate_words: {
    body: (name) => body_name(Number(name.replace("body_", "")) || 0),
    pin: (name) => t("solid.pin", {name: joint_mark(name)}),
  },
};
