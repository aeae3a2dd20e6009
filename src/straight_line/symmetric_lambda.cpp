#include "symmetric_lambda.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {

namespace {

// The triangle of coupler and output is isosceles: half its base over a side in the middle of the stroke, where it is
// longest, and at the ends.
double least_transmission_angle(double middle, double end) {
  return std::min({2 * std::asin(middle), pi - 2 * std::asin(middle), 2 * std::asin(end)});
}

}  // namespace

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
  lambda.min_transmission_angle = least_transmission_angle(1 / (1 + 2 * w), 2 * w / (1 + 2 * w));
  return lambda;
}

namespace {

// In units of d + r: w = d − r by 2 w³ + S w² − Π = 0, where the line is met at u₁, u₂, u₃ with sum S and product Π.
// The nodes lie over the crank range, whose ends depend on w: contracts by some tenth a turn.
struct MetAtNodes {
  double w = 0, sum = 0;
};
MetAtNodes met_at_chebyshev_nodes(double crank_range) {
  const double sine = std::sin(crank_range / 4);
  MetAtNodes met{0.5, 0};
  for (int turn = 0; turn < 200; ++turn) {
    const double end = 1 - (1 - met.w * met.w) * sine * sine, middle = (1 + end) / 2, half = (1 - end) / 2;
    const double node = half * std::cos(pi / 6);
    const double sum = 3 * middle, product = (middle - node) * middle * (middle + node);
    double w = met.w;
    for (int newton = 0; newton < 50; ++newton) {
      const double step = (2 * w * w * w + sum * w * w - product) / (6 * w * w + 2 * sum * w);
      w -= step;
      if (std::abs(step) <= tolerance::last_newton_correction * w) break;
    }
    const double change = std::abs(w - met.w);
    met = {w, sum};
    if (change <= tolerance::no_difference) break;
  }
  return met;
}

}  // namespace

std::optional<SymmetricLambda> near_minimax_lambda(double crank_range, double stroke) {
  if (!(crank_range > 0 && crank_range < longest_lambda_range && stroke > 0 && std::isfinite(stroke)))
    return std::nullopt;
  const auto [w, sum] = met_at_chebyshev_nodes(crank_range);
  SymmetricLambda lambda;
  lambda.crank = (1 - w) / 2;
  lambda.ground = (1 + w) / 2;
  lambda.link = std::sqrt(sum + 2 * w) / 2;
  const double end = 1 - (1 - w * w) * std::pow(std::sin(crank_range / 4), 2);  // square of the pin's distance
  // x of the point at the end: the coupler's perpendicular from the output's centre, turned with the pin.
  const double reach = std::sqrt(4 * lambda.link * lambda.link / end - 1);
  const double way = 2 * reach * lambda.crank * std::sin(crank_range / 2);
  const double unit = stroke / way;
  // Heights of the point by u, the square of the pin's distance: their extremes inside are at u² − 2 l² u + 2 l² w = 0.
  const double link_square = lambda.link * lambda.link;
  const auto height = [&, met = w](double u) {
    return std::sqrt(4 * link_square / u - 1) * (u + met) / (2 * lambda.ground);
  };
  std::array<double, 4> heights = {height(1), height(end), height(1), height(end)};
  const double root = std::sqrt(std::max(0.0, link_square * (link_square - 2 * w)));
  for (const int sign : {-1, 1})
    if (const double u = link_square + sign * root; u > end && u < 1) heights[sign < 0 ? 2 : 3] = height(u);
  const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
  lambda.max_deviation = unit * (*high - *low) / 2;
  lambda.line_height = unit * (*high + *low) / 2;
  lambda.min_transmission_angle = least_transmission_angle(1 / (2 * lambda.link), std::sqrt(end) / (2 * lambda.link));
  for (double* length : {&lambda.crank, &lambda.ground, &lambda.link}) *length *= unit;
  lambda.crank_range = crank_range;
  lambda.stroke = stroke;
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
