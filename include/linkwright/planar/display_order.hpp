#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "linkwright/planar/burmester_curve.hpp"
#include "linkwright/planar/pose_conditions.hpp"

namespace linkwright {

/// A stretch of a map's axis: one branch of the curve, or half of one.
struct OrderBlock {
  std::size_t branch = 0;   ///< index in BurmesterCurve::branches()
  double from = 0, to = 0;  ///< places, from < to
  /// (place, τ) at both ends and between them, places rising, τ strictly monotone and unwrapped: it may leave the
  /// branch's own interval and counts modulo the branch.
  std::vector<std::array<double, 2>> knots;
};

/// The order in which a map shows the dyads of a curve: a place in [0, 1] along the axis for every τ.
///
/// In order of τ a map is reshuffled whenever the curve changes its kind while the task is being dragged. Here an
/// irreducible curve is two blocks, the points with S < 0 and those with S > 0, each by the angle χ of the line through
/// the focus from −90° to +90° (docs/theory/planar.md): the same whether it has one branch, two or a node. Other curves
/// are laid branch by branch in order of τ.
///
/// Where the focal form's a passes through 0, its axes are reversed and S changes its sign (χ does not, and the points
/// do not know φ₀ from φ₀ + π): then the two blocks must be exchanged to stay where they were. That is an order's code:
/// 0 as told above, 1 with two blocks exchanged.
class DisplayOrder {
 public:
  DisplayOrder() = default;
  /// `frame`: the curve's. An axis that is not two blocks has code 0 whatever is asked.
  DisplayOrder(const BurmesterCurve& curve, Spacing spacing, const WorkingFrame& frame, int code = 0);
  /// Branch by branch in order of τ, evenly; a branch without length has no block.
  explicit DisplayOrder(std::vector<CurveBranch> branches);
  /// The same through samples of the axis, by rising τ: they lie evenly by place, in the middles of equal steps, so
  /// that where there is nothing to sample there is no room on the axis.
  DisplayOrder(std::vector<CurveBranch> branches, std::span<const double> samples);
  /// The one whose dyads lie nearest to those at the same places of `before`, compared in that one's frame.
  [[nodiscard]] static DisplayOrder nearest(const BurmesterCurve& curve, Spacing spacing, const WorkingFrame& frame,
                                            const DisplayOrder& before);

  /// 0 as defined above, 1 with the two blocks exchanged.
  [[nodiscard]] int code() const { return code_; }

  /// By rising place, without gaps; none where the curve has no coordinates.
  [[nodiscard]] const std::vector<OrderBlock>& blocks() const { return blocks_; }

  /// τ at a place (held to [0, 1]), within its branch.
  [[nodiscard]] double coordinate(double place) const;
  /// Place of τ; nothing where no block shows it.
  [[nodiscard]] std::optional<double> place(double tau) const;

  /// The very coordinates of curve.samples(count, spacing), by rising place.
  [[nodiscard]] std::vector<double> samples(const BurmesterCurve& curve, int count) const;
  /// Coordinates of `count` places, the middles of equal steps over [from, to].
  [[nodiscard]] std::vector<double> samples(int count, double from, double to) const;

 private:
  [[nodiscard]] double distance_to(const DisplayOrder& before) const;

  Spacing spacing_ = Spacing::coordinate;
  WorkingFrame frame_;
  int code_ = 0;
  std::vector<CurveBranch> branches_;
  std::vector<OrderBlock> blocks_;
  std::vector<std::vector<Dyad>> probes_;  ///< of each block, evenly by place, fixed frame
};

}  // namespace linkwright
