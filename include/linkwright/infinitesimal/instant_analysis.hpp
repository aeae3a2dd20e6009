#pragma once

#include <optional>
#include <vector>

#include "linkwright/core/result.hpp"
#include "linkwright/infinitesimal/instant.hpp"
#include "linkwright/infinitesimal/stationary_curvature.hpp"
#include "linkwright/mechanism/four_bar.hpp"

namespace linkwright {

/// How the path of a point runs now.
struct PathNow {
  Point point{};
  std::optional<Homogeneous> center;  ///< of curvature, at infinity for a point that inflects; nothing at the pole
  int contact_points = 0;  ///< of path and tangent: 2, at an inflection 3, Ball's point 4, …; 0 at the pole
  Point tangent{};         ///< unit vector along which it leaves; 0 at the pole
};

/// How fast the body turns, by the turn of the input or the parameter of its motion.
struct BodyRates {
  double velocity = 0, acceleration = 0;
};

/// All that one instant of a motion tells.
struct InstantAnalysis {
  std::optional<Instant> instant;  ///< nothing where there is none; then `degenerate` says why
  Notice degenerate;
  std::vector<Notice> notes;       ///< what holds because the links lie as they do
  std::optional<BodyRates> rates;  ///< nothing where the input stands still
  std::optional<CircleOrLine> bresse_circle;
  std::optional<Point> acceleration_pole;
  std::optional<Point> ball_point;
  std::vector<CurvaturePair> burmester_points;
  std::optional<PathNow> point;
};

struct InstantQuestion {
  std::optional<Point> point;     ///< of the coupler, as it lies
  double input_acceleration = 0;  ///< of the input's turn, over its squared velocity: 0 where it turns evenly
};

/// Of a four-bar's coupler as it lies; rates by the turn of the input.
[[nodiscard]] InstantAnalysis analyze_instant(const FourBar& four_bar, const InstantQuestion& question);

/// The linkage with its input at that angle (radians) from the ground link, joined as it is, its point carried along;
/// nothing where the input cannot be there.
[[nodiscard]] std::optional<TracingFourBar> with_input_at(const TracingFourBar& linkage, double input_angle);

/// Of a body whose pose is known with three derivatives at least; rates by their parameter.
[[nodiscard]] InstantAnalysis analyze_instant(const PrescribedPose& pose, std::optional<Point> point);

}  // namespace linkwright
