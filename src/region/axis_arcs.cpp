#include "linkwright/region/axis_arcs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "linkwright/algebra/line_search.hpp"
#include "linkwright/core/angle.hpp"

namespace linkwright {
namespace {

bool are_on_one_branch(double from, double to) { return std::floor(to) == std::floor(from); }

/// The extreme value of the parabola through three points, `places` rising.
double vertex_value(const std::array<double, 3>& places, const std::array<double, 3>& values) {
  const double first = (values[1] - values[0]) / (places[1] - places[0]),
               second = (values[2] - values[1]) / (places[2] - places[1]),
               curvature = (second - first) / (places[2] - places[0]);
  if (curvature == 0) return values[1];
  const double slope = first + curvature * (places[1] - places[0]);
  return values[1] - slope * slope / (4 * curvature);
}

// Where a function with values of different signs at both ends changes its sign, to the last digit.
template <class Function>
double sign_change(double low, double high, double at_low, const Function& value_at) {
  constexpr int halvings = 60;
  for (int i = 0; i < halvings; ++i) {
    const double middle = (low + high) / 2;
    const auto value = value_at(middle);
    if (middle <= low || middle >= high || !value) break;
    ((*value < 0) == (at_low < 0) ? low : high) = middle;
  }
  return (low + high) / 2;
}

/// One of the functions over the knots of a branch.
class BorderSearch {
 public:
  BorderSearch(const BorderValues& values_at, std::size_t which) : values_at_(values_at), which_(which) {}

  [[nodiscard]] std::optional<double> at(double coordinate) const {
    const auto values = values_at_(coordinate);
    return values && std::isfinite((*values)[which_]) ? std::optional((*values)[which_]) : std::nullopt;
  }

  void add_between(double from, double to, double value, double next, std::vector<double>& borders) const {
    if ((value < 0) != (next < 0)) borders.push_back(sign_change(from, to, value, [&](double x) { return at(x); }));
  }

  /// An extremum toward zero near the middle of three places on one side of it, which it may reach between them.
  void add_touching(const std::array<double, 3>& places, const std::array<double, 3>& values,
                    std::vector<double>& borders) const {
    const auto [a, b, c] = values;
    if ((a < 0) != (b < 0) || (b < 0) != (c < 0)) return;
    if (std::abs(b) > std::abs(a) || std::abs(b) > std::abs(c)) return;
    // A parabola through the three that stays well away from zero has no root that a smooth function could hide.
    constexpr double well_away = 0.75;
    const double extreme = vertex_value(places, values);
    if ((extreme < 0) == (b < 0) && std::abs(extreme) > well_away * std::abs(b)) return;
    const auto value_at = [&](double x) { return at(x); };
    constexpr int turns = 40;
    const auto above_zero = [&, sign = b < 0 ? -1.0 : 1.0](double x) {
      const auto value = at(x);
      return value ? sign * *value : std::numeric_limits<double>::infinity();
    };
    const double top = least_between(places[0], places[2], turns, above_zero);
    const auto there = value_at(top);
    if (!there) return;
    borders.push_back(top);
    add_between(places[0], top, a, *there, borders);
    add_between(top, places[2], *there, c, borders);
  }

 private:
  const BorderValues& values_at_;
  std::size_t which_;
};

}  // namespace

std::vector<AxisArc> arcs_where(const MapAxis& axis, std::vector<double> borders,
                                const std::function<bool(double)>& holds) {
  std::sort(borders.begin(), borders.end());
  std::vector<AxisArc> arcs;
  const auto add = [&](double from, double to, double begin) {
    if (!arcs.empty() && arcs.back().to == from && arcs.back().from >= begin)
      arcs.back().to = to;
    else
      arcs.push_back({from, to});
  };
  for (const CurveBranch& branch : axis.branches) {
    // The end of a branch is the beginning of the next one.
    const double last = branch.to > branch.from ? std::nextafter(branch.to, branch.from) : branch.to;
    std::vector<double> places = {branch.from};
    for (const double border : borders)
      if (border > branch.from && border < last) places.push_back(border);
    if (last > branch.from) places.push_back(last);
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (holds(places[i])) add(places[i], places[i], branch.from);
      // A border that rounding leaves outside ends the arc all the same.
      if (i + 1 < places.size() && holds((places[i] + places[i + 1]) / 2)) add(places[i], places[i + 1], branch.from);
    }
  }
  return arcs;
}

std::vector<double> borders_between(std::span<const double> knots, const BorderValues& values_at) {
  std::vector<std::optional<std::vector<double>>> values;
  values.reserve(knots.size());
  for (const double knot : knots) values.push_back(values_at(knot));
  std::vector<double> borders;
  const auto function_count = [&] {
    for (const auto& of_knot : values)
      if (of_knot) return of_knot->size();
    return std::size_t{0};
  }();
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    if (!are_on_one_branch(knots[i], knots[i + 1])) continue;
    if (values[i].has_value() != values[i + 1].has_value()) {  // real on one side only: where it ends
      double with = values[i] ? knots[i] : knots[i + 1], without = values[i] ? knots[i + 1] : knots[i];
      for (int halving = 0; halving < 50; ++halving) {
        const double middle = (with + without) / 2;
        (values_at(middle) ? with : without) = middle;
      }
      borders.push_back(with);
    }
  }
  for (std::size_t which = 0; which < function_count; ++which) {
    const BorderSearch search(values_at, which);
    const auto value = [&](std::size_t knot) { return (*values[knot])[which]; };
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
      if (!are_on_one_branch(knots[i], knots[i + 1]) || !values[i] || !values[i + 1]) continue;
      search.add_between(knots[i], knots[i + 1], value(i), value(i + 1), borders);
      if (i + 2 < knots.size() && are_on_one_branch(knots[i], knots[i + 2]) && values[i + 2])
        search.add_touching({knots[i], knots[i + 1], knots[i + 2]}, {value(i), value(i + 1), value(i + 2)}, borders);
    }
  }
  return borders;
}

std::vector<AxisArc> arcs_of(const MapAxis& axis, const std::array<double, 2>& interval) {
  const auto [low, high] = interval;
  const double length = axis.coordinate_length();
  if (axis.is_discrete()) return {{0, length}};
  if (!axis.is_closed() || (low >= 0 && high <= length) || !(length > 0)) return {{low, high}};
  if (high - low >= length) return {{0, length}};
  const double from = wrap_period(low, length), to = from + (high - low);
  if (to <= length) return {{from, to}};
  return {{0, to - length}, {from, length}};
}

std::vector<AxisArc> clipped(const std::vector<AxisArc>& arcs, const std::vector<AxisArc>& within) {
  std::vector<AxisArc> kept;
  for (const AxisArc& arc : arcs)
    for (const auto& [low, high] : within)
      if (arc.to >= low && arc.from <= high) kept.push_back({std::max(arc.from, low), std::min(arc.to, high)});
  return kept;
}

std::vector<double> samples_over(const AxisArc& arc, int count) {
  if (!(arc.to > arc.from)) return {arc.from};
  std::vector<double> coordinates;
  for (int i = 0; i < count; ++i) coordinates.push_back(arc.from + (arc.to - arc.from) * (i + 0.5) / count);
  return coordinates;
}

}  // namespace linkwright
