#include "linkwright/robust/made_dimension.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "robust/six_bar_distances.hpp"

namespace linkwright {
namespace {

std::vector<MadeDimension> dimensions_of(const PlanarOutput& output, const Tolerances& tolerances) {
  constexpr std::size_t moving_links = 3;  // the first parameters
  Tolerances asked = tolerances;
  if (output.kind == PlanarOutput::Kind::angle) asked.length.point = 0;  // a function has no point
  const PlanarValues half = planar_half_tolerances(asked);
  std::vector<MadeDimension> made;
  for (std::size_t i = 0; i < half.size(); ++i) {
    const auto parameter = static_cast<PlanarParameter>(i);
    made.push_back({std::string(name(parameter)), half[i], i < moving_links ? 2 : 0,
                    parameter == PlanarParameter::driver, parameter == PlanarParameter::driver});
  }
  return made;
}

std::vector<MadeDimension> dimensions_of(const SphericalOutput& /*output*/, const Tolerances& tolerances) {
  const SphericalValues half = spherical_half_tolerances(tolerances);
  std::vector<MadeDimension> made;
  for (std::size_t i = 0; i < half.size(); ++i) {
    const auto parameter = static_cast<SphericalParameter>(i);
    made.push_back({std::string(name(parameter)), half[i], 0, parameter == SphericalParameter::driver, true});
  }
  return made;
}

double length_tolerance(const SixBar& six_bar, int body, const LengthTolerances& length) {
  if (body == SixBar::driver) return length.input;
  const std::vector<std::size_t> own = six_bar.joints_of(body);
  const bool grounded =
      std::any_of(own.begin(), own.end(), [&](std::size_t j) { return is_on_ground(six_bar.joints[j]); });
  return grounded ? length.output : length.coupler;
}

std::vector<MadeDimension> dimensions_of(const SixBarOutput& output, const Tolerances& tolerances) {
  const SixBarDistances distances(output.six_bar);
  const LengthTolerances& t = tolerances.length;
  std::vector<MadeDimension> made;
  for (const SixBarLength& length : distances.lengths())
    made.push_back({"length " + name(length), length_tolerance(output.six_bar, length.body, t), 2});
  for (const std::size_t pivot : distances.ground())
    for (const char* axis : {"x", "y"})
      made.push_back({fmt::format("center_{}_{}", joint_name(pivot), axis), t.ground_pivots});
  for (const auto parameter : {PlanarParameter::point_along, PlanarParameter::point_across})
    made.push_back({std::string(name(parameter)), t.point});
  made.push_back({std::string(name(PlanarParameter::driver)), tolerances.driver, 0, true, true});
  return made;
}

}  // namespace

double MadeDimension::variance(const Tolerances& tolerances) const {
  const double deviation = tolerance * standard_deviation(tolerances.distribution);
  return deviation * deviation + pins * tolerances.clearance * tolerances.clearance / 4;
}

std::vector<MadeDimension> made_dimensions(const LinkageOutput& output, const Tolerances& tolerances) {
  return std::visit([&](const auto& one) { return dimensions_of(one, tolerances); }, output);
}

std::optional<SensitivityMatrix> sensitivities(const LinkageOutput& output) {
  if (const auto* const planar = std::get_if<PlanarOutput>(&output)) return sensitivities(*planar);
  if (const auto* const spherical = std::get_if<SphericalOutput>(&output))
    return spherical->kind == SphericalOutput::Kind::angle ? angle_sensitivities(spherical->positions)
                                                           : orientation_sensitivities(spherical->positions);
  return six_bar_sensitivities(std::get<SixBarOutput>(output));
}

}  // namespace linkwright
