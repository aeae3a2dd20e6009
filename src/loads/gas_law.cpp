#include "gas_law.hpp"

#include <algorithm>
#include <cmath>

#include "linkwright/core/angle.hpp"

namespace linkwright {
namespace {

constexpr double atmosphere = 0.101325;  // N/mm²
constexpr double zero_celsius = 273.15, room = 20;

}  // namespace

GasLaw::GasLaw(const GasSpring& spring, double default_measured_at) {
  const double measured_at = spring.measured_at.value_or(default_measured_at);
  const double x1 = measured_at, x2 = spring.stroke - measured_at;
  const double f3 = spring.f3.value_or(spring.f1 + 2 * spring.friction);
  const double f4 = spring.f4.value_or(spring.f2 + 2 * spring.friction);
  const double fr1 = (f3 - spring.f1) / 2, fr2 = (f4 - spring.f2) / 2;
  air_ = pi / 4 * spring.rod_diameter * spring.rod_diameter * atmosphere;
  const double s1 = (spring.f1 + f3) / 2 + air_, s2 = (spring.f2 + f4) / 2 + air_;
  per_volume_ = (s2 - s1) / (s2 * x2 - s1 * x1);
  charge_ = s1 * (1 - x1 * per_volume_);
  friction_slope_ = (fr2 - fr1) / (x2 - x1);
  friction_ = fr1 - friction_slope_ * x1;
}

double GasLaw::heat(const GasSpring& spring, double temperature) {
  if (spring.percent_per_10K) return 1 + *spring.percent_per_10K / 1000 * (temperature - room);
  return (temperature + zero_celsius) / (room + zero_celsius);
}

double GasLaw::force(double x, const State& state) const {
  const double volume = 1 - x * per_volume_;
  if (state.exponent == 1) return charge_ * state.heat / volume - air_;
  const double rested = 1 - state.rested_at * per_volume_;
  return charge_ * state.heat / rested * std::pow(rested / volume, state.exponent) - air_;
}

double GasLaw::energy(double x, const State& state) const {
  const double share = x * per_volume_, faster = state.exponent - 1;
  const double log_ratio = -std::log1p(-share);  // of volumes, before to after
  const double growth = faster == 0 ? log_ratio : std::expm1(faster * log_ratio) / faster;
  const double rested = std::pow(1 - state.rested_at * per_volume_, faster);
  return charge_ * state.heat * rested * x * (share == 0 ? 1 : growth / share) - air_ * x;
}

double GasLaw::friction(double x) const { return std::max(0.0, friction_ + friction_slope_ * x); }

}  // namespace linkwright
