#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "linkwright/core/result.hpp"
#include "linkwright/core/simd.hpp"
#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/mechanism/pose.hpp"
#include "linkwright/planar/burmester_curve.hpp"
#include "linkwright/planar/pose_conditions.hpp"

namespace linkwright {

/// One of the dyads of five positions.
struct BurmesterPoint {
  Dyad dyad;             ///< working frame, unit vectors; coordinate = index + ½
  int multiplicity = 1;  ///< 2 and more: multiplicity of the solution (tolerance::double_point)
  double residual = 0;   ///< largest |Zᵀ M C| over the conditions
  /// How far the pair of unit vectors moves, at most, for each unit that the rows of the conditions (unit length,
  /// before they are made orthonormal) move: rounding costs about condition × 1e-16. Finite; of a multiple point it is
  /// large and the distance grows with the root of the error instead.
  double condition = 1;
};

/// All dyads of five positions, finite or mixed. They are four, counted with their multiplicity,
/// those with complex points included.
struct BurmesterPoints {
  /// The nearer the circle point lies to the moving frame's origin in position 1, the earlier: an order that neither
  /// rigid motion nor scale changes, nor a passage through infinity. Sliders are among them.
  std::vector<BurmesterPoint> points;
  int complex_roots = 0;  ///< with multiplicity, 0, 2 or 4

  /// Why there are more dyads than isolated points: common_pole {x, y}, translations_on_circle {x, y},
  /// every_point, only_translations, dependent_rows {rank, curve}, common_component. In the last case `points` has what
  /// there is beside the component.
  std::optional<Notice> degeneracy;
  /// The curve of dyads that dependent_rows leaves.
  std::shared_ptr<const BurmesterCurve> curve;
  std::vector<Notice> warnings;  ///< double_point {point, multiplicity} (from 1)
};

/// The Burmester points (L. Burmester, Lehrbuch der Kinematik, 1888) as the common points of two conics in the null
/// space of the conditions (docs/theory/planar.md, section 10), polished on the conditions themselves. `conditions` of
/// five positions.
[[nodiscard]] BurmesterPoints burmester_points(const PoseConditions& conditions);

/// The same of one of many tasks, without memory of its own.
struct BurmesterDyads {
  WorkingFrame frame;
  std::array<Dyad, 4> dyads{};  ///< the first `count`, ordered as BurmesterPoints::points
  std::array<int, 4> multiplicity{};
  int count = 0;
  int complex_roots = 0;
  bool degenerate = false;  ///< more than separate points: burmester_points() tells
};

using FivePoses = std::array<Pose, 5>;

/// Burmester points of many tasks of five finite poses, as many at once as the machine's vectors hold; those that call
/// for care go the careful way of burmester_points(). Agrees with it to 1e-12 on well-conditioned tasks. `dyads` has a
/// place for each; the bits do not depend on `simd`, which is_supported() here.
void burmester_points_of_all(std::span<const FivePoses> tasks, std::span<BurmesterDyads> dyads,
                             Simd simd = Simd::automatic);

}  // namespace linkwright
