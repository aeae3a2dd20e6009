#pragma once

#include <optional>
#include <vector>

#include "linkwright/core/result.hpp"
#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/mechanism/pose.hpp"
#include "linkwright/planar/function_task.hpp"
#include "linkwright/planar/pose_conditions.hpp"

namespace linkwright {

/// Function generation by inversion (R. S. Hartenberg, J. Denavit, Kinematic Synthesis of Linkages, 1964): seen from
/// the output link the input link is a body that passes through prescribed poses, and the coupler is one of its side
/// links: a dyad with circle point A, the input's moving pivot, and centre point B, the output's, both as they lie at
/// the first pair.
///
/// The dyad of the two ground pivots keeps its length whatever the pairs: it is the ground link, always among the
/// dyads, and no coupler.
struct FunctionConditions {
  std::vector<PrescribedPose> poses;  ///< of the input link seen from the output link, user's frame moved to the
                                      ///< input's ground pivot
  PoseConditions conditions;          ///< of those poses; its frame is in the user's
  Dyad ground;                        ///< the ground link, working frame, unit vectors

  /// Those conditions alone that the derivatives set: orthonormal rows, working frame.
  [[nodiscard]] std::vector<HomogeneousMatrix> derivative_rows() const {
    return derivative_conditions(poses, {0, conditions.frame.scale});
  }
};

/// Displacement j: turn about the input's ground pivot by φⱼ − φ₁, then about the output's by −(ψⱼ − ψ₁); derivatives
/// by the product rule (docs/theory/function_generation.md). At least two positions; angles are counted from the first
/// pair.
[[nodiscard]] FunctionConditions function_conditions(const std::vector<AnglePair>& pairs, Point input_pivot = 0,
                                                     Point output_pivot = 1);

/// Why the couplers are no curve or no few points: parallelogram (the output turns as the input does), else
/// every_point. Nothing where they are.
[[nodiscard]] std::optional<Notice> function_degeneracy(const FunctionConditions& given);

/// How far a dyad (working frame) lies from the ground link: the larger great-circle distance of its two points,
/// radians.
[[nodiscard]] double distance_from_ground(const FunctionConditions& given, const Dyad& dyad);

}  // namespace linkwright
