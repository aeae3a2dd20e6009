#pragma once

#include <optional>
#include <string>

#include "linkwright/algebra/vector3.hpp"
#include "linkwright/core/result.hpp"

namespace linkwright {

/// A directed line of space, such as the axis of a joint: any of its points, any vector along it but zero.
struct Line {
  Vector3 point{};
  Vector3 direction{0, 0, 1};
};

/// How two lines lie.
enum class LinePair : unsigned char {
  crossing,    ///< neither parallel nor in one point: one common normal (lines that meet have it too, of length 0)
  parallel,    ///< a common normal through every point
  coincident,  ///< one line
};

/// The shortest connection of two lines: what makes the length and the twist of a link.
struct CommonNormal {
  LinePair lines = LinePair::crossing;
  Vector3 direction{};       ///< unit vector, from the first line to the second
  Vector3 foot_on_first{};   ///< where it leaves the first line; of parallels, the given point of the first line
  Vector3 foot_on_second{};  ///< where it reaches the second line
  double distance = 0;       ///< from foot to foot, not negative
  double twist = 0;          ///< angle from the first direction to the second about the normal, radians, in (−π, π]
};

/// The common normal of two lines. Where they meet, its direction is that of first × second; where they coincide, any
/// at a right angle to them. Parallel by tolerance::parallel_lines; nearly parallel lines have feet far away, uncertain
/// by 1e-16 / sin² of their angle. Errors: `not_finite`, `zero_axis`.
[[nodiscard]] Result<CommonNormal> common_normal(const Line& first, const Line& second);

/// Any unit vector at a right angle to the vector, which is not zero.
[[nodiscard]] Vector3 any_normal(Vector3 a);

/// What is wrong with a line, at the place; nothing if it is one.
[[nodiscard]] std::optional<Error> mistake_in(const Line& line, std::string place);

}  // namespace linkwright
