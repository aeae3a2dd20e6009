#include "approximate/circuit_assignment.hpp"
#include "approximate/curve_least_squares.hpp"
#include "approximate/fit_result.hpp"

namespace linkwright {
std::optional<CurveFit> compare_with_curve(const TracingFourBar& linkage, const CurveTarget& target,
                                           const CurveFitOptions& options) {
  require_curve_target(target);
  if (!can_move(linkage)) return std::nullopt;
  const CouplerLinkage as_it_lies = coupler_linkage(linkage);
  const CouplerCircuit circuit(as_it_lies, loop_state(linkage));
  if (circuit.states().size() < 3) return std::nullopt;
  CurveStart nearest{as_it_lies, {}};
  const auto squared_distance = [&](std::size_t k, std::size_t point) {
    return std::norm(circuit.points()[k] - target.points[point]);
  };
  nearest.states = states_in_turn(circuit, target.points.size(), squared_distance);
  const std::vector<double> weights(target.points.size(), 1.0);
  slide_to_nearest({target.points, weights, {}}, nearest);
  return curve_fit_of(as_it_lies, nearest.states, target, options, FirstRealisation::as_given);
}

}  // namespace linkwright
