#pragma once

#include <optional>

#include "linkwright/algebra/directed_line.hpp"
#include "linkwright/mechanism/four_bar.hpp"

namespace linkwright {

/// A λ with equal links: coupler, output and the point's arm beyond the coupler are of one length, so that the point's
/// path has an axis of symmetry, the normal to the ground link at the output's centre. User's unit, radians.
struct SymmetricLambda {
  double crank = 0, ground = 0;
  double link = 0;           ///< coupler, output and arm; the crank's pin is twice as far from the point
  double crank_range = 0;    ///< of the stroke, evenly about where the crank points away from the output's centre
  double stroke = 0;         ///< along the line
  double line_height = 0;    ///< distance of the best line from the ground link's, to which it is parallel
  double max_deviation = 0;  ///< from that line: −, +, −, + to either side of the middle of the stroke
  double min_transmission_angle = 0;  ///< over the stroke, the crank driving
};

/// Crank range in which the point would turn back at the ends of the stroke, radians: 269.36°.
inline constexpr double longest_lambda_range = 4.70118208261419;

/// The one that deviates least from a straight line over a crank range, as a share of the crank, in closed form
/// (docs/theory/straight_lines.md): extremes of the deviation are equal. Nothing unless
/// 0 < crank_range < longest_lambda_range and stroke > 0.
[[nodiscard]] std::optional<SymmetricLambda> minimax_lambda(double crank_range, double stroke);

/// The one whose point meets a line at Chebyshev's nodes of |pin − output's centre|² over the crank range: all but as
/// straight as minimax_lambda(), and the way in which it was designed before (Han Jianyou et al., ch. 11).
[[nodiscard]] std::optional<SymmetricLambda> near_minimax_lambda(double crank_range, double stroke);

/// As it lies in the middle of its stroke, the point being at `line.point` (max_deviation short of the best line, which
/// is parallel) and the crank at the beginning of the line; pivots to the right of the line, `mirrored` to the left.
[[nodiscard]] TracingFourBar lambda_linkage(const SymmetricLambda& lambda, const DirectedLine& line, bool mirrored);

}  // namespace linkwright
