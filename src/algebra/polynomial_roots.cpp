#include "polynomial_roots.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "linkwright/core/precondition.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

constexpr std::size_t max_coefficients = 16;

// The constant outweighs all that the other terms can be within ±reach.
bool keeps_sign(std::span<const double> c, double reach) {
  double others = 0;
  for (std::size_t k = c.size(); k-- > 1;) others = (others + std::abs(c[k])) * reach;
  return std::abs(c[0]) > others;
}

}  // namespace

double polynomial_value(std::span<const double> coefficients, double t) {
  double value = 0;
  for (std::size_t k = coefficients.size(); k-- > 0;) value = value * t + coefficients[k];
  return value;
}

// Newton's method between two places of different sign, which close in; halved where a step leaves them or is not half
// as long as the one before.
double sign_change_between(std::span<const double> c, double from, double to) {
  const double at_from = polynomial_value(c, from), at_to = polynomial_value(c, to);
  if (at_from == 0) return from;
  if (at_to == 0) return to;
  require((at_from < 0) != (at_to < 0), "a polynomial of different signs at both places");
  double low = std::min(from, to), high = std::max(from, to), step = high - low;
  const bool falls = (at_from < 0) != (from < to);
  double place = from - at_from * (to - from) / (at_to - at_from);
  for (int turn = 0; turn < 200; ++turn) {
    if (!(place > low && place < high)) place = 0.5 * (low + high);
    if (!(place > low && place < high)) break;
    double value = 0, slope = 0;
    for (std::size_t k = c.size(); k-- > 0;) {
      slope = slope * place + value;
      value = value * place + c[k];
    }
    if (value == 0) break;
    ((value < 0) != falls ? low : high) = place;
    const double newton = -value / slope;
    if (std::abs(newton) <= tolerance::last_newton_correction * std::abs(place)) return place + newton;
    const bool is_slow = !(std::abs(newton) < 0.5 * std::abs(step));
    step = is_slow ? 0.5 * (low + high) - place : newton;
    place += step;
  }
  return place;
}

std::vector<double> sign_changes_within(std::span<const double> coefficients, double from, double to) {
  require(coefficients.size() <= max_coefficients, "a polynomial of degree at most 15");
  if (coefficients.size() < 2) return {};
  // derivative[d]: the d-th one, without its common factor; up to the first that has no root.
  std::array<std::array<double, max_coefficients>, max_coefficients> derivative;
  const std::size_t degree = coefficients.size() - 1;
  const auto of_order = [&](std::size_t d) { return std::span<const double>(derivative[d].data(), degree - d + 1); };
  std::copy(coefficients.begin(), coefficients.end(), derivative[0].begin());
  const double reach = std::max(std::abs(from), std::abs(to));
  std::size_t rootless = 0;
  for (std::size_t& d = rootless; d < degree && !keeps_sign(of_order(d), reach); ++d)
    for (std::size_t k = 0; k + d < degree; ++k)
      derivative[d + 1][k] = static_cast<double>(k + 1) * derivative[d][k + 1] / static_cast<double>(d + 1);
  std::array<double, max_coefficients + 1> places = {from, to};  // ends, and between them the roots so far
  std::size_t count = 2;
  for (std::size_t d = rootless; d-- > 0;) {
    std::array<double, max_coefficients + 1> next = {from};
    std::size_t found = 1;
    // A place where it is zero has no sign: the stretches on both sides are one.
    double before = 0, at_before = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const double place = places[i], there = polynomial_value(of_order(d), place);
      if (there == 0) continue;
      if (at_before != 0 && (there < 0) != (at_before < 0))
        next[found++] = sign_change_between(of_order(d), before, place);
      before = place;
      at_before = there;
    }
    next[found++] = to;
    places = next;
    count = found;
  }
  return {places.begin() + 1, places.begin() + static_cast<std::ptrdiff_t>(count) - 1};
}

}  // namespace linkwright
