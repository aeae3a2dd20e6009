#pragma once

#include <functional>
#include <span>
#include <vector>

#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/planar/burmester_curve.hpp"
#include "plane_window.hpp"

namespace linkwright {

/// The two Burmester curves as they are seen in a window: paths in px, broken at infinity and where they leave it.
struct CurvePaths {
  std::vector<std::vector<Point>> centers, circles;
};

/// Follows both curves by τ, with smaller steps where the window shows them.
[[nodiscard]] CurvePaths visible_curves(const BurmesterCurve& curve, const WorkingFrame& frame,
                                        const PlaneWindow& window);

/// A closed curve by the share of its way round in [0, 1), as it is seen in a window.
[[nodiscard]] std::vector<std::vector<Point>> visible_curve(const std::function<Homogeneous(double)>& curve,
                                                            const PlaneWindow& window);

/// The pivots of grounded links along an axis of a map (fixed frame, by rising coordinate), joined where they follow
/// each other on one branch.
[[nodiscard]] CurvePaths visible_polygon(std::span<const Dyad> dyads, const PlaneWindow& window);

}  // namespace linkwright
