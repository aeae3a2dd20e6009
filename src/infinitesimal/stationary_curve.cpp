#include "linkwright/infinitesimal/stationary_curve.hpp"

#include <cmath>

#include "linkwright/core/angle.hpp"

namespace linkwright {
namespace {

// A coefficient of a cubic below this share of the other, or of 1 / D, is none: the bend by which the line and the
// circle of a cubic are joined at the pole is no wider than that.
constexpr double no_coefficient = 1e-9;

Homogeneous turned(Homogeneous p, Point origin, Point along) {
  const Point moved = along * p.vector() + p.w * origin;
  return {p.w, moved.real(), moved.imag()};
}

// The line through a point, whose way round is even for an eye at the distance `scale`.
std::function<Homogeneous(double)> line(Point through, Point along, double scale) {
  return [=](double share) {
    const double angle = pi * share;
    return turned({std::cos(angle), scale * std::sin(angle), 0}, through, along);
  };
}

// (x² + y²)(m x + n y) = x y by its rays.
StationaryCurve cubic(const TurningInstant& instant, double m, double n) {
  const double d = instant.diameter;
  const bool has_tangent = std::abs(m) * d <= no_coefficient * (1 + std::abs(n) * d);
  const bool has_normal = std::abs(n) * d <= no_coefficient * (1 + std::abs(m) * d);
  StationaryCurve curve;
  if (has_tangent) curve.pieces.push_back(line(instant.pole, instant.tangent, d));
  if (has_normal) curve.pieces.push_back(line(instant.pole, instant.tangent * Point{0, 1}, d));
  if (has_tangent && has_normal) return curve;
  curve.pieces.push_back([=](double share) {
    const double c = std::cos(pi * share), s = std::sin(pi * share);
    const double w = has_tangent ? n : has_normal ? m : m * c + n * s, r = has_tangent ? c : has_normal ? s : s * c;
    return turned({w, r * c, r * s}, instant.pole, instant.tangent);
  });
  return curve;
}

StationaryCurve hyperbola(const std::optional<EquilateralHyperbola>& shape, Point along, double scale) {
  if (!shape) return {};
  const double axis = std::sqrt(std::abs(shape->product)), sense = shape->product < 0 ? -1 : 1;
  if (axis <= no_coefficient * scale)
    return {{line(shape->center, along, scale), line(shape->center, along * Point{0, 1}, scale)}};
  return {{[=](double share) {
    const double c = std::cos(pi * share), s = std::sin(pi * share);
    return turned({s * c, axis * s * s, sense * axis * c * c}, shape->center, along);
  }}};
}

// A length of the motion that does not depend on the unit.
double scale_of(const TranslatingInstant& instant) { return 1 / std::sqrt(std::abs(instant.slope)); }

}  // namespace

StationaryCurve circling_point_curve(const Instant& instant) {
  if (const auto* turning = std::get_if<TurningInstant>(&instant)) return cubic(*turning, turning->m(), turning->n());
  if (const auto* moving = std::get_if<TranslatingInstant>(&instant))
    return hyperbola(moving->circling_points, moving->velocity, scale_of(*moving));
  return {};
}

StationaryCurve centering_point_curve(const Instant& instant) {
  if (const auto* turning = std::get_if<TurningInstant>(&instant))
    return cubic(*turning, turning->m() - 1 / turning->diameter, turning->n());
  if (const auto* moving = std::get_if<TranslatingInstant>(&instant))
    return hyperbola(moving->centering_points(), moving->velocity, scale_of(*moving));
  return {};
}

}  // namespace linkwright
