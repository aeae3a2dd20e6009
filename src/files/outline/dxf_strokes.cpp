// Debian's DXF library writes beyond its memory where a polyline says that it has 2^30 vertices: the groups are read
// here.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "dxf_groups.hpp"
#include "dxf_spline.hpp"
#include "files/text/plain_text.hpp"
#include "linkwright/files/length_unit.hpp"
#include "strokes.hpp"

namespace linkwright {
namespace {

using Place = std::function<Point(Point)>;
constexpr int deepest_insert = 16;
constexpr double whole_turn = 2 * std::numbers::pi, degree = std::numbers::pi / 180;

/// Mirrored things are drawn with their normal downwards: then x counts the other way.
double side_of(const DxfEntity& entity) { return entity.number(230, 1) < 0 ? -1 : 1; }

Point point_of(const DxfEntity& entity, int code, double otherwise = DxfEntity::nothing) {
  return {entity.number(code, otherwise), entity.number(code + 10, otherwise)};
}

/// As far as from `from` on to `to`, turning left.
double left_turn(double from, double to) {
  const double turn = std::fmod(to - from, whole_turn);
  return turn > 1e-9 ? turn : turn + whole_turn;
}

std::vector<Point> arc_points(const DxfEntity& arc, double from, double to, const Place& place) {
  const double turn = left_turn(from, to), r = arc.number(40);
  const Point center = point_of(arc, 10);
  const auto at = [&](double angle) { return place(center + r * direction(angle)); };
  const double pieces = std::ceil(8 * turn / whole_turn);
  return flattened(at, from, from + turn, pieces >= 1 ? static_cast<int>(pieces) : 1);
}

/// A bulge is the tangent of a quarter of the angle of the arc to the next vertex, positive to the left.
std::vector<Point> bulge_arc(Point a, Point b, double bulge) {
  const double turn = 4 * std::atan(bulge), lift = (1 - bulge * bulge) / (4 * bulge);  // of the centre, in chords
  const Point center = (a + b) / 2.0 + lift * Point{-(b - a).imag(), (b - a).real()}, arm = a - center;
  const double from = std::arg(arm), r = std::abs(arm);
  return flattened([&](double angle) { return center + r * direction(angle); }, from, from + turn);
}

struct Vertex {
  Point at;
  double bulge = 0;
};

std::vector<Point> with_bulges(const std::vector<Vertex>& vertices, bool closed) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    points.push_back(vertices[i].at);
    const double bulge = vertices[i].bulge;
    if ((i + 1 == vertices.size() && !closed) || bulge == 0 || !std::isfinite(bulge)) continue;
    const std::vector<Point> arc = bulge_arc(vertices[i].at, vertices[(i + 1) % vertices.size()].at, bulge);
    points.insert(points.end(), arc.begin() + 1, arc.end() - 1);
  }
  return points;
}

std::vector<Vertex> vertices_of(const DxfEntity& polyline) {
  std::vector<Vertex> vertices;
  for (const DxfGroup& group : polyline.groups) {
    if (group.code == 10) vertices.push_back({leading_number(group.value)});
    if (vertices.empty()) continue;
    if (group.code == 20) vertices.back().at.imag(leading_number(group.value));
    if (group.code == 42) vertices.back().bulge = leading_number(group.value);
  }
  return vertices;
}

/// Draws the entities of a file, what its blocks hold in their place.
class DxfPainter {
 public:
  explicit DxfPainter(const DxfFile& file) : file_(file) {}

  Result<Strokes> strokes() {
    draw(
        file_.entities, [](Point p) { return p; }, 0);
    if (collector_.is_full()) return drawing_of_too_much();
    const auto unit = length_unit(file_.unit);
    return Strokes{collector_.take(), unit ? std::optional(unit->mm) : std::nullopt, std::nullopt};
  }

 private:
  void draw(const std::vector<DxfEntity>& entities, const Place& place, int nested) {
    if (nested > deepest_insert) return collector_.refuse();
    for (std::size_t i = 0; i < entities.size(); ++i) {
      const DxfEntity& entity = entities[i];
      if (entity.type == "VERTEX" || entity.type == "SEQEND") continue;
      if (!collector_.step()) return;
      if (entity.number(60, 0) != 0 || entity.number(67, 0) != 0) continue;  // hidden, or on paper only
      if (entity.type == "INSERT")
        insert(entity, place, nested);
      else if (entity.type == "POLYLINE")
        draw_old_polyline(entities, i, place);
      else
        draw_entity(entity, place);
    }
  }

