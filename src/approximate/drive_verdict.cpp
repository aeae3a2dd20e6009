#include "approximate/drive_verdict.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "linkwright/core/angle.hpp"

namespace linkwright {

CurveDrive verdict(const CircuitDrive& drive, CurveDriver input, CurveDriver output) {
  return {drive.one_circuit, drive.in_order, drive.of(input).no_dead_point, drive.of(output).no_dead_point,
          drive.of(input).full_turn};
}

std::vector<double> input_turns(std::span<const LoopState> states, std::span<const double> on_the_way) {
  std::vector<double> turns = {0};
  for (std::size_t j = 1; j < states.size(); ++j) {
    const double turn = std::arg(product(states[j].e, std::conj(states[0].e)));
    const double about = on_the_way.empty() ? turns.back() : on_the_way[j];
    turns.push_back(turn + two_pi * std::round((about - turn) / two_pi));
  }
  return turns;
}

double order_noise(std::span<const double> squared_errors, double size) {
  constexpr double both = 2, most = 6;  // times the largest, and the root mean square
  constexpr double rounding = 1e-9;
  if (squared_errors.empty()) return rounding * size;
  const double sum = std::accumulate(squared_errors.begin(), squared_errors.end(), 0.0);
  const double largest = *std::max_element(squared_errors.begin(), squared_errors.end());
  return std::min(both * std::sqrt(largest), most * std::sqrt(sum / static_cast<double>(squared_errors.size()))) +
         rounding * size;
}

}  // namespace linkwright
