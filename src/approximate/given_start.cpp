#include "approximate/given_start.hpp"

#include "approximate/circuit_assignment.hpp"

namespace linkwright {

bool is_usable_start(const FourBar& bars) {
  constexpr double largest = 1e6;
  const auto is_near = [&](Point p) { return std::abs(p) <= largest; };
  return bars.lengths().shortest() > 0 && is_near(bars.input_fixed) && is_near(bars.input_moving) &&
         is_near(bars.output_fixed) && is_near(bars.output_moving);
}

std::optional<CurveStart> start_in_turn(const CouplerLinkage& linkage, const LoopState& at,
                                        std::span<const Point> points) {
  const CouplerCircuit circuit(linkage, at);
  if (circuit.states().size() < 3) return std::nullopt;
  const auto squared_distance = [&](std::size_t state, std::size_t point) {
    return std::norm(circuit.points()[state] - points[point]);
  };
  CurveStart start{linkage, states_in_turn(circuit, points.size(), squared_distance)};
  const std::vector<double> weights(points.size(), 1.0);
  slide_to_nearest({points, weights, {}}, start);
  return start;
}

}  // namespace linkwright
