#include "linkwright/robust/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace linkwright {
namespace {

constexpr std::array<std::string_view, 3> distribution_names = {"normal", "truncated_normal", "uniform"};
constexpr std::array<std::string_view, planar_parameters> planar_parameter_names = {
    "input",           "coupler",         "output",      "input_center_x", "input_center_y",
    "output_center_x", "output_center_y", "point_along", "point_across",   "driver"};
constexpr std::array<std::string_view, spherical_parameters> spherical_parameter_names = {"input", "coupler", "output",
                                                                                          "ground", "driver"};

constexpr std::size_t moving_links = 3;  // the first parameters

template <class Values>
Values squares(Values half, double deviation) {
  for (double& value : half) value = value * value * deviation * deviation;
  return half;
}

}  // namespace

std::string_view name(ToleranceDistribution distribution) {
  return distribution_names[static_cast<std::size_t>(distribution)];
}

std::optional<ToleranceDistribution> tolerance_distribution_named(std::string_view name) {
  const auto found = std::find(distribution_names.begin(), distribution_names.end(), name);
  if (found == distribution_names.end()) return std::nullopt;
  return static_cast<ToleranceDistribution>(found - distribution_names.begin());
}

std::string_view name(PlanarParameter parameter) { return planar_parameter_names[static_cast<std::size_t>(parameter)]; }

std::string_view name(SphericalParameter parameter) {
  return spherical_parameter_names[static_cast<std::size_t>(parameter)];
}

double standard_deviation(ToleranceDistribution distribution) {
  switch (distribution) {
    case ToleranceDistribution::truncated_normal:
      // √(1 − 6 φ(3) / (2 Φ(3) − 1)) of the normal's.
      return 0.9865783925581086 / 3;
    case ToleranceDistribution::uniform:
      return 1 / std::sqrt(3.0);
    default:
      return 1.0 / 3;
  }
}

PlanarValues planar_half_tolerances(const Tolerances& tolerances) {
  const LengthTolerances& t = tolerances.length;
  return {t.input,         t.coupler,       t.output, t.ground_pivots, t.ground_pivots,
          t.ground_pivots, t.ground_pivots, t.point,  t.point,         tolerances.driver};
}

SphericalValues spherical_half_tolerances(const Tolerances& tolerances) {
  const double arc = tolerances.link_angle;
  return {arc, arc, arc, arc, tolerances.driver};
}

PlanarValues planar_reach(const Tolerances& tolerances) {
  PlanarValues reach = planar_half_tolerances(tolerances);
  for (std::size_t link = 0; link < moving_links; ++link) reach[link] += 2 * tolerances.clearance;
  return reach;
}

PlanarValues planar_variances(const Tolerances& tolerances) {
  PlanarValues variances = squares(planar_half_tolerances(tolerances), standard_deviation(tolerances.distribution));
  for (std::size_t link = 0; link < moving_links; ++link)
    variances[link] += tolerances.clearance * tolerances.clearance / 2;
  return variances;
}

SphericalValues spherical_variances(const Tolerances& tolerances) {
  return squares(spherical_half_tolerances(tolerances), standard_deviation(tolerances.distribution));
}

}  // namespace linkwright
