#include "approximate/fit_result.hpp"
#include "approximate/given_start.hpp"

namespace linkwright {
std::optional<CurveFit> compare_with_curve(const TracingFourBar& linkage, const CurveTarget& target,
                                           const CurveFitOptions& options) {
  require_curve_target(target);
  if (!can_move(linkage)) return std::nullopt;
  const CouplerLinkage as_it_lies = coupler_linkage(linkage);
  const auto nearest = start_in_turn(as_it_lies, loop_state(linkage), target.points);
  if (!nearest) return std::nullopt;
  return curve_fit_of(as_it_lies, nearest->states, target, options, FirstRealisation::as_given);
}

}  // namespace linkwright
