#include "shapes.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <numbers>
#include <unordered_set>

#include "chains.hpp"

namespace linkwright {
namespace {

constexpr std::size_t most_shapes = 24;

struct Bounds {
  double left, right, bottom, top;
};

Bounds bounds(const std::vector<Point>& points) {
  Bounds box{points[0].real(), points[0].real(), points[0].imag(), points[0].imag()};
  for (const Point p : points) {
    box.left = std::min(box.left, p.real());
    box.right = std::max(box.right, p.real());
    box.bottom = std::min(box.bottom, p.imag());
    box.top = std::max(box.top, p.imag());
  }
  return box;
}

double area(const DrawnShape& shape) { return shape.width * shape.height; }

bool is_straight(const std::vector<Point>& points) {
  const double near = 1e-9 * size_of(points);
  return std::all_of(points.begin(), points.end(),
                     [&](Point p) { return off_chord(p, points.front(), points.back()) <= near; });
}

std::optional<DrawnShape> shape_of(Stroke stroke) {
  DrawnShape shape{std::move(stroke.points), stroke.closed};
  std::vector<Point>& corners = shape.corners;
  const bool meets = corners.size() > 3 && std::abs(corners.front() - corners.back()) <= 1e-9 * size_of(corners);
  if (meets) corners.pop_back();
  if (corners.size() < 3) return std::nullopt;
  shape.closed = shape.closed || meets;
  const Bounds box = bounds(corners);
  shape.width = box.right - box.left;
  shape.height = box.top - box.bottom;
  const bool is_thin = !(std::min(shape.width, shape.height) > 1e-6 * std::max(shape.width, shape.height));
  if (is_thin && is_straight(corners)) return std::nullopt;
  return shape;
}

/// A filled shape and its edge are often drawn one over the other: the same box at four decimals of its size.
void leave_out_doubles(std::vector<DrawnShape>& shapes) {
  std::unordered_set<std::string> seen;
  std::erase_if(shapes, [&](const DrawnShape& shape) {
    const Bounds box = bounds(shape.corners);
    const double size = shape.width + shape.height;
    const auto key = fmt::format("{:.4f},{:.4f},{:.4f},{:.4f},{},{}", box.left / size, box.right / size,
                                 box.bottom / size, box.top / size, shape.corners.size(), shape.closed);
    return !seen.insert(key).second;
  });
}

bool is_rectangle(const DrawnShape& shape) {
  if (!shape.closed || shape.corners.size() != 4) return false;
  const double near = 1e-4 * (shape.width + shape.height);
  for (std::size_t i = 0; i < 4; ++i) {
    const Point side = shape.corners[(i + 1) % 4] - shape.corners[i];
    if (!(std::abs(side.real()) < near || std::abs(side.imag()) < near)) return false;
  }
  return true;
}

bool contains(const DrawnShape& outer, const DrawnShape& inner) {
  const Bounds a = bounds(outer.corners), b = bounds(inner.corners);
  const double near = 1e-4 * (outer.width + outer.height);
  return a.left - near <= b.left && b.right <= a.right + near && a.bottom - near <= b.bottom && b.top <= a.top + near;
}

bool has_sheet_ratio(const DrawnShape& shape) {
  // ISO; A4 within its border; ANSI.
  constexpr std::array ratios = {std::numbers::sqrt2, 277.0 / 180, 11 / 8.5, 17.0 / 11};
  const double ratio = std::max(shape.width, shape.height) / std::min(shape.width, shape.height);
  return std::any_of(ratios.begin(), ratios.end(), [&](double of) { return std::abs(ratio / of - 1) < 0.015; });
}

/// From the outside in: an upright rectangle around all else that has a sheet's proportions, lies along the edge of the
/// declared sheet, or along another frame. A lone rectangle is a part. The largest shape comes first.
void tell_frames(std::vector<DrawnShape>& shapes, std::optional<Extent> sheet) {
  for (std::size_t i = 0; i + 1 < shapes.size(); ++i) {
    DrawnShape& shape = shapes[i];
    const auto is_inside = [&](const DrawnShape& other) { return contains(shape, other); };
    if (!is_rectangle(shape) ||
        !std::all_of(shapes.begin() + static_cast<std::ptrdiff_t>(i) + 1, shapes.end(), is_inside))
      return;
    const bool lies_along = sheet && shape.width > 0.85 * sheet->width && shape.height > 0.85 * sheet->height;
    if (!has_sheet_ratio(shape) && !lies_along) return;
    shape.frame = true;
    sheet = {shape.width, shape.height};
  }
}

/// Ramer's algorithm on an open line: which of its points stay, both ends among them.
void keep_far_ones(const std::vector<Point>& points, std::size_t from, std::size_t to, double tolerance,
                   std::vector<bool>& kept) {
  std::vector<std::pair<std::size_t, std::size_t>> waiting{{from, to}};
  while (!waiting.empty()) {
    const auto [first, last] = waiting.back();
    waiting.pop_back();
    kept[first] = kept[last] = true;
    std::size_t farthest = first;
    double most = tolerance;
    for (std::size_t i = first + 1; i < last; ++i)
      if (const double distance = off_chord(points[i], points[first], points[last]); distance > most) {
        most = distance;
        farthest = i;
      }
    if (farthest == first) continue;
    waiting.push_back({first, farthest});
    waiting.push_back({farthest, last});
  }
}

/// Of a closed line, cut at two corners far apart.
std::vector<Point> within(std::vector<Point> points, double tolerance) {
  const auto away = [&](Point p) { return std::abs(p - points.front()); };
  const auto far = static_cast<std::size_t>(
      std::max_element(points.begin(), points.end(), [&](Point a, Point b) { return away(a) < away(b); }) -
      points.begin());
  points.push_back(points.front());
  std::vector<bool> kept(points.size(), false);
  keep_far_ones(points, 0, far, tolerance, kept);
  keep_far_ones(points, far, points.size() - 1, tolerance, kept);
  std::vector<Point> corners;
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    if (kept[i]) corners.push_back(points[i]);
  return corners;
}

}  // namespace

std::vector<DrawnShape> shapes_of(Strokes strokes) {
  std::vector<DrawnShape> shapes;
  for (Stroke& stroke : chained(std::move(strokes.list)))
    if (auto shape = shape_of(std::move(stroke))) shapes.push_back(*std::move(shape));
  std::stable_sort(shapes.begin(), shapes.end(),
                   [](const DrawnShape& a, const DrawnShape& b) { return area(a) > area(b); });
  leave_out_doubles(shapes);
  tell_frames(shapes, strokes.sheet);
  const auto rank = [](const DrawnShape& shape) { return shape.frame ? 2 : shape.closed ? 0 : 1; };
  std::stable_sort(shapes.begin(), shapes.end(),
                   [&](const DrawnShape& a, const DrawnShape& b) { return rank(a) < rank(b); });
  if (shapes.size() > most_shapes) shapes.resize(most_shapes);
  return shapes;
}

std::vector<Point> simplified(const std::vector<Point>& corners) {
  constexpr std::size_t most_corners = 200, most_looked_at = 4000;  // of n the tolerance takes n² steps
  const std::size_t every = std::max<std::size_t>(1, (corners.size() + most_looked_at - 1) / most_looked_at);
  std::vector<Point> looked_at;
  for (std::size_t i = 0; i < corners.size(); i += every) looked_at.push_back(corners[i]);
  std::vector<Point> kept = looked_at;
  for (double tolerance = 1e-4 * size_of(corners); kept.size() > most_corners; tolerance *= 1.5)
    kept = within(looked_at, tolerance);
  return kept;
}

}  // namespace linkwright
