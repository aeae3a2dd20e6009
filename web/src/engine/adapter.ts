// Linkages as the page knows them, of the engine's replies: the object of the result file, and beside it what only the
// page shows (bindings/wasm/linkage_reply.cpp, best_reply.cpp).
import type {Defects, GroundedLink, Linkage, Pivot, Point, Ranked} from "../contract/messages";
import type * as told from "../contract/replies";
import type * as result from "../contract/result";

type Axis = readonly [number, number, number];
type Member<Kind, Key extends PropertyKey> = Kind extends {[K in Key]?: infer Value} ? Value : never;
/** What one of the kinds has, whichever it is. */
type OfAnyKind<Kinds> = {[Key in Kinds extends unknown ? keyof Kinds : never]?: Member<Kinds, Key>};
/** A grounded link of the plane, or about a centre. */
type Dyad = OfAnyKind<result.Dyad | result.SphericalDyad> & {residual: number};
/** An element of a result's `linkages` of any kind. */
type LinkageRecord = Omit<
  OfAnyKind<result.FourBar | result.SixBar | result.SphericalFourBar | result.StraightLineFourBar>,
  "type" | "residual" | "input" | "output" | "lengths"
> &
  Pick<result.FourBar, "type" | "residual"> & {
    input?: Dyad;
    output?: Dyad;
    lengths?: Readonly<Record<string, number>>;
  };
type Merged<Reply, Record> = Omit<Reply, "record" | "input" | "output"> & {record: Record; input?: Dyad; output?: Dyad};
/** What `linkage` and `best` reply, of any kind. */
export type LinkageReply = Merged<told.LinkageReply, LinkageRecord | null>;
export type RankedReply = Merged<told.RankedReply, LinkageRecord>;

const nowhere: Axis = [0, 0, 0];
const no_defects: Defects = {order: false, branch: false, circuit: false};

const longest = (lengths: Record<string, number>) => Object.values(lengths).reduce((a, b) => Math.max(a, b));
const shortest = (lengths: Record<string, number>) => Object.values(lengths).reduce((a, b) => Math.min(a, b));
const ratio = (lengths: Record<string, number>) => longest(lengths) / shortest(lengths);

function link_between(coordinate: number, center: Point, circle: Point): GroundedLink {
  return {
    coordinate,
    center,
    circle,
    center_homogeneous: [1, ...center],
    circle_homogeneous: [1, ...circle],
    length: Math.hypot(circle[0] - center[0], circle[1] - center[1]),
  };
}

function link_of(coordinate: number, dyad: Dyad | undefined): GroundedLink {
  const center = dyad?.center_point ?? null,
    circle = dyad?.circle_point ?? null;
  return {
    coordinate,
    center,
    circle,
    center_homogeneous: [...(dyad?.center_homogeneous ?? dyad?.fixed_axis ?? nowhere)],
    circle_homogeneous: [...(dyad?.circle_homogeneous ?? dyad?.moving_axis ?? nowhere)],
    length: center && circle && link_between(coordinate, center, circle).length,
  };
}

function links_of({tau, record, ...reply}: LinkageReply): Pick<Linkage, "input" | "output"> {
  const {pivots, added} = record ?? {};
  if (pivots)
    return {
      input: link_between(tau[0], pivots.input_fixed, pivots.input_moving),
      output: link_between(tau[1], pivots.output_fixed, pivots.output_moving),
    };
  if (added)
    return {input: link_between(tau[0], ...added[0]!.points), output: link_between(tau[1], ...added[1]!.points)};
  const links = reply.input ? reply : (record ?? reply);
  return {input: link_of(tau[0], links.input), output: link_of(tau[1], links.output)};
}

function sizes_of(record: LinkageRecord | null): Pick<Linkage, "lengths" | "link_ratio" | "longest"> {
  const {lengths, joints} = record ?? {};
  if (!lengths) return {lengths: null, link_ratio: null, longest: null};
  if (joints) return {lengths: null, link_ratio: record!.link_ratio ?? null, longest: longest(lengths)};
  const {ground, input, coupler, output} = lengths as NonNullable<Linkage["lengths"]>,
    bars = {ground, input, coupler, output};
  return {lengths: bars, link_ratio: record!.link_ratio ?? ratio(bars), longest: longest(bars)};
}

/** User's unit; about a centre as it is. */
function residual_of({input, output, lengths, joints, residual}: LinkageRecord): number {
  if (!lengths) return residual;
  if (joints) return residual * longest(lengths);
  if (!input || !output) return residual;
  return Math.max(input.residual * lengths.input!, output.residual * lengths.output!);
}

function function_of(record: LinkageRecord | null, reply: LinkageReply): Linkage["function"] {
  if (!record?.errors_at_pairs_deg || !reply.pairs_deg) return null;
  const {errors_at_pairs_deg, error_curve} = record;
  return {
    pairs: reply.pairs_deg.map(([input, output], j) => [input, output, errors_at_pairs_deg[j]!]),
    precision_error_deg: record.precision_error_deg!,
    reaches_pairs: reply.reaches_pairs!,
    max_structural_error_deg: record.max_structural_error_deg ?? null,
    worst_input_deg: record.worst_input_deg ?? null,
    unreached_deg: record.unreached_deg!,
    curve: (error_curve?.input_deg ?? []).map((input, i) => {
      const wanted = error_curve!.wanted_output_deg[i]!,
        error = error_curve!.error_deg[i]!;
      return [input, wanted, error === null ? null : wanted + error];
    }),
  };
}

