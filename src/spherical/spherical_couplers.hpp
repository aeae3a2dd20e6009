#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "linkwright/core/result.hpp"
#include "linkwright/function/wanted_function.hpp"
#include "linkwright/mechanism/pose.hpp"
#include "linkwright/mechanism/spherical_four_bar.hpp"
#include "linkwright/spherical/axis_curve.hpp"
#include "linkwright/spherical/orientation_conditions.hpp"

namespace linkwright {

/// Orientations of the output link seen from the input link, the first pair's being the reference:
/// R_z(−(θⱼ − θ₁)) turned after the turn by ψⱼ − ψ₁ about the output's fixed axis; derivatives by the product rule
/// (docs/theory/spherical.md). At least one pair; axes as fixed_axes().
[[nodiscard]] std::vector<PrescribedOrientation> output_seen_from_input(const std::vector<AnglePair>& pairs,
                                                                        double ground_angle);

/// All couplers that meet pairs of angles, by inversion: dyads with fixed axis W₁ on the input link and moving axis W₂
/// on the output link, as they lie at the first pair. Four positions leave a curve of them, five one, three or five
/// (fewer where solutions fall on the ground link).
///
/// The dyad of the two fixed axes keeps its angle whatever the pairs: it is the ground link, always among the dyads,
/// and no coupler.
struct SphericalCouplers {
  OrientationConditions conditions;
  std::shared_ptr<const AxisCurve> curve;  ///< four positions; five whose conditions depend on each other
  std::vector<SphericalDyad> points;       ///< five positions, without the ground link; coordinate = index + ½
  std::vector<Notice> warnings;            ///< ill_conditioned {condition}, double_point, dependent_rows
  std::optional<Notice> degeneracy;        ///< why there are neither

  /// The coupler at a coordinate: on the curve, or of the point that fills [index, index + 1). Nothing elsewhere.
  [[nodiscard]] std::optional<SphericalDyad> coupler(double coordinate) const;
};

/// Pairs without mistakes.
[[nodiscard]] SphericalCouplers spherical_couplers(const std::vector<AnglePair>& pairs, double ground_angle);

}  // namespace linkwright
