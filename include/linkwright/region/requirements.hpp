#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <variant>
#include <vector>

#include "linkwright/algebra/vector3.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/core/result.hpp"
#include "linkwright/core/tolerance.hpp"
#include "linkwright/mechanism/linkage_type.hpp"

namespace linkwright {

/// Axis-parallel rectangle, borders included, user's unit.
struct Box {
  double x_low = 0, x_high = 0, y_low = 0, y_high = 0;
  /// Borders included, to the rounding of coordinates. A box without width or height, on which points lie only as
  /// exactly as they are solved for, takes them to tolerance::on_border of its longer side.
  [[nodiscard]] bool contains(Point p) const {
    const double farthest =
        std::max(std::max(std::abs(x_low), std::abs(x_high)), std::max(std::abs(y_low), std::abs(y_high)));
    const bool is_flat = x_low == x_high || y_low == y_high;
    const double slack = tolerance::rounded_coordinate * farthest +
                         (is_flat ? tolerance::on_border * std::max(x_high - x_low, y_high - y_low) : 0);
    return p.real() >= x_low - slack && p.real() <= x_high + slack && p.imag() >= y_low - slack &&
           p.imag() <= y_high + slack;
  }

  /// Its projection on the plane z = 0 does.
  [[nodiscard]] bool contains(Vector3 p) const { return contains(Point{p.x, p.y}); }

  friend bool operator==(const Box&, const Box&) = default;
};

/// Lines through the centre of a sphere, in either sense, at most `half_angle` from an axis.
struct Cone {
  Vector3 axis;           ///< of any length
  double half_angle = 0;  ///< radians, in (0, π/2]

  /// Between the axis and a line, radians in [0, π/2].
  [[nodiscard]] double angle_to(Vector3 line) const {
    return std::atan2(norm(cross(normalized(axis), line)), std::fabs(dot(normalized(axis), line)));
  }
  /// Borders included, to the rounding of coordinates.
  [[nodiscard]] bool contains(Vector3 line) const {
    return angle_to(line) <= half_angle + tolerance::rounded_coordinate;
  }

  friend bool operator==(const Cone&, const Cone&) = default;
};

/// Where a hinge has to lie.
using PivotWindow = std::variant<Box, Cone>;

/// What the user asks of a linkage beside the task. They choose and rank; they never change the curve or the counts.
/// Which of them go with a class of linkages, its LinkageClass says.
struct Requirements {
  static constexpr double unlimited = std::numeric_limits<double>::infinity();

  std::vector<LinkageType> types;  ///< wanted types; empty: any but degenerate
  bool no_defects = true;
  double min_transmission_angle = 0;  ///< over the task, radians; 0: any
  double max_link_ratio = 20;         ///< longest over shortest of the four links; unlimited: any
  std::optional<double> max_length;   ///< longest of the four links, user's unit; nothing: 10 × L; unlimited: any
  std::optional<double> min_length;   ///< shortest of the four links, user's unit; nothing: L/1000; 0: any
  std::optional<Box> ground_pivots_within;  ///< both centre points
  std::optional<Box> moving_pivots_within;  ///< both circle points, position 1 (2 where 1 is freed)
  std::optional<double> min_link_angle;     ///< of all four links, radians; nothing: the default; 0: any
  std::optional<double> max_link_angle;     ///< of all four links, radians; nothing: any
  std::optional<Cone> fixed_axes_within;    ///< both fixed axes
  std::optional<Cone> moving_axes_within;   ///< both moving axes, position 1
  double min_stroke = 0;                    ///< usable length of a straight line, user's unit; 0: any
  double max_deviation = unlimited;         ///< off the line over the stroke, user's unit
  bool full_turn = false;                   ///< the input is a crank: it turns fully
  /// Of a path near its points, as Measure path_error has it: user's unit.
  double max_path_error = unlimited;
  /// Of a motion past near poses, as Measure near_error has it: user's unit.
  double max_near_error = unlimited;
  /// By tolerances, as Measure tolerance_error has it: user's unit, of functions and spherical linkages degrees.
  double max_tolerance_error = unlimited;
  double min_yield = 0;  ///< share of linkages made with errors that are good, in [0, 1]; 0: any
  // By loads, N and N·m.
  double max_open_force = unlimited, max_close_force = unlimited;
  double min_hold_open = -unlimited;
  double max_pin_force = unlimited, max_torque = unlimited;
  bool respect_direction = true;  ///< poses with derivatives are passed in their direction
};

/// Defaults of max_length and min_length in characteristic lengths: beyond them lie linkages that nobody can build, and
/// there is no smallest one among those that shrink to a point.
inline constexpr double default_max_length = 10, default_min_length = 1e-3;

/// Default of min_link_angle: below it a link is all but a joint.
inline constexpr double default_min_link_angle = radians(5);

/// The requirements with the defaults of both lengths filled in for a task of characteristic length `size`. Where the
/// longest link asked for is shorter than that, it is what a short link is measured by.
[[nodiscard]] Requirements with_default_lengths(Requirements wanted, double size);

/// The caller's mistakes: out of range or contradictory. Places are `requirements.…`.
[[nodiscard]] std::vector<Error> mistakes_in(const Requirements& wanted);

}  // namespace linkwright
