#pragma once

#include <array>
#include <vector>

#include "linkwright/algebra/point.hpp"

namespace linkwright {

/// A region of the plane cut into triangles, counter-clockwise.
struct FlatPattern {
  std::vector<Point> points;
  std::vector<std::array<int, 3>> triangles;
};

/// Around a site lies what is nearer to it than to any other: a hole in its middle, or none.
struct PatternSite {
  Point at{};
  std::vector<Point> hole;  ///< counter-clockwise, round the site, nearer to it than half way to the next
};

/// A convex outline (counter-clockwise) less the holes of its sites, all of them inside.
[[nodiscard]] FlatPattern flat_pattern(const std::vector<Point>& outline, const std::vector<PatternSite>& sites);

/// The same region, each triangle cut into four until no edge is longer.
[[nodiscard]] FlatPattern with_short_edges(FlatPattern pattern, double longest);

/// A circle in chords of at most `turn` radians, counter-clockwise.
[[nodiscard]] std::vector<Point> circle(Point center, double radius, double turn);

/// All points nearer than `radius` to a convex polygon (counter-clockwise, two corners or more): its rim.
[[nodiscard]] std::vector<Point> rounded(const std::vector<Point>& polygon, double radius, double turn);

}  // namespace linkwright
