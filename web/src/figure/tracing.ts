// A four-bar whose coupler carries a point: the coupler is a plate with the point as its third corner.
import type {Linkage, Point} from "../contract/messages";
import {t} from "../texts/texts.svelte";
import type {Body, Figure, Joint} from "./figure";
import {four_bar} from "./four_bar";
import {in_plane, type Mechanism} from "./mechanism";

/** The point as the linkage lies, and how far it is from both moving pivots. */
export interface CarriedPoint {
  point: Point;
  point_to_input: number;
  point_to_output: number;
}
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

/** `seen`: points that are to be in sight with the linkage. */
export function tracing_four_bar(
  carried: (linkage: Linkage) => CarriedPoint | null,
  seen: (linkage: Linkage) => Point[],
): Mechanism {
  const point_of = (linkage: Linkage) => carried(linkage)?.point ?? null;
  return {
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
    pivots: (linkage) => [...four_bar.pivots(linkage), ...seen(linkage)],
    sketch: (pivots) => with_point(four_bar.sketch(pivots.slice(0, 4)), in_plane(pivots[4])),
    ghost: (pivots, poses, stage) => with_point(four_bar.ghost(pivots, poses, stage), in_plane(pivots.point)),
    dimensions(linkage) {
      const of = carried(linkage);
      return [...four_bar.dimensions(linkage), ...(of ? arms(of) : [])];
    },
  };
}
function arms({point_to_input, point_to_output, point}: CarriedPoint) {
  return [
    {name: t("carried.point_to_input"), value: point_to_input, role: "body"},
    {name: t("carried.point_to_output"), value: point_to_output, role: "body"},
    {name: t("carried.point"), value: point, role: "body"},
  ] as const;
}
