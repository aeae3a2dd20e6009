#pragma once

#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "linkwright/algebra/point.hpp"
#include "linkwright/core/result.hpp"
#include "linkwright/files/outline_file.hpp"

namespace linkwright {

/// A run of straight edges, y up, in the drawing's unit.
struct Stroke {
  std::vector<Point> points;
  bool closed = false;  ///< the last point joins to the first
};

struct Extent {
  double width = 0, height = 0;
};

/// What a drawing is made of, whatever its format.
struct Strokes {
  std::vector<Stroke> list;
  std::optional<double> unit_mm;
  std::optional<Extent> sheet;  ///< that the file declares
};

/// Collects the strokes of one file; after too many it takes no more.
class StrokeCollector {
 public:
  /// One thing of the file has been looked at, whether it is drawn or not; false where there are too many.
  bool step() { return !is_full() && ++steps_ <= most; }
  [[nodiscard]] bool is_full() const { return refused_ || steps_ > most || points_ > most; }
  /// The file is too deeply nested.
  void refuse() { refused_ = true; }
  /// Points that are no numbers are left out.
  void add(std::span<const Point> points, bool closed);
  [[nodiscard]] std::vector<Stroke> take() { return std::move(list_); }

 private:
  static constexpr std::size_t most = 100'000;
  std::vector<Stroke> list_;
  std::size_t steps_ = 0, points_ = 0;
  bool refused_ = false;
};

/// The larger side of the upright box around them.
[[nodiscard]] double size_of(std::span<const Point> points);

/// How far a point is from the straight line between two others, or from the nearer of them.
[[nodiscard]] double off_chord(Point point, Point from, Point to);

inline constexpr double flatness = 1e-3;  ///< of a curve's size: how far a chord may lie off it

/// Adds the points of a curve after that at `from`, that at `to` included.
template <class Curve>
void add_halved(std::vector<Point>& points, const Curve& curve, double from, Point start, double to, Point end,
                double tolerance, int halvings) {
  const double middle = (from + to) / 2;
  const Point half = curve(middle);
  const auto is_near = [&](double t) { return off_chord(curve(t), start, end) <= tolerance; };
  if (halvings == 0 ||
      (is_near((from + middle) / 2) && is_near((middle + to) / 2) && off_chord(half, start, end) <= tolerance)) {
    points.push_back(end);
    return;
  }
  add_halved(points, curve, from, start, middle, half, tolerance, halvings - 1);
  add_halved(points, curve, middle, half, to, end, tolerance, halvings - 1);
}

/// Points of a curve from one end of its parameter to the other, both ends in; `pieces`: how many it has at least.
template <class Curve>
std::vector<Point> flattened(const Curve& curve, double from, double to, int pieces = 4) {
  constexpr int most_halvings = 7;
  std::vector<Point> ends;
  const auto at = [&](int i) { return i == pieces ? to : from + (to - from) * i / pieces; };
  for (int i = 0; i <= pieces; ++i) ends.push_back(curve(at(i)));
  const double tolerance = flatness * size_of(ends);
  std::vector<Point> points{ends.front()};
  for (int i = 0; i < pieces; ++i)
    add_halved(points, curve, at(i), ends[static_cast<std::size_t>(i)], at(i + 1),
               ends[static_cast<std::size_t>(i) + 1], tolerance, most_halvings);
  return points;
}

/// The strokes of a file, or why they cannot be had; `drawing_of_too_much()` where a collector is full.
[[nodiscard]] Result<Strokes> dxf_strokes(std::string_view text);
[[nodiscard]] Result<Strokes> svg_strokes(const XmlElements& elements);

[[nodiscard]] Error unreadable_drawing(std::string code, std::string place, std::string_view reason);
[[nodiscard]] Error drawing_of_too_much();

}  // namespace linkwright
