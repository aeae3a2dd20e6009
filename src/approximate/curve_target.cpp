#include <algorithm>
#include <cmath>

#include "approximate/fit_result.hpp"
#include "linkwright/core/precondition.hpp"

namespace linkwright {

double CurveTarget::diagonal() const {
  const auto by_x = [](Point a, Point b) { return a.real() < b.real(); };
  const auto by_y = [](Point a, Point b) { return a.imag() < b.imag(); };
  const auto [left, right] = std::minmax_element(points.begin(), points.end(), by_x);
  const auto [lowest, highest] = std::minmax_element(points.begin(), points.end(), by_y);
  return points.empty() ? 0 : std::hypot(right->real() - left->real(), highest->imag() - lowest->imag());
}

void require_curve_target(const CurveTarget& target) {
  std::vector<Point> distinct;
  for (const Point point : target.points) {
    require(is_finite(point), "points of a curve are finite");
    if (distinct.size() < 3 && std::find(distinct.begin(), distinct.end(), point) == distinct.end())
      distinct.push_back(point);
  }
  require(distinct.size() == 3, "a curve has three distinct points at least");
  require(target.weights.empty() || target.weights.size() == target.points.size(), "a weight belongs to each point");
  const auto usable = [](double weight) { return weight >= 0 && std::isfinite(weight); };
  require(std::all_of(target.weights.begin(), target.weights.end(), usable), "weights are not negative");
  const auto none = [](double weight) { return weight == 0; };
  require(target.weights.empty() || !std::all_of(target.weights.begin(), target.weights.end(), none),
          "a weight is above 0");
}

std::string_view name(FitEffort effort) {
  constexpr std::array<std::string_view, 3> names = {"quick", "standard", "deep"};
  return names[static_cast<std::size_t>(effort)];
}

std::string_view name(FitMeasure measure) {
  return measure == FitMeasure::least_squares ? "least_squares" : "least_largest";
}

}  // namespace linkwright
