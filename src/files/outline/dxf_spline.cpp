#include "dxf_spline.hpp"

#include <algorithm>
#include <cmath>

#include "files/text/plain_text.hpp"

namespace linkwright {
namespace {

struct Homogeneous {
  Point at;  ///< times the weight
  double weight;
};

struct Spline {
  std::size_t degree = 0;
  std::vector<Homogeneous> controls;
  std::vector<double> knots;
};

Spline spline_of(const DxfEntity& entity) {
  Spline spline;
  std::vector<Point> points;
  std::vector<double> weights;
  for (const DxfGroup& group : entity.groups) {
    const double number = leading_number(group.value);
    if (group.code == 40) spline.knots.push_back(number);
    if (group.code == 41) weights.push_back(number);
    if (group.code == 10) points.emplace_back(number, 0);
    if (group.code == 20 && !points.empty()) points.back().imag(number);
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double weight = i < weights.size() ? weights[i] : 1;
    spline.controls.push_back({weight * points[i], weight});
  }
  const double degree = entity.number(71);
  spline.degree = degree >= 1 && degree <= 11 ? static_cast<std::size_t>(degree) : 0;
  return spline;
}

bool is_sound(const Spline& spline) {
  return spline.degree > 0 && spline.controls.size() > spline.degree &&
         spline.knots.size() == spline.controls.size() + spline.degree + 1 &&
         std::all_of(spline.knots.begin(), spline.knots.end(), [](double knot) { return std::isfinite(knot); }) &&
         std::is_sorted(spline.knots.begin(), spline.knots.end());
}

/// De Boor's algorithm on the span of knots that begins at `span`.
Point de_boor(const Spline& spline, std::size_t span, double t) {
  const std::size_t p = spline.degree;
  std::vector<Homogeneous> d(spline.controls.begin() + static_cast<std::ptrdiff_t>(span - p),
                             spline.controls.begin() + static_cast<std::ptrdiff_t>(span + 1));
  for (std::size_t level = 1; level <= p; ++level)
    for (std::size_t j = p; j >= level; --j) {
      const double low = spline.knots[j + span - p], high = spline.knots[j + 1 + span - level];
      const double share = high > low ? (t - low) / (high - low) : 0;
      d[j].at = d[j - 1].at + (d[j].at - d[j - 1].at) * share;
      d[j].weight = d[j - 1].weight + (d[j].weight - d[j - 1].weight) * share;
    }
  return d[p].at / d[p].weight;
}

}  // namespace

std::vector<Point> spline_points(const DxfEntity& entity, const std::function<Point(Point)>& place,
                                 StrokeCollector& collector) {
  const Spline spline = spline_of(entity);
  std::vector<Point> points;
  if (!is_sound(spline)) return points;
  for (std::size_t span = spline.degree; span < spline.controls.size(); ++span) {
    const double from = spline.knots[span], to = spline.knots[span + 1];
    if (!(to > from)) continue;
    if (!collector.step()) return points;
    const std::vector<Point> piece = flattened([&](double t) { return place(de_boor(spline, span, t)); }, from, to);
    points.insert(points.end(), piece.begin() + (points.empty() ? 0 : 1), piece.end());
  }
  return points;
}

}  // namespace linkwright
