#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "linkwright/mechanism/defects.hpp"
#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/mechanism/pose.hpp"

namespace linkwright::testing {

/// How far rounding is from deciding the verdict over bars in these poses: the least of Grashof's excesses as a share
/// of the perimeter and of the sines of their joints.
[[nodiscard]] inline double verdict_margin(const FourBar& bars, std::span<const PrescribedPose> poses) {
  const GrashofExcesses t = grashof_excesses(bars.lengths());
  double least = std::min({std::abs(t.t1), std::abs(t.t2), std::abs(t.t3)}) / bars.lengths().perimeter();
  const auto sine = [](Point u, Point v) { return std::abs(cross(u, v)) / (std::abs(u) * std::abs(v)); };
  for (const PrescribedPose& pose : poses) {
    const Point a = displaced(bars.input_moving, poses[0].pose, pose.pose);
    const Point b = displaced(bars.output_moving, poses[0].pose, pose.pose);
    const Point frame = bars.output_fixed - bars.input_fixed;
    least = std::min({least, sine(frame, a - bars.input_fixed), sine(a - bars.input_fixed, b - a),
                      sine(b - a, bars.output_fixed - b)});
  }
  return least;
}

}  // namespace linkwright::testing
