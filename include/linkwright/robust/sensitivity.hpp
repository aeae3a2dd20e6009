#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "linkwright/algebra/vector3.hpp"
#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/mechanism/linkage_output.hpp"
#include "linkwright/mechanism/spherical_four_bar.hpp"
#include "linkwright/robust/tolerances.hpp"

namespace linkwright {

/// First derivatives of a planar four-bar's configuration by each parameter, the input's direction being held; exact
/// (docs/theory/tolerances.md). Radians, user's unit, fixed frame.
struct PlanarSensitivity {
  PlanarValues coupler_angle{}, output_angle{};
  std::array<Point, planar_parameters> point{};
};
/// Where `linkage` lies; nothing at a dead point (tolerance::dead_point_sine), nor where a moving link has no length.
[[nodiscard]] std::optional<PlanarSensitivity> sensitivity_of(const TracingFourBar& linkage);

/// The same of a spherical four-bar: the coupler's small rotation (rotation vector, fixed frame) and the output's
/// angle.
struct SphericalSensitivity {
  std::array<Vector3, spherical_parameters> coupler{};
  SphericalValues output_angle{};
};
/// Nothing at a dead point, nor where neighbouring axes lie in one line.
[[nodiscard]] std::optional<SphericalSensitivity> sensitivity_of(const SphericalFourBar& linkage);

/// First derivatives of a linkage's errors in all positions of its task: a row of one number a parameter to each
/// component of the error in each position.
class SensitivityMatrix {
 public:
  SensitivityMatrix(std::size_t positions, std::size_t components, std::size_t parameters)
      : positions_(positions),
        components_(components),
        parameters_(parameters),
        values_(positions * components * parameters) {}

  [[nodiscard]] std::size_t positions() const { return positions_; }
  [[nodiscard]] std::size_t components() const { return components_; }
  [[nodiscard]] std::size_t parameters() const { return parameters_; }

  [[nodiscard]] std::span<double> row(std::size_t position, std::size_t component) {
    return std::span(values_).subspan((position * components_ + component) * parameters_, parameters_);
  }
  [[nodiscard]] std::span<const double> row(std::size_t position, std::size_t component) const {
    return std::span(values_).subspan((position * components_ + component) * parameters_, parameters_);
  }

 private:
  std::size_t positions_, components_, parameters_;
  std::vector<double> values_;
};

/// Nothing where a position has no sensitivity_of().
[[nodiscard]] std::optional<SensitivityMatrix> sensitivities(const PlanarOutput& output);
/// The coupler's rotation vector in each position, radians.
[[nodiscard]] std::optional<SensitivityMatrix> orientation_sensitivities(std::span<const SphericalFourBar> positions);
/// The output's angle in each position, radians.
[[nodiscard]] std::optional<SensitivityMatrix> angle_sensitivities(std::span<const SphericalFourBar> positions);

/// What is left of values at places along a line when the straight line that fits them best by least squares is taken
/// away. At least two places.
void take_away_best_line(std::span<const double> places, std::span<double> values);

}  // namespace linkwright