  /// Rows and columns turn with a block, but are not scaled.
  void insert(const DxfEntity& insert, const Place& place, int nested) {
    const auto found = file_.blocks.find(insert.text(2));
    if (found == file_.blocks.end()) return;
    const DxfBlock& block = found->second;
    const Point base{block.x, block.y}, origin = point_of(insert, 10, 0);
    const Point turn = direction(insert.number(50, 0) * degree);
    const double sx = insert.number(41, 1), sy = insert.number(42, 1), side = side_of(insert);
    const int columns = std::max(insert.whole_number(70), 1), rows = std::max(insert.whole_number(71), 1);
    const Point spacing{insert.number(44, 0), insert.number(45, 0)};
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column) {
        if (!collector_.step()) return;  // an empty block may be wanted a billion times
        const auto copy = [&](Point p) {
          const Point local = p - base;
          const Point at = origin + turn * Point{local.real() * sx + column * spacing.real(),
                                                 local.imag() * sy + row * spacing.imag()};
          return place({side * at.real(), at.imag()});
        };
        draw(block.entities, copy, nested + 1);
      }
  }

  /// Its vertices are the entities that follow.
  void draw_old_polyline(const std::vector<DxfEntity>& entities, std::size_t polyline, const Place& outer) {
    constexpr int closed = 1, mesh = 16, faces = 64;
    const int flags = entities[polyline].whole_number(70);
    if (flags & (mesh | faces)) return;
    std::vector<Vertex> vertices;
    for (std::size_t i = polyline + 1; i < entities.size() && entities[i].type == "VERTEX"; ++i)
      vertices.push_back({point_of(entities[i], 10, 0), entities[i].number(42, 0)});
    draw_polyline(vertices, (flags & closed) != 0, entities[polyline], outer);
  }
  void draw_polyline(const std::vector<Vertex>& vertices, bool closed, const DxfEntity& entity, const Place& outer) {
    std::vector<Point> points = with_bulges(vertices, closed);
    const double side = side_of(entity);
    for (Point& p : points) p = outer({side * p.real(), p.imag()});
    collector_.add(points, closed);
  }

  void draw_entity(const DxfEntity& entity, const Place& outer) {
    const double side = side_of(entity);
    const auto place = [&](Point p) { return outer({side * p.real(), p.imag()}); };
    if (entity.type == "LINE") {
      collector_.add(std::vector{outer(point_of(entity, 10)), outer(point_of(entity, 11))}, false);
    } else if (entity.type == "LWPOLYLINE") {
      draw_polyline(vertices_of(entity), (entity.whole_number(70) & 1) != 0, entity, outer);
    } else if (entity.type == "CIRCLE") {
      std::vector<Point> points = arc_points(entity, 0, whole_turn, place);
      points.pop_back();
      collector_.add(points, true);
    } else if (entity.type == "ARC") {
      const auto angle = [&](int code) { return entity.number(code) / 180 * std::numbers::pi; };
      collector_.add(arc_points(entity, angle(50), angle(51), place), false);
    } else if (entity.type == "ELLIPSE") {
      draw_ellipse(entity, outer, side);
    } else if (entity.type == "SPLINE") {
      collector_.add(spline_points(entity, outer, collector_), (entity.whole_number(70) & 1) != 0);
    }
  }

  /// The centre and the axis are in the drawing's own frame; the normal says only which way the other axis lies.
  void draw_ellipse(const DxfEntity& ellipse, const Place& place, double side) {
    const double from = ellipse.number(41, 0), turn = left_turn(from, ellipse.number(42, whole_turn));
    const double ratio = side * ellipse.number(40);
    const Point center = point_of(ellipse, 10), axis = point_of(ellipse, 11);
    const auto at = [&](double angle) {
      return place(center + axis * Point{std::cos(angle), ratio * std::sin(angle)});
    };
    std::vector<Point> points = flattened(at, from, from + turn, 8);
    const bool is_whole = std::abs(turn - whole_turn) < 1e-6;
    if (is_whole) points.pop_back();
    collector_.add(points, is_whole);
  }

  const DxfFile& file_;
  StrokeCollector collector_;
};

}  // namespace

Result<Strokes> dxf_strokes(std::string_view text) {
  if (text.starts_with("AutoCAD Binary DXF"))
    return Error{"binary_dxf", "", "this is a binary DXF file; save it as ASCII DXF"};
  const auto file = read_dxf(text);
  return file ? DxfPainter(*file).strokes() : Result<Strokes>(file.errors());
}

}  // namespace linkwright
