// The strokes of a DXF file. The library reads the groups; blocks, bulges and curves are drawn here, where the tolerance and
// the limits are ours.
import parse from "dxf/lib/parseString";
import type {DxfEntity, DxfInsert, DxfVertex} from "dxf/lib/parseString";
import type {Point} from "../../contract/messages";
import {flattened, Refused, Strokes, type Drawn} from "./strokes";

type Place = (point: Point) => Point;
const most_nested = 16;
const mm_of_insunits: Record<number, number> = {
  1: 25.4,
  2: 304.8,
  3: 1609344,
  4: 1,
  5: 10,
  6: 1000,
  7: 1e6,
  8: 25.4e-6,
  9: 0.0254,
  10: 914.4,
  13: 1e-3,
  14: 100,
};

export function read_dxf(text: string): Drawn {
  if (text.startsWith("AutoCAD Binary DXF")) throw new Refused("binary");
  const file = parsed(text),
    strokes = new Strokes();
  const blocks = new Map(file.blocks.map((block) => [block.name, block]));
  const draw = (entities: readonly DxfEntity[], place: Place, nested: number): void => {
    if (nested > most_nested) throw new Refused("huge");
    for (const entity of entities) {
      strokes.step();
      if (entity.visible === false || entity.paperSpace) continue;
      if (entity.type !== "INSERT") draw_entity(strokes, entity, place);
      else {
        const block = blocks.get(entity.block);
        if (!block?.entities) continue;
        const base: Point = [block.x ?? 0, block.y ?? 0];
        for (const copy of copies(entity)) {
          strokes.step(); // an empty block may be wanted a billion times
          draw(block.entities, (point) => place(copy(minus(point, base))), nested + 1);
        }
      }
    }
  };
  draw(file.entities, (point) => point, 0);
  return {strokes: strokes.list, unit_mm: mm_of_insunits[file.header.insUnits ?? 0] ?? null, sheet: null};
}
function parsed(text: string): ReturnType<typeof parse> {
  if (!/^\s*0\s*\r?\n?\s*SECTION\s*$/m.test(text)) throw new Refused("unreadable");
  try {
    return parse(text.replace(/^[ \t]+|[ \t]+$/gm, "")); // the library does not trim
  } catch {
    throw new Refused("unreadable");
  }
}
const minus = ([x, y]: Point, [dx, dy]: Point): Point => [x - dx, y - dy];
const radians = Math.PI / 180;

/** Where each copy of a block goes: rows and columns turn with it, but are not scaled. */
function* copies(insert: DxfInsert): Generator<Place> {
  const {x = 0, y = 0, rotation = 0, columnCount = 1, rowCount = 1, columnSpacing = 0, rowSpacing = 0} = insert;
  const [cos, sin] = [Math.cos(rotation * radians), Math.sin(rotation * radians)],
    [sx, sy] = [insert.scaleX ?? 1, insert.scaleY ?? 1],
    side = side_of(insert);
  for (let row = 0; row < Math.max(rowCount, 1); ++row)
    for (let column = 0; column < Math.max(columnCount, 1); ++column)
      yield ([px, py]) => {
        const u = px * sx + column * columnSpacing,
          v = py * sy + row * rowSpacing;
        return [side * (x + cos * u - sin * v), y + sin * u + cos * v];
      };
}
/** Mirrored things are drawn with their normal downwards: then x counts the other way. */
function side_of({extrusionZ = 1}: {extrusionZ?: number}): 1 | -1 {
  return extrusionZ < 0 ? -1 : 1;
}

