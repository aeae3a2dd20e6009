#include "machine/flat_pattern.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "linkwright/core/angle.hpp"

namespace linkwright {
namespace {

/// Numbers points; those that differ by rounding only are one.
class Corners {
 public:
  explicit Corners(double size) : grain_(1e-9 * size) {}

  int number(Point point) {
    const std::pair<long long, long long> cell{std::llround(point.real() / grain_),
                                               std::llround(point.imag() / grain_)};
    for (long long dx = -1; dx <= 1; ++dx)
      for (long long dy = -1; dy <= 1; ++dy)
        if (const auto found = numbers_.find({cell.first + dx, cell.second + dy}); found != numbers_.end())
          return found->second;
    numbers_[cell] = static_cast<int>(points_.size());
    points_.push_back(point);
    return static_cast<int>(points_.size()) - 1;
  }
  std::vector<Point> take() { return std::move(points_); }

 private:
  double grain_;
  std::map<std::pair<long long, long long>, int> numbers_;
  std::vector<Point> points_;
};

/// What of a convex polygon is nearer to one site than to the other. (I. E. Sutherland, G. W. Hodgman, Reentrant
/// polygon clipping, 1974.)
std::vector<Point> nearer(const std::vector<Point>& polygon, Point site, Point other) {
  const Point middle = (site + other) / 2.0, away = other - site;
  const auto beyond = [&](Point p) { return dot(p - middle, away); };
  std::vector<Point> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    const double at_a = beyond(a), at_b = beyond(b);
    if (at_a <= 0) kept.push_back(a);
    if ((at_a < 0 && at_b > 0) || (at_a > 0 && at_b < 0)) kept.push_back(a + at_a / (at_a - at_b) * (b - a));
  }
  return kept;
}

/// Corner numbers without repetitions, in their order.
std::vector<int> numbered(Corners& corners, const std::vector<Point>& points) {
  std::vector<int> numbers;
  for (const Point point : points) {
    const int number = corners.number(point);
    if (numbers.empty() || numbers.back() != number) numbers.push_back(number);
  }
  while (numbers.size() > 1 && numbers.front() == numbers.back()) numbers.pop_back();
  return numbers;
}

/// From the corner whose direction, seen from a site, comes first after −π.
void start_at_least_angle(std::vector<Point>& ring, Point site) {
  std::rotate(ring.begin(),
              std::min_element(ring.begin(), ring.end(),
                               [&](Point a, Point b) { return std::arg(a - site) < std::arg(b - site); }),
              ring.end());
}

/// Between a hole and what lies round it: of both rings the one whose next corner has turned less goes on.
void fill_ring(Corners& corners, std::vector<Point> outer, std::vector<Point> inner, Point site,
               std::vector<std::array<int, 3>>& triangles) {
  start_at_least_angle(outer, site);
  start_at_least_angle(inner, site);
  const std::vector<int> out = numbered(corners, outer), in = numbered(corners, inner);
  const auto angle = [&](const std::vector<Point>& ring, std::size_t k) {
    return std::arg(ring[k % ring.size()] - site) + (k >= ring.size() ? two_pi : 0);
  };
  std::size_t o = 0, i = 0;
  while (o < out.size() || i < in.size()) {
    const int from_out = out[o % out.size()], from_in = in[i % in.size()];
    const bool outer_goes = i == in.size() || (o < out.size() && angle(outer, o + 1) <= angle(inner, i + 1));
    if (outer_goes)
      triangles.push_back({from_in, from_out, out[++o % out.size()]});
    else
      triangles.push_back({from_in, from_out, in[++i % in.size()]});
  }
}

void fill_fan(Corners& corners, const std::vector<Point>& rim, Point site, std::vector<std::array<int, 3>>& triangles) {
  const std::vector<int> out = numbered(corners, rim);
  const int middle = corners.number(site);
  for (std::size_t k = 0; k < out.size(); ++k) triangles.push_back({middle, out[k], out[(k + 1) % out.size()]});
}

/// Every corner of a neighbour on an edge is a corner of this polygon, too.
void meet_neighbours(std::vector<Point>& cell, const std::vector<Point>& all, double grain) {
  std::vector<Point> met;
  for (std::size_t i = 0; i < cell.size(); ++i) {
    const Point a = cell[i], b = cell[(i + 1) % cell.size()], along = b - a;
    met.push_back(a);
    std::vector<std::pair<double, Point>> between;
    for (const Point point : all) {
      const double share = dot(point - a, along) / std::norm(along);
      if (share > 0 && share < 1 && std::abs(point - a) > grain && std::abs(point - b) > grain &&
          std::abs(cross(along, point - a)) < grain * std::abs(along))
        between.emplace_back(share, point);
    }
    std::sort(between.begin(), between.end(),
              [](const auto& one, const auto& other) { return one.first < other.first; });
    for (const auto& [share, point] : between) met.push_back(point);
  }
  cell = std::move(met);
}

}  // namespace

