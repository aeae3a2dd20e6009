#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "linkwright/attitude/twist.hpp"
#include "linkwright/core/result.hpp"

namespace linkwright {

/// What `linkwright attitude twist` reads: schema/attitude.schema.json. Lengths in the user's unit, rates per the
/// user's unit of time, angles in radians.
struct TwistTask {
  std::string length_unit;  ///< echoed, never converted
  Twist twist;
  std::vector<Vector3> points;  ///< whose velocities are wanted
};

/// `{"linkwright": 1, "length_unit": …, "twist": {…}, "points": [[x, y, z], …]}`, the twist either `angular_velocity`
/// and `velocity`, of the point `at` (what is missing being 0), or `screw` {`axis`, `point`, `rate`, and one of
/// `slide_rate` and `pitch`}.
[[nodiscard]] Result<TwistTask> read_twist_task(std::string_view text);

/// A twist, its instantaneous screw, and velocities.
struct TwistReport {
  TwistTask task;
  InstantaneousScrew screw;
  std::vector<Vector3> velocities;  ///< of the points
};

/// Errors: those of instantaneous_screw(), place `twist`.
[[nodiscard]] Result<TwistReport> twist_report(const TwistTask& task);

[[nodiscard]] std::string write_twist_report(const TwistReport& report);

}  // namespace linkwright
