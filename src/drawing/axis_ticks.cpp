#include "axis_ticks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>

#include "files/axis_label.hpp"
#include "linkwright/files/number_text.hpp"

namespace linkwright {
namespace {

constexpr double closest = 27;        // px between ticks
constexpr double from_infinity = 19;  // px between a tick and a place marked ∞
constexpr int digits = 4;

/// Values and px of the samples of one block, rising.
struct Readings {
  std::vector<double> values, px;
  double usual_step = 0;  ///< of the values from sample to sample

  [[nodiscard]] double covered() const { return usual_step * static_cast<double>(values.size()); }
};

Readings readings_of(const RegionScale& scale, const RegionScale::Block& block, const LinkageFamily& family,
                     Side side) {
  Readings readings;
  std::vector<double> steps;
  for (std::size_t i = block.first; i < block.last; ++i) {
    const double tau = scale.coordinates()[i];
    const auto px = scale.position(tau);
    const double value = family.axis_value(side, tau);
    if (!px || !std::isfinite(value)) continue;
    if (!readings.values.empty()) steps.push_back(value - readings.values.back());
    readings.values.push_back(value);
    readings.px.push_back(*px);
  }
  if (steps.empty()) return readings;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  readings.usual_step = *middle;
  return readings;
}

/// Where a value is read; nothing beyond the samples and, on axes that are even otherwise, in gaps between them.
std::optional<double> px_of(const Readings& readings, double value, bool is_even) {
  const auto above = std::lower_bound(readings.values.begin(), readings.values.end(), value);
  if (above == readings.values.end() || (above == readings.values.begin() && *above > value)) return std::nullopt;
  const auto at = static_cast<std::size_t>(above - readings.values.begin());
  if (*above == value) return readings.px[at];
  const double low = readings.values[at - 1], high = *above;
  if (is_even && high - low > 4 * readings.usual_step) return std::nullopt;
  return readings.px[at - 1] + (readings.px[at] - readings.px[at - 1]) * (value - low) / (high - low);
}

/// Round numbers of all sizes between the ends, where equal steps of px are not equal steps of the value.
std::vector<double> scattered_values(double low, double high, bool fine) {
  constexpr std::array<double, 3> coarse_steps = {1, 2, 5};
  constexpr std::array<double, 10> fine_steps = {1, 1.2, 1.4, 1.6, 1.8, 2, 3, 4, 6, 8};
  std::vector<double> values;
  if (!(low < high)) return values;
  if (low < 0) {  // the same on both sides of 0, down to a thousandth of what is left at the smaller side
    const double least = 1e-3 * (high > 0 ? std::min(-low, high) : -high);
    values = scattered_values(high < 0 ? -high : least, -low, fine);
    std::transform(values.begin(), values.end(), values.begin(), std::negate<>());
    std::reverse(values.begin(), values.end());
    if (high < 0) return values;
    values.push_back(0);
    const std::vector<double> above = scattered_values(least, high, fine);
    values.insert(values.end(), above.begin(), above.end());
    return values;
  }
  if (!(low > 0)) return values;
  const auto magnitude = [](double value) { return static_cast<int>(std::floor(std::log10(value))); };
  for (int exponent = magnitude(low); exponent <= magnitude(high); ++exponent) {
    const double power = std::pow(10, exponent);
    const auto add = [&](double step) {
      if (step * power >= low && step * power <= high) values.push_back(step * power);
    };
    fine ? std::for_each(fine_steps.begin(), fine_steps.end(), add)
         : std::for_each(coarse_steps.begin(), coarse_steps.end(), add);
  }
  return values;
}

// Lengths of grounded links without bound, factors and places of pivots all over the plane are not.
bool is_even(AxisQuantity quantity) {
  switch (quantity) {
    case AxisQuantity::side_length:
    case AxisQuantity::output_scale:
    case AxisQuantity::center_x:
    case AxisQuantity::center_y:
    case AxisQuantity::circle_x:
    case AxisQuantity::circle_y:
    case AxisQuantity::center_on_line:
    case AxisQuantity::circle_on_line:
      return false;
    default:
      return true;
  }
}

std::vector<double> candidates(const Readings& readings, AxisQuantity quantity, double length) {
  const double low = readings.values.front(), high = readings.values.back();
  // Directions without a grounded link take no room: the steps are those where there are some.
  if (is_even(quantity))
    return even_ticks(low, high, length * (high - low) / std::max(readings.covered(), 1e-9), closest,
                      is_angle(quantity));
  constexpr std::size_t few = 3;
  std::vector<double> values = scattered_values(low, high, false);
  return values.size() < few ? scattered_values(low, high, true) : values;
}

}  // namespace

std::vector<double> even_ticks(double low, double high, double length, double spacing, bool are_degrees) {
  constexpr double most = 4096, whole_numbers = 9e15;  // beyond 2^53 the next whole number is the same
  std::vector<double> ticks;
  if (!(high > low) || !(length > 0)) return ticks;
  const double least = std::max(spacing / length, 1 / most) * (high - low);
  const double power = std::pow(10, std::floor(std::log10(least)));
  double step = 10 * power;
  for (const double factor : {5.0, 2.0, 1.0})
    if (factor * power >= least * (1 - 1e-9)) step = factor * power;
  constexpr std::array<double, 5> angles = {15, 30, 45, 90, 180};
  const auto angle = std::find_if(angles.begin(), angles.end(), [&](double a) { return a >= least; });
  if (are_degrees && least > 10 && angle != angles.end()) step = *angle;
  const double first = std::ceil(low / step), last = std::floor(high / step + 1e-9);
  if (!(std::max(std::abs(first), std::abs(last)) < whole_numbers)) return ticks;
  for (double i = first; i <= last; ++i) ticks.push_back(i == 0 ? 0 : i * step);
  return ticks;
}

std::vector<AxisTick> axis_ticks(const RegionScale& scale, const LinkageFamily& family, Side side) {
  std::vector<AxisTick> ticks;
  const AxisQuantity quantity = family.axis(side).quantity;
  if (!has_values(quantity)) return ticks;
  const std::vector<double> infinities = scale.crossings_of_infinity();
  double last = -2 * closest;  // where one block ends the next begins
  for (const RegionScale::Block& block : scale.blocks()) {
    const Readings readings = readings_of(scale, block, family, side);
    if (readings.values.size() < 3 || !(readings.values.back() > readings.values.front())) continue;
    for (const double value : candidates(readings, quantity, block.to_px - block.from_px)) {
      const auto px = px_of(readings, value, is_even(quantity));
      if (!px || *px - last < closest - 0.5) continue;
      if (std::any_of(infinities.begin(), infinities.end(),
                      [&](double at) { return std::abs(at - *px) < from_infinity; }))
        continue;
      ticks.push_back({*px, significant_text(value, digits)});
      last = *px;
    }
  }
  return ticks;
}

}  // namespace linkwright
