#pragma once

#include <optional>
#include <vector>

#include "linkwright/core/notice.hpp"
#include "linkwright/mechanism/dyad.hpp"
#include "linkwright/mechanism/pose.hpp"
#include "linkwright/planar/function_task.hpp"
#include "linkwright/planar/pose_conditions.hpp"

namespace linkwright {

/// Function generation by inversion (A. Bloch's idea; J. A. Hrones; F. Freudenstein, G. N. Sandor, 1959): seen from the
/// output link the input link is a body that passes through prescribed poses, so that the coupler is one of its side
/// links: a dyad with circle point A, the input's moving pivot, and centre point B, the output's, both in position 1.
///
/// Unit frame: input's ground pivot at 0, the output's at 1. There the dyad (0, 1) keeps its length whatever the pairs:
/// it is the ground link itself, always among the dyads, and no coupler.
struct FunctionConditions {
  std::vector<PrescribedPose> poses;  ///< of the input link seen from the output link, unit frame
  PoseConditions conditions;          ///< of those poses; its frame is relative to the unit frame
  Dyad ground;                        ///< the ground link, frame of `conditions`, unit vectors

  /// A dyad of the conditions in the unit frame.
  [[nodiscard]] Dyad to_unit(const Dyad& dyad) const { return conditions.frame.to_user(dyad); }
};

/// Displacement j: turn about 0 by φⱼ − φ₁, then about 1 by −(ψⱼ − ψ₁); derivatives by the product rule
/// (docs/theory/planar.md). At least two positions; angles are counted from the first pair.
[[nodiscard]] FunctionConditions function_conditions(const std::vector<AnglePair>& pairs);

/// Why the couplers are no curve or no few points: parallelogram (the output turns as the input does), else
/// every_point. Nothing where they are.
[[nodiscard]] std::optional<Notice> function_degeneracy(const FunctionConditions& given);

/// How far a dyad lies from the ground link: the larger great-circle distance of its two points, frame of the
/// conditions, radians.
[[nodiscard]] double distance_from_ground(const FunctionConditions& given, const Dyad& dyad);

}  // namespace linkwright