function draw_entity(strokes: Strokes, entity: DxfEntity, outer: Place): void {
  const side = side_of(entity),
    place: Place = ([x, y]) => outer([side * x, y]);
  switch (entity.type) {
    case "LINE": {
      const {start, end} = entity;
      return strokes.add([outer([start.x, start.y]), outer([end.x, end.y])], false);
    }
    case "LWPOLYLINE":
    case "POLYLINE": {
      if (entity.polygonMesh || entity.polyfaceMesh) return;
      return strokes.add(with_bulges(entity.vertices, entity.closed === true).map(place), entity.closed === true);
    }
    case "CIRCLE":
      return strokes.add(arc_points(entity, 0, 2 * Math.PI, place).slice(0, -1), true);
    case "ARC":
      return strokes.add(arc_points(entity, entity.startAngle, entity.endAngle, place), false);
    case "ELLIPSE":
      return draw_ellipse(strokes, entity, outer, side);
    case "SPLINE":
      return draw_spline(strokes, entity, outer);
  }
}
/** As far as from `from` on to `to`, turning left. */
function left_turn(from: number, to: number): number {
  const turn = (to - from) % (2 * Math.PI);
  return turn > 1e-9 ? turn : turn + 2 * Math.PI;
}
function arc_points({x, y, r}: {x: number; y: number; r: number}, from: number, to: number, place: Place): Point[] {
  const turn = left_turn(from, to),
    at = (angle: number) => place([x + r * Math.cos(angle), y + r * Math.sin(angle)]);
  return flattened(at, from, from + turn, Math.ceil((8 * turn) / (2 * Math.PI)));
}
function draw_ellipse(
  strokes: Strokes,
  {x, y, majorX, majorY, axisRatio, startAngle = 0, endAngle = 2 * Math.PI}: DxfEntity & {type: "ELLIPSE"},
  place: Place,
  side: 1 | -1,
): void {
  // The centre and the axis are in the drawing's own frame; the normal says only which way the other axis lies.
  const turn = left_turn(startAngle, endAngle),
    whole = Math.abs(turn - 2 * Math.PI) < 1e-6,
    ratio = side * axisRatio;
  const at = (angle: number): Point => {
    const [u, v] = [Math.cos(angle), ratio * Math.sin(angle)];
    return place([x + u * majorX - v * majorY, y + u * majorY + v * majorX]);
  };
  const points = flattened(at, startAngle, startAngle + turn, 8);
  strokes.add(whole ? points.slice(0, -1) : points, whole);
}
/** A bulge is the tangent of a quarter of the angle of the arc to the next vertex, positive to the left. */
function with_bulges(vertices: readonly DxfVertex[], closed: boolean): Point[] {
  const points: Point[] = [];
  vertices.forEach((vertex, i) => {
    const {x = 0, y = 0, bulge = 0} = vertex,
      next = vertices[i + 1] ?? (closed ? vertices[0] : undefined);
    points.push([x, y]);
    if (next && bulge !== 0 && Number.isFinite(bulge))
      points.push(...bulge_arc([x, y], [next.x ?? 0, next.y ?? 0], bulge).slice(1, -1));
  });
  return points;
}
function bulge_arc(a: Point, b: Point, bulge: number): Point[] {
  const turn = 4 * Math.atan(bulge),
    lift = (1 - bulge * bulge) / (4 * bulge); // of the centre over the chord, in chords
  const [dx, dy] = minus(b, a),
    x = (a[0] + b[0]) / 2 - lift * dy,
    y = (a[1] + b[1]) / 2 + lift * dx;
  const from = Math.atan2(a[1] - y, a[0] - x),
    r = Math.hypot(a[0] - x, a[1] - y);
  return flattened((angle) => [x + r * Math.cos(angle), y + r * Math.sin(angle)], from, from + turn);
}

function draw_spline(strokes: Strokes, entity: DxfEntity & {type: "SPLINE"}, place: Place): void {
  const {controlPoints, knots, weights, degree} = entity,
    count = controlPoints.length;
  if (!(degree >= 1 && degree <= 11) || count <= degree || knots.length !== count + degree + 1) return;
  if (knots.some((knot, i) => !Number.isFinite(knot) || knot < (knots[i - 1] ?? -Infinity))) return;
  const homogeneous = controlPoints.map(({x, y}, i): Homogeneous => {
    const w = weights?.[i] ?? 1;
    return [w * x, w * y, w];
  });
  const spans = knots.slice(degree, count + 1).filter((knot, i, all) => i === 0 || knot > (all[i - 1] ?? knot));
  const points: Point[] = [];
  spans.slice(1).forEach((to, i) => {
    const from = spans[i] ?? to,
      at = (t: number) => place(de_boor(homogeneous, knots, degree, Math.min(Math.max(t, from), to)));
    points.push(...flattened(at, from, to).slice(points.length ? 1 : 0));
    strokes.step();
  });
  strokes.add(points, entity.closed === true);
}
type Homogeneous = readonly [number, number, number];

/** De Boor's algorithm on a rational spline. */
function de_boor(controls: readonly Homogeneous[], knots: readonly number[], degree: number, t: number): Point {
  let span = degree;
  while (span < controls.length - 1 && (knots[span + 1] ?? Infinity) <= t) ++span;
  const d = controls.slice(span - degree, span + 1);
  for (let level = 1; level <= degree; ++level)
    for (let j = degree; j >= level; --j) {
      const low = knots[j + span - degree] ?? 0,
        high = knots[j + 1 + span - level] ?? 0;
      const share = high > low ? (t - low) / (high - low) : 0,
        [a, b] = [d[j - 1], d[j]];
      if (a && b) d[j] = [mixed(a[0], b[0], share), mixed(a[1], b[1], share), mixed(a[2], b[2], share)];
    }
  const [x, y, w] = d[degree] ?? [NaN, NaN, 1];
  return [x / w, y / w];
}
const mixed = (a: number, b: number, share: number) => a + (b - a) * share;
