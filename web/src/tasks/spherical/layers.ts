// On which shell each link is printed: in such an order, and so large, that none runs into a hub that reaches through its
// own shell while the linkage moves.
import {shells, type ShellOrder, type Sizes} from "./print";
import type {AxisName, LinkName} from "./replies";
import {angle_between, axis_names, distance_from_arc, link_ends, link_names, type Stand} from "./space";

/** How near an axis comes to a link that does not end on it, state by state: to its arc, and to the axes at its ends;
 *  radians. */
interface Approach {
  axis: AxisName;
  link: LinkName;
  to_arc: number[];
  to_ends: number[];
}
export function approaches(stands: readonly Stand[]): Approach[] {
  return axis_names.flatMap((axis) =>
    link_names
      .filter((link) => !link_ends[link].includes(axis))
      .map((link): Approach => {
        const [from, to] = link_ends[link];
        return {
          axis,
          link,
          to_arc: stands.map((stand) => distance_from_arc(stand[axis], stand[from], stand[to])),
          to_ends: stands.map((stand) =>
            Math.min(angle_between(stand[axis], stand[from]), angle_between(stand[axis], stand[to])),
          ),
        };
      }),
  );
}

/** A link and the one whose hub it runs into, in a state. */
export interface Clash {
  links: readonly [LinkName, LinkName];
  state: number;
}
export type States = readonly [first: number, last: number];

/** All of an order of the shells, in states from the first to the last. */
export function clashes(order: ShellOrder, near: readonly Approach[], sizes: Sizes, [first, last]: States): Clash[] {
  const of = shells(order, sizes);
  return near.flatMap(({axis, link, to_arc, to_ends}) => {
    const [inner, outer] = order.filter((one) => link_ends[one].includes(axis)) as [LinkName, LinkName];
    if (of[link].inner < of[inner].inner || of[link].inner > of[outer].inner) return []; // no hub comes through
    const {hub, half_width, clearance} = sizes,
      bar_room = (hub + half_width + clearance) / of[link].inner,
      end_room = (2 * hub + clearance) / of[link].inner;
    const found: Clash[] = [];
    for (let state = first; state <= last; ++state)
      if (to_arc[state]! < bar_room || to_ends[state]! < end_room) found.push({links: [link, inner], state});
    return found;
  });
}

const orders: ShellOrder[] = permutations([...link_names]);
function permutations<T>(list: T[]): T[][] {
  if (list.length < 2) return [list];
  return list.flatMap((one, i) => permutations(list.toSpliced(i, 1)).map((rest) => [one, ...rest]));
}
const growths = [1, 1.3, 1.7, 2.2], // hubs and bars stay as they are, so that larger shells have more room
  most_inner = 90; // millimetres

export interface Layout {
  order: ShellOrder;
  sizes: Sizes;
  /** What is left, in any state. */
  clashes: Clash[];
}
/** The smallest in which nothing collides in any state, or else in those of the task; or else that in which least does. */
export function laid_out(stands: readonly Stand[], task: States | null, least: Sizes): Layout {
  const near = approaches(stands),
    all: States = [0, stands.length - 1],
    laid = (order: ShellOrder, sizes: Sizes) => ({order, sizes, clashes: clashes(order, near, sizes, all)});
  const room = growths
    .map((growth) => ({...least, inner: growth * least.inner}))
    .filter(({inner}) => inner <= Math.max(least.inner, most_inner));
  for (const states of [all, ...(task ? [task] : [])])
    for (const sizes of room)
      for (const order of orders) if (clashes(order, near, sizes, states).length === 0) return laid(order, sizes);
  const sizes = room.at(-1)!,
    in_task = (order: ShellOrder) => clashes(order, near, sizes, task ?? all).length;
  return laid(
    orders.reduce((best, order) => (in_task(order) < in_task(best) ? order : best)),
    sizes,
  );
}
