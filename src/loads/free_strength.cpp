#include "free_strength.hpp"

#include <algorithm>
#include <cmath>

#include "linkwright/loads/spring_charge.hpp"
#include "loads/gas_charge.hpp"
#include "loads/line_envelope.hpp"

namespace linkwright {

StrengthRange strengths_of(const FreeStrength& free) {
  return {std::max(least_f1, free.min_f1.value_or(0)), free.max_f1};
}

std::optional<double> held_open(const FreeStrength& free) {
  constexpr double more = 1e-4;
  if (!free.min_hold_open) return std::nullopt;
  return *free.min_hold_open + more * (1 + std::abs(*free.min_hold_open));
}

Loads with_f1(Loads loads, double f1) {
  const auto k = free_spring(loads);
  if (!k) return loads;
  auto& gas = std::get<GasSpring>(loads.springs[*k].law);
  gas.free.reset();
  const GasCharge charge(gas, 0.005 / metres_of(loads));
  gas = charge.with(charge.of_f1(f1));
  return loads;
}

std::optional<double> best_share(const StrengthLines& hand, const StrengthLines& last,
                                 std::optional<double> hold_open) {
  const auto are_finite = [](const StrengthLines& lines) {
    return std::all_of(lines.rise.begin(), lines.rise.end(), [](double rise) { return std::isfinite(rise); });
  };
  if (!are_finite(hand) || !are_finite(last)) return std::nullopt;
  double low = 0, high = 1;
  for (std::size_t i = 0; hold_open && i < last.rise.size(); ++i) {
    const double over = last.weakest[i] + *hold_open, rise = last.rise[i];
    if (rise == 0 && over > 0) return std::nullopt;
    if (rise < 0) low = std::max(low, -over / rise);
    if (rise > 0) high = std::min(high, -over / rise);
  }
  if (!(low <= high)) return std::nullopt;
  return least_top({hand.weakest.data(), hand.rise.data(), hand.rise.size()}, low, high).s;
}

}  // namespace linkwright
