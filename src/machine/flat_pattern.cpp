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
  [[nodiscard]] Point at(int number) const { return points_[static_cast<std::size_t>(number)]; }
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

/// A ring of corners seen from a site: their numbers and angles, from the least angle on and round.
struct Ring {
  std::vector<int> numbers;
  std::vector<double> angles;

  [[nodiscard]] std::size_t size() const { return numbers.size(); }
  [[nodiscard]] int number(std::size_t k) const { return numbers[k % size()]; }
  [[nodiscard]] double angle(std::size_t k) const { return angles[k % size()] + (k >= size() ? two_pi : 0); }
};

Ring ring_of(Corners& corners, std::vector<Point> points, Point site) {
  const auto angle = [&](Point p) { return std::arg(p - site); };
  std::rotate(points.begin(),
              std::min_element(points.begin(), points.end(), [&](Point a, Point b) { return angle(a) < angle(b); }),
              points.end());
  Ring ring;
  ring.numbers = numbered(corners, points);
  for (const int number : ring.numbers) ring.angles.push_back(angle(corners.at(number)));
  return ring;
}

/// Between a hole and what lies round it: of both rings the one whose next corner has turned less goes on. Corners lie
/// so close on both that no triangle reaches across the hole (`finest`).
void fill_ring(Corners& corners, const std::vector<Point>& rim, const PatternSite& site,
               std::vector<std::array<int, 3>>& triangles) {
  const Ring out = ring_of(corners, rim, site.at), in = ring_of(corners, site.hole, site.at);
  std::size_t o = 0, i = 0;
  while (o < out.size() || i < in.size()) {
    const int from_out = out.number(o), from_in = in.number(i);
    const bool outer_goes = i == in.size() || (o < out.size() && out.angle(o + 1) <= in.angle(i + 1));
    if (outer_goes) {
      triangles.push_back({from_in, from_out, out.number(++o)});
    } else {
      triangles.push_back({from_in, from_out, in.number(++i)});
    }
  }
}

void fill_fan(Corners& corners, const std::vector<Point>& rim, Point site, std::vector<std::array<int, 3>>& triangles) {
  const std::vector<int> out = numbered(corners, rim);
  const int middle = corners.number(site);
  for (std::size_t k = 0; k < out.size(); ++k) triangles.push_back({middle, out[k], out[(k + 1) % out.size()]});
}

/// Longest edge of a rim round a hole, seen from the hole's middle, radians: holes fill up to 1 / 1.05 of the way to
/// their rim, and the tangent at a corner of theirs passes above rims less than acos(1 / 1.05) = 0.31 away.
constexpr double finest = 0.12;

std::vector<Point> with_short_chords(const std::vector<Point>& rim, Point site) {
  std::vector<Point> fine;
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const Point a = rim[i], b = rim[(i + 1) % rim.size()];
    const double seen = std::abs(std::arg((b - site) * std::conj(a - site)));
    const int pieces = std::max(1, static_cast<int>(std::ceil(seen / finest)));
    // Even in angle, not along the edge.
    for (int k = 0; k < pieces; ++k) {
      const Point ray = (a - site) * direction(std::arg((b - site) * std::conj(a - site)) * k / pieces);
      const double share = k == 0 ? 0 : cross(site - a, ray) / cross(b - a, ray);
      fine.push_back(a + share * (b - a));
    }
  }
  return fine;
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
    if (!site.hole.empty()) cells.back() = with_short_chords(cells.back(), site.at);
    all.insert(all.end(), cells.back().begin(), cells.back().end());
  }
  Corners corners(size);
  FlatPattern pattern;
  for (std::size_t k = 0; k < sites.size(); ++k) {
    meet_neighbours(cells[k], all, 1e-9 * size);
    if (sites[k].hole.empty())
      fill_fan(corners, cells[k], sites[k].at, pattern.triangles);
    else
      fill_ring(corners, cells[k], sites[k], pattern.triangles);
  }
  pattern.points = corners.take();
  return pattern;
}

FlatPattern with_short_edges(FlatPattern pattern, double longest) {
  const auto too_long = [&](const std::array<int, 3>& t) {
    const auto at = [&](std::size_t k) { return pattern.points[static_cast<std::size_t>(t[k])]; };
    return std::max({std::abs(at(1) - at(0)), std::abs(at(2) - at(1)), std::abs(at(0) - at(2))}) > longest;
  };
  constexpr int most_rounds = 5;
  for (int round = 0; round < most_rounds && std::any_of(pattern.triangles.begin(), pattern.triangles.end(), too_long);
       ++round) {
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