function six_bar_of({topology, joints, lengths}: LinkageRecord, bodies: readonly (readonly number[])[]): object {
  return {
    topology,
    joints: Object.entries(joints!).map(([name, at], i) => ({name, ground: bodies[0]!.includes(i), at})),
    bodies,
    lengths: Object.entries(lengths!).map(([name, length]) => ({name, length})),
  };
}

function spherical_of({angles_deg, triple_rocker, input, output}: LinkageRecord, min_link_angle_deg: number): object {
  return {
    angles_deg,
    min_link_angle_deg,
    triple_rocker: triple_rocker ?? null,
    input_fixed: input!.fixed_axis,
    input_moving: input!.moving_axis,
    output_moving: output!.moving_axis,
    output_fixed: output!.fixed_axis,
  };
}

function straight_line_of(record: LinkageRecord, {strip_middle, profile}: LinkageReply): object {
  const {point_to_input, point_to_output} = record.lengths!;
  return {
    ...record,
    layer_name: record.layer_name ?? "",
    point: record.pivots!.point,
    point_to_input,
    point_to_output,
    longest: longest(record.lengths!),
    strip_middle,
    profile,
  };
}

function path_of(record: LinkageRecord, layers: LinkageReply["layers"]): object {
  const {point_to_input, point_to_output} = record.lengths!;
  return {...record, point_to_input, point_to_output, ...(layers && {layers})};
}

/** What only some kinds have. */
function of_kind(reply: LinkageReply): object {
  const {record, bodies, rates, min_link_angle_deg} = reply;
  return {
    ...(record?.miss && {miss: {...record.miss, input_deg: reply.miss_input_deg}}),
    ...(record && bodies && {six_bar: six_bar_of(record, bodies)}),
    ...(record && min_link_angle_deg !== undefined && {spherical: spherical_of(record, min_link_angle_deg)}),
    ...(record?.pivots && {straight_line: straight_line_of(record, reply)}),
    ...(record?.point && {path: path_of(record, reply.layers)}),
    ...(rates !== undefined && {rates}),
  };
}

/** But for the states of its drive. */
export function linkage_of(
  reply: LinkageReply,
): Omit<Linkage, "drive"> & {drive: Omit<NonNullable<Linkage["drive"]>, "states"> | null} {
  const {tau, fails, reason, record, travel} = reply,
    driver: Partial<told.Driver> = reply.driven ?? record ?? {},
    {dead_points_deg, ...drive} = travel ?? {dead_points_deg: []};
  const swapped = reply.swapped ?? record?.swapped;
  return {
    tau,
    type: record?.type ?? "degenerate",
    defects: driver.defects ?? no_defects,
    reason,
    ...links_of(reply),
    ...sizes_of(record),
    min_transmission_angle_deg: driver.min_transmission_angle_deg ?? null,
    min_transmission_angle_full_turn_deg: driver.min_transmission_angle_full_turn_deg ?? null,
    driver_sweep_deg: driver.driver_sweep_deg ?? null,
    drive_sense: driver.drive ?? null,
    dead_points_deg,
    residual: record ? residual_of(record) : 0,
    swapped: swapped
      ? {
          type: swapped.type,
          defects: swapped.defects,
          min_transmission_angle_deg: swapped.min_transmission_angle_deg,
        }
      : null,
    function: function_of(record, reply),
    fails,
    ...(record?.near ? {near: record.near} : {}),
    ...of_kind(reply),
    drive: travel && (drive as Omit<NonNullable<Linkage["drive"]>, "states">),
  };
}

function pivots_of({pivots, joints, input, output}: LinkageRecord): Pivot[] {
  if (pivots) return [pivots.input_fixed, pivots.input_moving, pivots.output_fixed, pivots.output_moving, pivots.point];
  if (joints) return Object.values(joints);
  return [input!, output!].flatMap((link) => [
    (link.center_point ?? link.fixed_axis)!,
    (link.circle_point ?? link.moving_axis)!,
  ]);
}

export function ranked_of({tau, record, chain, min_link_angle_deg, ...reply}: RankedReply): Ranked {
  const {type, lengths, min_transmission_angle_deg, link_ratio, max_structural_error_deg} = record,
    ranked = {
      tau,
      type,
      min_transmission_angle_deg: min_transmission_angle_deg!,
      link_ratio: link_ratio ?? (lengths ? ratio(lengths) : null),
      longest: lengths ? longest(lengths) : null,
      pivots: pivots_of(record),
    };
  if (chain) return {...ranked, chain} as Ranked;
  if (record.angles_deg)
    return {...ranked, min_link_angle_deg, driver_sweep_deg: record.driver_sweep_deg, max_structural_error_deg: null};
  if (!record.pivots)
    return {
      ...ranked,
      max_structural_error_deg: max_structural_error_deg ?? null,
      [record.near ? "near_error" : "path_error"]: reply.near_error ?? null,
      path: reply.path ?? null,
    } as Ranked;
  const line = {
    ...ranked,
    usable_stroke: record.usable!.length,
    usable_strip: record.usable_strip!.length,
    stroke_over_longest: record.stroke_over_longest,
    deviation: reply.deviation,
    velocity_nonuniformity: (record.stroke ?? record.over_usable!).velocity_nonuniformity,
  };
  return record.task ? ({...line, straight_line: {task: record.task, window: reply.window}} as Ranked) : line;
}
