#include <cmath>

#include "approximate/circuit_assignment.hpp"
#include "approximate/curve_least_squares.hpp"
#include "approximate/fit_result.hpp"

namespace linkwright {
namespace {

CouplerLinkage coupler_linkage(const TracingFourBar& linkage) {
  const FourBar& bars = linkage.bars;
  const LinkLengths lengths = bars.lengths();
  const Point along = (bars.output_moving - bars.input_moving) / lengths.coupler;
  return {bars.input_fixed, bars.output_fixed, lengths.input,
          lengths.coupler,  lengths.output,    product(linkage.point - bars.input_moving, std::conj(along))};
}

}  // namespace

std::optional<CurveFit> compare_with_curve(const TracingFourBar& linkage, const CurveTarget& target,
                                           const CurveFitOptions& options) {
  require_curve_target(target);
  const FourBar& bars = linkage.bars;
  const LinkLengths lengths = bars.lengths();
  if (!(lengths.shortest() > 0) || !std::isfinite(lengths.perimeter()) || !is_finite(linkage.point))
    return std::nullopt;
  const CouplerLinkage as_it_lies = coupler_linkage(linkage);
  const LoopState state{(bars.input_moving - bars.input_fixed) / lengths.input,
                        (bars.output_moving - bars.input_moving) / lengths.coupler};
  const CouplerCircuit circuit(as_it_lies, state);
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
