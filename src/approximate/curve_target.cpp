#include <algorithm>
#include <cmath>

#include "linkwright/approximate/curve_fit.hpp"

namespace linkwright {

double CurveTarget::diagonal() const {
  const auto by_x = [](Point a, Point b) { return a.real() < b.real(); };
  const auto by_y = [](Point a, Point b) { return a.imag() < b.imag(); };
  const auto [left, right] = std::minmax_element(points.begin(), points.end(), by_x);
  const auto [lowest, highest] = std::minmax_element(points.begin(), points.end(), by_y);
  return points.empty() ? 0 : std::hypot(right->real() - left->real(), highest->imag() - lowest->imag());
}

std::string_view name(FitEffort effort) {
  constexpr std::array<std::string_view, 3> names = {"quick", "standard", "deep"};
  return names[static_cast<std::size_t>(effort)];
}

std::string_view name(FitMeasure measure) {
  return measure == FitMeasure::least_squares ? "least_squares" : "least_largest";
}

}  // namespace linkwright
