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

}  // namespace

std::vector<Point> pivot_places(std::size_t count, const std::optional<Box>& within) {
  constexpr double golden_angle = 2.399963229728653;
  constexpr double plastic[2] = {0.7548776662466927, 0.5698402909980532};  // powers of the plastic number's inverse
  std::vector<Point> places(count);
  for (std::size_t k = 0; k < count; ++k) {
    const auto index = static_cast<double>(k);
    if (within)
      places[k] = {within->x_low + (within->x_high - within->x_low) * fraction(0.5 + index * plastic[0]),
                   within->y_low + (within->y_high - within->y_low) * fraction(0.5 + index * plastic[1])};
    else
      places[k] = spiral_radius(k, count) * direction(golden_angle * index);
  }
  return places;
}

}  // namespace linkwright
