#include "linkwright/robust/linkage_output.hpp"

namespace linkwright {
namespace {

std::vector<MadeDimension> dimensions_of(const PlanarOutput& /*output*/, const Tolerances& tolerances) {
  constexpr std::size_t moving_links = 3;  // the first parameters
  const PlanarValues half = planar_half_tolerances(tolerances);
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

std::vector<MadeDimension> dimensions_of(const SixBarOutput& /*output*/, const Tolerances& /*tolerances*/) {
  return {};
}

}  // namespace

std::size_t positions_of(const LinkageOutput& output) {
  return std::visit([](const auto& one) { return one.positions.size(); }, output);
}

bool is_line(const LinkageOutput& output) {
  const auto* const planar = std::get_if<PlanarOutput>(&output);
  return planar != nullptr && planar->kind == PlanarOutput::Kind::line;
}

bool is_angle(const LinkageOutput& output) {
  if (const auto* const planar = std::get_if<PlanarOutput>(&output)) return planar->kind == PlanarOutput::Kind::angle;
  return std::holds_alternative<SphericalOutput>(output);
}

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
  return std::nullopt;
}

}  // namespace linkwright
