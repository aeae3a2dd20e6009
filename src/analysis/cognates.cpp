#include "linkwright/analysis/cognates.hpp"

#include <algorithm>

#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

// Beside the parallelogram of crank and arm, triangles similar to the coupler's: on the crank, and on the ground link.
TracingFourBar cognate_on_input(const TracingFourBar& linkage) {
  const auto& [center, pin, other_center, other_pin] = linkage.bars;
  const Point arm = linkage.point - pin, shape = arm / (other_pin - pin);
  return {{center, center + arm, center + shape * (other_center - center), center + arm + shape * (pin - center)},
          linkage.point};
}

}  // namespace

std::optional<std::array<TracingFourBar, 2>> cognates(const TracingFourBar& linkage) {
  const FourBar& bars = linkage.bars;
  const double shortest = std::min({bars.lengths().coupler, std::abs(linkage.point - bars.input_circle),
                                    std::abs(linkage.point - bars.output_circle)});
  if (!(shortest > tolerance::vanishing_link * linkage.longest())) return std::nullopt;
  return std::array{cognate_on_input(linkage), cognate_on_input(linkage.swapped())};
}

}  // namespace linkwright
