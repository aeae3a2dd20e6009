#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "linkwright/core/result.hpp"
#include "linkwright/core/simd.hpp"
#include "linkwright/mechanism/spherical_four_bar.hpp"
#include "linkwright/spherical/axis_curve.hpp"
#include "linkwright/spherical/orientation_conditions.hpp"

namespace linkwright {

/// One of the dyads of five orientations.
struct SphericalDyadPoint {
  SphericalDyad dyad;    ///< unit vectors with an acute angle between them; coordinate = index + ½
  int multiplicity = 1;  ///< 2 and more: multiplicity of the solution (tolerance::double_point)
  double residual = 0;   ///< largest |Gᵀ D W| over the conditions
  /// How far the pair of axes moves, at most, for each unit that the rows of the conditions (unit norm) move: rounding
  /// costs about condition × 1e-16. Finite; of a multiple point it is large and the distance grows with the root of the
  /// error instead.
  double condition = 1;
};

/// All dyads of five orientations, finite or mixed. They are six, counted with their multiplicity, complex ones
/// included.
struct FiveOrientationDyads {
  /// The smaller the (acute) link angle, the earlier: an order that no turn of the task and no change of senses
  /// changes.
  std::vector<SphericalDyadPoint> points;
  int complex_roots = 0;  ///< with multiplicity: 0, 2, 4 or 6

  /// Why there are more dyads than isolated ones: common_axis {x, y, z}, every_axis, dependent_rows {rank, curve},
  /// common_component. `points` is empty then.
  std::optional<Notice> degeneracy;
  /// The curve of dyads that dependent_rows leaves.
  std::shared_ptr<const AxisCurve> curve;
  std::vector<Notice> warnings;  ///< double_point {point, multiplicity} (from 1)
};

/// Where the four cones of moving axes that three of the four conditions leave meet, with multiplicity six (J. M.
/// McCarthy, G. S. Soh, Geometric Design of Linkages, 2nd ed. 2011, chapter 9, for finite orientations;
/// docs/theory/spherical.md), polished on the conditions themselves. `conditions` of five positions.
[[nodiscard]] FiveOrientationDyads five_orientation_dyads(const OrientationConditions& conditions);

/// The same of one of many tasks, without memory of its own.
struct SphericalDyads {
  std::array<SphericalDyad, 6> dyads{};  ///< the first `count`, ordered as FiveOrientationDyads::points
  std::array<int, 6> multiplicity{};
  int count = 0;
  int complex_roots = 0;
  bool degenerate = false;  ///< more than separate dyads: five_orientation_dyads() tells
};

using FiveOrientations = std::array<UnitQuaternion, 5>;

/// Dyads of many tasks of five finite orientations, as many at once as the machine's vectors hold; those that call for
/// care go the careful way of five_orientation_dyads(). Agrees with it to 1e-12 on well-conditioned tasks. `dyads` has
/// a place for each; the bits do not depend on `simd`, which is_supported() here.
void five_orientation_dyads_of_all(std::span<const FiveOrientations> tasks, std::span<SphericalDyads> dyads,
                                   Simd simd = Simd::automatic);

}  // namespace linkwright
