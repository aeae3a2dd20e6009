#include "transmission_angle.hpp"

#include <algorithm>
#include <cmath>

#include "linkwright/core/angle.hpp"
#include "triangle.hpp"

namespace linkwright {
namespace {

/// True where the closed interval holds `angle` or an angle that differs from it by whole turns.
bool holds(double from, double to, double angle) {
  return std::floor((to - angle) / two_pi) >= std::ceil((from - angle) / two_pi);
}

/// γ at a diagonal; 0 where the triangle does not close or is flat.
double angle_at_diagonal(const LinkLengths& l, double diagonal_length) {
  return acute(angle_opposite(diagonal_length, l.coupler, l.output, diagonal_slack(l)));
}

}  // namespace

double transmission_angle(const LinkLengths& lengths, const Configuration& configuration) {
  const double joint = std::abs(wrap_signed(configuration.coupler_angle - configuration.output_angle));
  return are_links(lengths) && std::isfinite(joint) ? std::max(0.0, acute(joint)) : 0;
}

double least_transmission_angle(const LinkLengths& lengths, double from, double to) {
  if (!are_links(lengths) || !std::isfinite(from) || !std::isfinite(to)) return 0;
  const auto [low, high] = std::minmax(from, to);
  const double at_from = std::abs(diagonal(lengths, low)), at_to = std::abs(diagonal(lengths, high));
  // μ grows with the diagonal, so γ is least at one of the diagonal's extremes.
  const double least = holds(low, high, 0) ? std::abs(lengths.ground - lengths.input) : std::min(at_from, at_to);
  const double most = holds(low, high, pi) ? lengths.ground + lengths.input : std::max(at_from, at_to);
  return std::min(angle_at_diagonal(lengths, least), angle_at_diagonal(lengths, most));
}

double least_transmission_angle_full_turn(const LinkLengths& lengths) {
  return least_transmission_angle(lengths, 0, two_pi);
}

}  // namespace linkwright
