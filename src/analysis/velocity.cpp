#include "linkwright/analysis/velocity.hpp"

#include <cmath>

#include "analysis/triangle.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {

// The loop a e^{iφ} + h e^{iθ} = g + b e^{iψ}, differentiated by φ once and twice; the component along the output link
// leaves the coupler's rate, the component along the coupler the output's.
std::optional<AngleRates> angle_rates(const LinkLengths& lengths, const Configuration& configuration) {
  const auto [phi, theta, psi] = configuration;
  const double joint_sine = std::sin(theta - psi), joint_cosine = std::cos(theta - psi);
  if (!are_links(lengths) || !std::isfinite(phi) || !(std::abs(joint_sine) >= tolerance::dead_point_sine))
    return std::nullopt;
  const double a = lengths.input, h = lengths.coupler, b = lengths.output;
  AngleRates rates;
  rates.coupler = -a * std::sin(phi - psi) / (h * joint_sine);
  rates.output = -a * std::sin(phi - theta) / (b * joint_sine);
  const double coupler_pull = h * rates.coupler * rates.coupler, output_pull = b * rates.output * rates.output;
  rates.coupler_acceleration = (output_pull - a * std::cos(phi - psi) - coupler_pull * joint_cosine) / (h * joint_sine);
  rates.output_acceleration =
      (output_pull * joint_cosine - a * std::cos(phi - theta) - coupler_pull) / (b * joint_sine);
  return rates;
}

}  // namespace linkwright
