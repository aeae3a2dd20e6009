// The links of a spherical four-bar as solids on the stage: each bar on a shell of its own about the centre, straight
// hubs along the axes with a bore for a pin. What joins two links that are no neighbours reaches through the shells between.
import {plus, times, type Vec3} from "../../sphere/vectors";
import type {LinkName} from "./replies";
import {link_ends, link_names} from "./space";

/** In whatever unit the radii are. */
export interface Sizes {
  /** Radius of the innermost shell. */
  inner: number;
  thickness: number;
  half_width: number;
  hub: number; // radius
  bore: number; // radius
  /** Between what moves against each other. */
  clearance: number;
  /** Of a hub on the side away from the bar; a bar has one every so many degrees. */
  corners: number;
  step_deg: number;
}
/** Three corners to a triangle, counter-clockwise from outside. */
export type Triangles = Vec3[];
export interface Shell {
  inner: number;
  outer: number;
}
/** Where a hub begins and ends along its axis. */
export type Reach = readonly [from: number, to: number];
/** From the inside outwards. */
export type ShellOrder = readonly LinkName[];

// ---- the layers -----------------------------------------------------------------------------------------------------

/** A shell to each link, so far apart that the flat ends of hubs do not reach the next. */
export function shells(order: ShellOrder, sizes: Sizes): Record<LinkName, Shell> {
  const found: Partial<Record<LinkName, Shell>> = {};
  let {inner} = sizes;
  for (const link of order) {
    const outer = inner + sizes.thickness;
    found[link] = {inner, outer};
    inner = Math.hypot(outer, sizes.hub) + sizes.clearance;
  }
  return found as Record<LinkName, Shell>;
}
/** How far the hubs of a link reach: up to what the next outer link on the axis begins with. */
export function hub_reaches(link: LinkName, order: ShellOrder, sizes: Sizes): readonly [Reach, Reach] {
  const of = shells(order, sizes),
    own = of[link];
  return link_ends[link].map((axis): Reach => {
    const other = link_names.find((name) => name !== link && link_ends[name].includes(axis))!;
    return [own.inner, Math.max(own.outer, of[other].inner > own.outer ? of[other].inner - sizes.clearance : 0)];
  }) as unknown as readonly [Reach, Reach];
}

// ---- one link -------------------------------------------------------------------------------------------------------

/** A frame on a hub: columns are the way to the bar, across it, and the axis outwards. */
type Place = (x: number, y: number, along: number) => Vec3;

function quad(a: Vec3, b: Vec3, c: Vec3, d: Vec3): Triangles {
  return [a, b, c, a, c, d];
}
/** Its side away from the bar; where the bar begins it is open between the shell's radii. */
function hub(
  place: Place,
  reach: Reach,
  {inner, outer}: Shell,
  {hub: radius, half_width, bore, corners: around}: Sizes,
): Triangles {
  const begin = Math.asin(half_width / radius),
    angles = Array.from({length: around + 1}, (_, k) => begin + ((2 * Math.PI - 2 * begin) * k) / around),
    front = Array.from({length: 5}, (_, k) => -begin + (2 * begin * k) / 4),
    levels = [...new Set([reach[0], inner, outer, reach[1]])].sort((a, b) => a - b);
  const at = (size: number, angle: number, along: number) =>
    place(size * Math.cos(angle), size * Math.sin(angle), along);
  const rim = (k: number, along: number) => at(radius, angles[k]!, along),
    edge = (angle: number, along: number) => at(bore, angle, along);
  const found: Triangles = [];
  for (let k = 0; k < around; ++k) {
    const [a, b] = [angles[k]!, angles[k + 1]!];
    for (const [low, high] of pairs(levels))
      found.push(...quad(rim(k, low), rim(k + 1, low), rim(k + 1, high), rim(k, high)));
    found.push(...bore_wall(edge, a, b, reach));
    found.push(...quad(edge(a, reach[1]), rim(k, reach[1]), rim(k + 1, reach[1]), edge(b, reach[1])));
    found.push(...quad(edge(b, reach[0]), rim(k + 1, reach[0]), rim(k, reach[0]), edge(a, reach[0])));
  }
  for (const [a, b] of pairs(front)) found.push(...bore_wall(edge, a, b, reach));
  for (const along of reach) {
    const cap = front_of_cap(
      rim(around, along),
      rim(0, along),
      front.map((angle) => edge(angle, along)),
    );
    found.push(...(along === reach[1] ? cap : turned_over(cap)));
  }
  for (const [low, high] of pairs(levels))
    if (low !== inner || high !== outer)
      found.push(...quad(rim(around, low), rim(0, low), rim(0, high), rim(around, high)));
  return found;
}
function pairs<T>(list: readonly T[]): [T, T][] {
  return list.slice(1).map((next, i) => [list[i]!, next]);
}
function bore_wall(edge: (angle: number, along: number) => Vec3, a: number, b: number, [low, high]: Reach): Triangles {
  return quad(edge(b, low), edge(a, low), edge(a, high), edge(b, high));
}
/** Between the edge towards the bar and the bore, from above. */
function front_of_cap(left: Vec3, right: Vec3, bore: readonly Vec3[]): Triangles {
  const middle = (bore.length - 1) / 2,
    found: Triangles = [left, right, bore[middle]!];
  pairs(bore).forEach(([a, b], k) => found.push(k < middle ? left : right, b, a));
  return found;
}
function turned_over(triangles: Triangles): Triangles {
  return triangles.map((_, i) => triangles[i - (i % 3) + [0, 2, 1][i % 3]!]!);
}

/** In its own frame (space.arc_frame): from the x axis about the z axis. */
export function link_solid(angle: number, shell: Shell, reaches: readonly [Reach, Reach], sizes: Sizes): Triangles {
  const {half_width, hub: radius, step_deg} = sizes,
    chord = Math.sqrt(radius ** 2 - half_width ** 2),
    far = Math.atan2(chord, shell.inner) + 0.01;
  const direction = (turn: number): Vec3 => [Math.cos(turn), Math.sin(turn), 0];
  const hub_place = (turn: number, sense: 1 | -1): Place => {
    const axis = direction(turn),
      to_bar = times(sense, direction(turn + Math.PI / 2)),
      aside: Vec3 = [0, 0, sense];
    return (x, y, along) => plus(times(along, axis), plus(times(x, to_bar), times(y, aside)));
  };
  const first = hub_place(0, 1),
    last = hub_place(angle, -1),
    steps = Math.max(1, Math.ceil(((angle - 2 * far) * 180) / Math.PI / step_deg));
  type Corners = readonly [inner_low: Vec3, inner_high: Vec3, outer_high: Vec3, outer_low: Vec3];
  const corners = (point: (side: number, radius: number) => Vec3): Corners => [
    point(-1, shell.inner),
    point(1, shell.inner),
    point(1, shell.outer),
    point(-1, shell.outer),
  ];
  const columns: Corners[] = [
    corners((side, r) => first(chord, side * half_width, r)),
    ...Array.from({length: steps + 1}, (_, k) => {
      const turn = far + ((angle - 2 * far) * k) / steps;
      return corners((side, r) => plus(times(r, direction(turn)), [0, 0, side * half_width]));
    }),
    corners((side, r) => last(chord, -side * half_width, r)),
  ];
  const bar = pairs(columns).flatMap(([here, next]) =>
    [0, 1, 2, 3].flatMap((k) => quad(here[k]!, here[(k + 1) % 4]!, next[(k + 1) % 4]!, next[k]!)),
  );
  return [...hub(first, reaches[0], shell, sizes), ...bar, ...hub(last, reaches[1], shell, sizes)];
}
