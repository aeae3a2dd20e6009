#pragma once

#include <array>
#include <optional>
#include <vector>

#include "linkwright/core/result.hpp"
#include "linkwright/mechanism/linkage_output.hpp"
#include "linkwright/mechanism/pose.hpp"
#include "linkwright/region/linkage_class.hpp"

namespace linkwright {

/// What three orientations want given: both fixed axes, or both moving axes as they lie in position 1 (any length but
/// zero), input's first.
struct GivenAxes {
  enum class Kind : unsigned char { fixed, moving };
  Kind kind = Kind::fixed;
  std::array<Vector3, 2> axes{};

  friend bool operator==(const GivenAxes&, const GivenAxes&) = default;
};

/// Motion generation about a fixed centre: a body shall pass through these orientations, in this order. One with m
/// derivatives counts as m + 1 positions; there are four or five of them, in any pattern, or three and given axes.
struct SphericalMotionTask {
  static constexpr const LinkageClass& linkages = spherical_linkages;
  static constexpr OutputKind output = OutputKind::turn;

  std::vector<PrescribedOrientation> orientations;
  std::optional<GivenAxes> given;  ///< three orientations only

  friend bool operator==(const SphericalMotionTask&, const SphericalMotionTask&) = default;
};

/// The caller's mistakes: number of positions, derivatives that are not finite or too large, angular velocities of
/// zero, what three orientations want given and more do not. Places are `task.orientations[i]…` (i from 0) and
/// `task.given…`. Orientations that repeat are no mistake: the answer says what becomes of them.
[[nodiscard]] std::vector<Error> mistakes_in(const SphericalMotionTask& task);

}  // namespace linkwright
