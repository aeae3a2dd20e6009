#include "linkwright/analysis/drive_extremes.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/triangle.hpp"
#include "analysis/turn_extremes.hpp"
#include "linkwright/analysis/transmission_angle.hpp"
#include "linkwright/analysis/velocity.hpp"

namespace linkwright {

TransmissionPeak largest_transmission_angle(const LinkLengths& l, const AngleRange& range) {
  if (!are_links(l)) return {};
  // At right angles the diagonal's square is the sum of the other two.
  const double cosine = (l.ground * l.ground + l.input * l.input - l.coupler * l.coupler - l.output * l.output) /
                        (2 * l.ground * l.input);
  std::vector<double> candidates = {range.from, range.to, 0, pi};
  if (std::abs(cosine) <= 1) candidates.insert(candidates.end(), {std::acos(cosine), -std::acos(cosine)});
  TransmissionPeak peak{0, range.from};
  for (const double candidate : candidates) {
    const double input = candidate + two_pi * std::ceil((range.from - candidate) / two_pi);
    const auto there = input > range.to ? std::nullopt : assemble(l, input, Assembly::positive);
    if (!there) continue;
    if (const double angle = transmission_angle(l, *there); angle > peak.angle) peak = {angle, input};
  }
  return peak;
}

std::optional<RatioRange> output_rates_full_turn(const LinkLengths& lengths, Assembly assembly) {
  return extremes_over_turn([&](double input) -> std::optional<double> {
    const auto there = assemble(lengths, input, assembly);
    const auto rates = there ? angle_rates(lengths, *there) : std::nullopt;
    return rates ? std::optional(rates->output) : std::nullopt;
  });
}

}  // namespace linkwright
