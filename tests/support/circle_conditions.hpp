#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "linkwright/mechanism/pose.hpp"

// A slow second method for dyads: the circle conditions themselves, and Newton's method with a numeric Jacobian.
namespace linkwright::testing {

/// |Z₂ − C|² − |Z₁ − C|² and the same of the third pose; `circle` as it lies in the first of three finite poses.
[[nodiscard]] Point length_changes(const std::vector<PrescribedPose>& poses, Point center, Point circle);

/// Worst relative change of |Z − C| over the poses.
[[nodiscard]] double length_change(const std::vector<PrescribedPose>& poses, Point center, Point circle);

/// Worst derivative of |Z − C|² at a pose with derivatives, of each order that they prescribe, by differences along
/// their Taylor series, and its change from pose to pose.
[[nodiscard]] double drift_along(const std::vector<PrescribedPose>& poses, Point center, Point circle);

/// A zero of a function of two numbers; nothing where it does not settle.
[[nodiscard]] std::optional<Point> newton(const std::function<Point(Point)>& f, Point start);

}  // namespace linkwright::testing
