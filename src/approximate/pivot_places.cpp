#include <cmath>

#include "approximate/curve_search.hpp"

namespace linkwright {
namespace {

double fraction(double x) { return x - std::floor(x); }

// Of the k-th of `count` places, from the centroid: as many to each area as far as `near`, then to each share of the
// radius.
double spiral_radius(std::size_t k, std::size_t count) {
  constexpr double near = 2.6, far = 9, near_share = 0.6;
  const double share = (static_cast<double>(k) + 0.5) / static_cast<double>(count);
  if (share < near_share) return near * std::sqrt(share / near_share);
  return near * std::pow(far / near, (share - near_share) / (1 - near_share));
}

// The direction in which the target is longest, towards its heavier end: so a turned target has its places turned.
Point long_direction(std::span<const Point> target) {
  Point squares{}, cubes{};
  for (const Point p : target) {
    squares += product(p, p);
    cubes += std::norm(p) * p;
  }
  const double size = std::sqrt(std::norm(squares));
  if (!(size > 0)) return {1, 0};
  const Point half = direction(0.5 * std::arg(squares));
  return dot(half, cubes) < 0 ? -half : half;
}

}  // namespace

std::vector<Point> pivot_places(std::size_t count, std::span<const Point> target, const std::optional<Box>& within) {
  const Point first = long_direction(target);
  constexpr double golden_angle = 2.399963229728653;
  constexpr double plastic[2] = {0.7548776662466927, 0.5698402909980532};  // powers of the plastic number's inverse
  std::vector<Point> places(count);
  for (std::size_t k = 0; k < count; ++k) {
    const auto index = static_cast<double>(k);
    if (within)
      places[k] = {within->x_low + (within->x_high - within->x_low) * fraction(0.5 + index * plastic[0]),
                   within->y_low + (within->y_high - within->y_low) * fraction(0.5 + index * plastic[1])};
    else
      places[k] = spiral_radius(k, count) * product(first, direction(golden_angle * index));
  }
  return places;
}

}  // namespace linkwright
