#include "linkwright/algebra/polynomial_roots.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "linkwright/core/precondition.hpp"

namespace linkwright {
namespace {

constexpr std::size_t max_coefficients = 16;

// The sign change between two places: secants and halves by turns.
double bracketed_root(std::span<const double> c, double low, double high, double at_low, double at_high) {
  for (int turn = 0; turn < 200; ++turn) {
    const double middle = 0.5 * (low + high);
    if (!(middle > low && middle < high)) return middle;
    const double secant = low - at_low * (high - low) / (at_high - at_low);
    const bool inside = turn % 2 == 0 && secant > low && secant < high;
    const double place = inside ? secant : middle, there = polynomial_value(c, place);
    if (there == 0) return place;
    if ((there < 0) == (at_low < 0)) {
      low = place;
      at_low = there;
    } else {
      high = place;
      at_high = there;
    }
  }
  return 0.5 * (low + high);
}

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

std::vector<double> sign_changes_within(std::span<const double> coefficients, double from, double to) {
  require(coefficients.size() <= max_coefficients, "a polynomial of degree at most 15");
  std::vector<double> roots;
  if (coefficients.size() < 2 || keeps_sign(coefficients, std::max(std::abs(from), std::abs(to)))) return roots;
  // derivative[d]: the d-th one, without its common factor.
  std::array<std::array<double, max_coefficients>, max_coefficients> derivative{};
  const std::size_t degree = coefficients.size() - 1;
  for (std::size_t k = 0; k <= degree; ++k) derivative[0][k] = coefficients[k];
  for (std::size_t d = 1; d < degree; ++d)
    for (std::size_t k = 0; k + d <= degree; ++k)
      derivative[d][k] = static_cast<double>(k + 1) * derivative[d - 1][k + 1] / static_cast<double>(d);
  for (std::size_t d = degree; d-- > 0;) {
    const std::span<const double> c(derivative[d].data(), degree - d + 1);
    std::vector<double> places = {from};
    places.insert(places.end(), roots.begin(), roots.end());
    places.push_back(to);
    roots.clear();
    // A place where it is zero has no sign: the stretches on both sides are one.
    double before = 0, at_before = 0;
    for (const double place : places) {
      const double there = polynomial_value(c, place);
      if (there == 0) continue;
      if (at_before != 0 && (there < 0) != (at_before < 0))
        roots.push_back(bracketed_root(c, before, place, at_before, there));
      before = place;
      at_before = there;
    }
  }
  return roots;
}

}  // namespace linkwright
