// A four-bar whose coupler carries the point that runs straight: the coupler is a plate with the point as its third corner.
import type {Linkage, Point} from "../../contract/messages";
import type {Body, Figure, Joint} from "../../figure/figure";
import {four_bar} from "../../figure/four_bar";
import {in_plane, type Mechanism} from "../../figure/mechanism";
import {row_state} from "../../state/drive";
import {t} from "../../texts/texts.svelte";
import type {StraightLine} from "./replies";

const coupler = "coupler",
  name = "point";

export function with_point(figure: Figure, point: Point | null): Figure {
  if (!point) return figure;
  const joint: Joint = {name, kind: "moving_pivot", role: "driver", at: point, joins: [coupler, ""]};
  return {
    ...figure,
    bodies: figure.bodies.map((body): Body => {
      return body.name === coupler ? {...body, corners: [...body.corners, point]} : body;
    }),
    joints: [...figure.joints, joint],
  };
}
/** The point as the linkage lies, carried along with the coupler. */
function point_of({straight_line: line}: Linkage): Point | null {
  return line?.point ?? null;
}

/** The point, and where it gets to while it runs straight. */
function stretch_of({straight_line: line, drive}: Linkage): Point[] {
  if (!line) return [];
  const [first, last] = drive?.task ?? [-1, -1];
  const ends = drive && first >= 0 && last >= 0 ? [first, last].map((row) => row_state(drive, row)) : [];
  return [line.point, ...ends.map(({x, y}): Point => [x, y])];
}

export const tracing_four_bar: Mechanism = {
  ...four_bar,
  guides_a_point: true,
  driven(linkage, state, hinges) {
    const now = four_bar.driven(linkage, state, hinges);
    return {...now, joints: [...now.joints, [state.x, state.y]]};
  },
  /** Without a drive it lies as it was found. */
  still(linkage, poses, stage) {
    const [x, y] = point_of(linkage) ?? [0, 0];
    return {...four_bar.still(linkage, poses, stage), pose: {x, y, theta_deg: 0}};
  },
  figure: (linkage, now) => with_point(four_bar.figure(linkage, now), point_of(linkage) && [now.pose.x, now.pose.y]),
  pivots: (linkage) => [...four_bar.pivots(linkage), ...stretch_of(linkage)],
  sketch(pivots) {
    const point = in_plane(pivots[4]);
    return with_point(four_bar.sketch(pivots.slice(0, 4)), point);
  },
  ghost: (pivots, poses, stage) => with_point(four_bar.ghost(pivots, poses, stage), in_plane(pivots.point)),
  dimensions(linkage) {
    const {straight_line: line} = linkage;
    return [...four_bar.dimensions(linkage), ...(line ? arms(line) : [])];
  },
};
function arms({point_to_input, point_to_output, point}: StraightLine) {
  return [
    {name: t("straight.point_to_input"), value: point_to_input, role: "body"},
    {name: t("straight.point_to_output"), value: point_to_output, role: "body"},
    {name: t("straight.point"), value: point, role: "body"},
  ] as const;
}