FlatPattern flat_pattern(const std::vector<Point>& outline, const std::vector<PatternSite>& sites) {
  double size = 0;
  for (const Point point : outline) size = std::max(size, std::abs(point - outline.front()));
  std::vector<std::vector<Point>> cells;
  std::vector<Point> all;
  for (const PatternSite& site : sites) {
    cells.push_back(outline);
    for (const PatternSite& other : sites)
      if (&other != &site) cells.back() = nearer(cells.back(), site.at, other.at);
    all.insert(all.end(), cells.back().begin(), cells.back().end());
  }
  Corners corners(size);
  FlatPattern pattern;
  for (std::size_t k = 0; k < sites.size(); ++k) {
    meet_neighbours(cells[k], all, 1e-9 * size);
    if (sites[k].hole.empty())
      fill_fan(corners, cells[k], sites[k].at, pattern.triangles);
    else
      fill_ring(corners, cells[k], sites[k].hole, sites[k].at, pattern.triangles);
  }
  pattern.points = corners.take();
  return pattern;
}

FlatPattern with_short_edges(FlatPattern pattern, double longest) {
  const auto too_long = [&](const std::array<int, 3>& t) {
    const auto at = [&](std::size_t k) { return pattern.points[static_cast<std::size_t>(t[k])]; };
    return std::max({std::abs(at(1) - at(0)), std::abs(at(2) - at(1)), std::abs(at(0) - at(2))}) > longest;
  };
  while (std::any_of(pattern.triangles.begin(), pattern.triangles.end(), too_long)) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
      const auto [found, is_new] = middles.try_emplace(std::minmax(a, b), static_cast<int>(pattern.points.size()));
      if (is_new)
        pattern.points.push_back(
            (pattern.points[static_cast<std::size_t>(a)] + pattern.points[static_cast<std::size_t>(b)]) / 2.0);
      return found->second;
    };
    std::vector<std::array<int, 3>> finer;
    for (const auto& [a, b, c] : pattern.triangles) {
      const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    pattern.triangles = std::move(finer);
  }
  return pattern;
}

std::vector<Point> circle(Point center, double radius, double turn) {
  const int chords = std::max(3, static_cast<int>(std::ceil(two_pi / turn)));
  std::vector<Point> points;
  for (int k = 0; k < chords; ++k) points.push_back(center + radius * direction(two_pi * k / chords));
  return points;
}

std::vector<Point> rounded(const std::vector<Point>& polygon, double radius, double turn) {
  std::vector<Point> rim;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point before = polygon[(i + polygon.size() - 1) % polygon.size()], here = polygon[i],
                after = polygon[(i + 1) % polygon.size()];
    const double from = std::arg(here - before) - pi / 2,
                 swept = wrap_positive(std::arg(after - here) - std::arg(here - before));
    const int chords = std::max(1, static_cast<int>(std::ceil(swept / turn)));
    for (int k = 0; k <= chords; ++k) rim.push_back(here + radius * direction(from + swept * k / chords));
  }
  return rim;
}

}  // namespace linkwright
