#include "function_linkage.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/precondition.hpp"
#include "planar/turned_arm.hpp"

namespace linkwright {
namespace {

struct Arms {
  std::vector<Point> input, coupler;  // from the input's ground pivot to A, from A to B; with derivatives
};

Arms arms_at(const FourBar& bars, const AnglePair& first, const AnglePair& pair) {
  std::vector<double> input_rates, output_rates;
  for (const AngleDerivative& d : pair.derivatives) {
    input_rates.push_back(d.input);
    output_rates.push_back(d.output);
  }
  Arms arms{turned_arm(bars.input_moving - bars.input_fixed, pair.input - first.input, input_rates),
            turned_arm(bars.output_moving - bars.output_fixed, pair.output - first.output, output_rates)};
  for (std::size_t m = 0; m < arms.coupler.size(); ++m) arms.coupler[m] -= arms.input[m];
  arms.coupler[0] += bars.output_fixed - bars.input_fixed;
  return arms;
}

PrescribedPose coupler_pose(const FourBar& bars, const Arms& arms) {
  const Point first = bars.output_moving - bars.input_moving;
  PrescribedPose pose{{bars.input_fixed + arms.input[0], std::arg(arms.coupler[0] * std::conj(first))}, {}};
  const std::vector<double> rates = turn_rates(arms.coupler);
  for (std::size_t m = 0; m < rates.size(); ++m) pose.derivatives.push_back({arms.input[m + 1], rates[m]});
  return pose;
}

}  // namespace

std::vector<PrescribedPose> coupler_poses(const FourBar& four_bar, const std::vector<AnglePair>& pairs) {
  std::vector<PrescribedPose> poses;
  for (const AnglePair& pair : pairs) poses.push_back(coupler_pose(four_bar, arms_at(four_bar, pairs.front(), pair)));
  return poses;
}

double coupler_residual(const FourBar& four_bar, const std::vector<AnglePair>& pairs) {
  const double length = four_bar.lengths().coupler;
  double worst = 0;
  for (const AnglePair& pair : pairs)
    worst = std::max(worst, std::abs(std::abs(arms_at(four_bar, pairs.front(), pair).coupler[0]) - length));
  return length > 0 ? worst / length : 0;
}

GeneratedFunction generated_function(const FourBar& four_bar, const AnglePair& first) {
  const LinkLengths lengths = four_bar.lengths();
  const Assembly assembly = assembly_of(four_bar);
  const Configuration start = configuration_of(four_bar);
  const auto output_angle = [lengths, assembly](double input_angle) {
    const auto there = assemble(lengths, input_angle, assembly);
    return there ? std::optional(there->output_angle) : std::nullopt;
  };
  return {output_angle, {start.input_angle, start.output_angle}, input_ranges(lengths), first};
}

FunctionError function_error(const FourBar& four_bar, std::span<const AnglePair> pairs, const ScaledFunction* function,
                             const ErrorSampling& sampling) {
  require(!pairs.empty(), "an error is that at pairs");
  return function_error(generated_function(four_bar, pairs.front()), pairs, function, sampling);
}

FunctionError function_error(const FourBar& four_bar, const FunctionTask& task, const ErrorSampling& sampling) {
  if (!task.function) return function_error(four_bar, task.pairs, nullptr, sampling);
  const ScaledFunction scaled(*task.function);
  return function_error(four_bar, task.pairs, &scaled, sampling);
}

}  // namespace linkwright
