#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "linkwright/algebra/point.hpp"
#include "linkwright/core/result.hpp"
#include "linkwright/mechanism/pose.hpp"

namespace linkwright {

/// A pose by two points of the body, the same two in every pose: where they lie in the fixed frame, user's unit. The
/// moving frame has its origin in the first and its x axis toward the second.
struct BodyPoints {
  Point first{}, second{};
  friend bool operator==(const BodyPoints&, const BodyPoints&) = default;
};

/// The poses of a body whose two points keep one distance: the mean of those given, with which the squared distances
/// from the points given are least; the middle between them, and their direction, are kept in each pose.
[[nodiscard]] std::vector<Pose> poses_of_points(std::span<const BodyPoints> given);

/// points_distance {least, greatest, distance, miss}: the distances differ, by more than rounding, and by how much the
/// points are missed. Nothing where they agree.
[[nodiscard]] std::optional<Notice> points_notice(std::span<const BodyPoints> given);

/// Adds the caller's mistakes: numbers out of range, both points at one place. Places are `task.poses[i].points…`.
void check_points(std::span<const BodyPoints> given, std::vector<Error>& found);

}  // namespace linkwright
