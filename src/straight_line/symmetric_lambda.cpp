#include "linkwright/straight_line/symmetric_lambda.hpp"

#include <algorithm>
#include <cmath>

#include "linkwright/core/angle.hpp"

namespace linkwright {

// In units of d + r, with w = d² − r² = d − r: heights of the point at the middle and at the ends of the stroke, and
// their difference without cancellation.
std::optional<SymmetricLambda> minimax_lambda(double crank_range, double stroke) {
  if (!(crank_range > 0 && crank_range < longest_lambda_range && stroke > 0 && std::isfinite(stroke)))
    return std::nullopt;
  const double half = std::cos(crank_range / 4), sine = std::sin(crank_range / 4);
  const double w = half / std::sqrt(3 + half * half);
  const double one_less = 3 * sine * sine / ((3 + half * half) * (1 + 2 * w));  // 1 − 2w
  const double middle = 2 * std::sqrt(w * (1 + w)), end = std::pow(1 + 4 * w, 1.5) / (2 * (1 + w));
  const double range = one_less * one_less * one_less * (1 + 2 * w) / (4 * (1 + w) * (1 + w) * (end + middle));
  const double way = std::sqrt(3 * (1 + 4 * w) * one_less * (1 + 2 * w)) / (1 + w);
  const double unit = stroke / way;
  SymmetricLambda lambda;
  lambda.crank = unit * (1 - w) / 2;
  lambda.ground = unit * (1 + w) / 2;
  lambda.link = unit * (1 + 2 * w) / 2;
  lambda.crank_range = crank_range;
  lambda.stroke = stroke;
  lambda.line_height = unit * (end + middle) / 2;
  lambda.max_deviation = unit * range / 2;
  // The triangle of coupler and output is isosceles; its base is 1 in the middle and 2w at the ends.
  const auto between = [&](double base) { return 2 * std::asin(base / (1 + 2 * w)); };
  lambda.min_transmission_angle = std::min({between(1), pi - between(1), between(2 * w)});
  return lambda;
}

TracingFourBar lambda_linkage(const SymmetricLambda& lambda, const DirectedLine& line, bool mirrored) {
  const double reach = lambda.ground + lambda.crank;
  const double height = std::sqrt((2 * lambda.link - reach) * (2 * lambda.link + reach));
  const auto placed = [&](Point from_point) { return line.to_fixed(mirrored ? std::conj(from_point) : from_point); };
  return {{placed({-lambda.ground, -height}), placed({-reach, -height}), placed({0, -height}),
           placed({-reach / 2, -height / 2})},
          line.point};
}

}  // namespace linkwright
