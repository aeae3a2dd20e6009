#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/function_ref.hpp"
#include "linkwright/algebra/point.hpp"

namespace linkwright {

/// A link that turns about a fixed pivot, and the body's arm from the link's moving pivot to the point.
struct Arm {
  double link = 0, reach = 0;
};

/// Where the moving pivot of an arm may stand, seen from the fixed pivot.
struct ArmElbows {
  static constexpr std::size_t most_points = 5;

  std::size_t points = 0;
  /// Of each place: grows with its direction as the angle does, by 4 in a turn, by 2 in half of one.
  std::array<std::array<double, 2>, most_points> direction{};
  std::array<std::array<Point, 2>, most_points> at;  ///< by point: to the left of the line from the fixed pivot to
                                                     ///< the point as one looks along it, to its right
};

/// Which of its two places the moving pivot has at each point, and how the link passes the points there.
struct ElbowPattern {
  std::uint8_t bits = 0;  ///< of point j: 1 << j where it is the second of both
  /// Senses in which the link meets the points in order within one turn, and those of which it is half a turn or more
  /// from the first to the last; bits as of DriverSequence.
  std::uint8_t senses = 0, half_turn_senses = 0;
};

/// All arms that reach some points from a fixed pivot: their sum s = link + reach and difference d = reach − link fill
/// the rectangle s ≥ the largest distance, |d| ≤ the least (docs/theory/path.md).
class ArmReach {
 public:
  /// One to five points, none of them at the pivot; all in one frame.
  ArmReach(Point pivot, std::span<const Point> points);

  /// u: largest distance over the sum, in (0, 1]; v: difference over the least distance, in [−1, 1].
  [[nodiscard]] Arm arm(double u, double v) const;
  /// Of an arm that reaches all points, from the fixed pivot to the moving one.
  [[nodiscard]] ArmElbows elbows(const Arm& arm) const;

  /// It reaches all points.
  [[nodiscard]] bool contains(const Arm& arm) const {
    return arm.reach + arm.link >= largest_ && std::abs(arm.reach - arm.link) <= least_;
  }

  [[nodiscard]] double least() const { return least_; }
  [[nodiscard]] double largest() const { return largest_; }

 private:
  std::vector<Point> from_pivot_;
  double least_ = 0, largest_ = 0;
};

/// All patterns, or those in which the link meets the points in order in some sense.
void for_elbow_patterns(const ArmElbows& elbows, bool only_in_order, FunctionRef<void(const ElbowPattern&)> take);
/// One of them, and how many there are.
[[nodiscard]] ElbowPattern elbow_pattern(const ArmElbows& elbows, std::uint8_t bits);
[[nodiscard]] constexpr std::size_t pattern_count(std::size_t points) { return std::size_t{1} << points; }

/// The place that a pattern has at a point.
[[nodiscard]] inline Point elbow(const ArmElbows& elbows, const ElbowPattern& pattern, std::size_t point) {
  return elbows.at[point][(pattern.bits >> point) & 1];
}

}  // namespace linkwright
