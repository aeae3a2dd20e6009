#include "linkwright/infinitesimal/stationary_curvature.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "algebra/binary_form.hpp"
#include "algebra/dense.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/core/precondition.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

// Roots closer than this (radians of a ray, share of a distance) are one: a double root's rounding parts it by as much.
constexpr double same_point = 1e-7;

// (w : x : y) of the canonical frame, in the fixed one.
Homogeneous fixed(const TurningInstant& instant, double w, Point canonical) {
  const Point turned = instant.tangent * canonical;
  return {w, turned.real() + w * instant.pole.real(), turned.imag() + w * instant.pole.imag()};
}

// A candidate of Burmester's points: z and the vector k z from its centre of curvature, over D.
struct Candidate {
  Point z;
  double k;
};

// The invariants over D, in which D = 1.
struct UnitInstant {
  double a3, b3, a4, b4;

  // Of |z − centre|², orders two to four.
  [[nodiscard]] std::array<double, 3> conditions(const Candidate& at) const {
    const double x = at.z.real(), y = at.z.imag(), square = std::norm(at.z);
    return {at.k * (y - square) + square, at.k * (a3 * x + b3 * y) + 3 * x,
            at.k * (square + a4 * x + b4 * y) - square + 4 * (b3 * x - a3 * y) - 6 * y + 3};
  }
  [[nodiscard]] Matrix3x3 slope(const Candidate& at) const {
    const double x = at.z.real(), y = at.z.imag(), k = at.k, square = std::norm(at.z);
    return {{{{2 * x * (1 - k), k + 2 * y * (1 - k), y - square},
              {k * a3 + 3, k * b3, a3 * x + b3 * y},
              {k * (2 * x + a4) - 2 * x + 4 * b3, k * (2 * y + b4) - 2 * y - 4 * a3 - 6, square + a4 * x + b4 * y}}}};
  }
};

double worst(const std::array<double, 3>& values) {
  return std::max({std::abs(values[0]), std::abs(values[1]), std::abs(values[2])});
}

// Newton's method while it improves.
Candidate polished(const UnitInstant& instant, Candidate at) {
  constexpr int turns = 8;
  double left = worst(instant.conditions(at));
  for (int turn = 0; turn < turns && left > 0; ++turn) {
    const auto values = instant.conditions(at);
    const Vector3 step = solve(instant.slope(at), {values[0], values[1], values[2]});
    const Candidate next{at.z - Point{step.x, step.y}, at.k - step.z};
    const double then = worst(instant.conditions(next));
    if (!(then < left)) break;
    left = then;
    at = next;
  }
  return at;
}

// On the ray: r = sin ψ cos ψ / (m cos ψ + n sin ψ), and k = r / (r − D sin ψ).
std::optional<Candidate> on_ray(double m, double n, double angle) {
  const double c = std::cos(angle), s = std::sin(angle), w = m * c + n * s;
  const double r = s * c / w, k = c / (c - w);
  if (!std::isfinite(r) || !std::isfinite(k)) return std::nullopt;
  return Candidate{r * Point{c, s}, k};
}

// Points of the pole normal, which belongs to the cubic where n vanishes: b4 y² … (the fourth order with k = y / (y −
// D)).
std::vector<Candidate> on_normal(const UnitInstant& instant) {
  std::vector<Candidate> found;
  const std::array<double, 3> quadratic = {-3, 9 + 4 * instant.a3, instant.b4 - 4 * instant.a3 - 5};
  for (const FormRoot& root : real_roots(quadratic, same_point)) {
    const double y = std::tan(root.angle);
    if (std::isfinite(y) && y != 1) found.push_back({{0, y}, y / (y - 1)});
  }
  return found;
}

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

CurvaturePair stationary_pair(const TurningInstant& instant, double ray_angle) {
  const double c = std::cos(ray_angle), s = std::sin(ray_angle), d = instant.diameter;
  const double w = instant.m() * c + instant.n() * s;
  // r = s c / w; r₀ = r D s / (D s − r) = s c D / (D w − c).
  const Point along = s * c * Point{c, s};
  return {fixed(instant, w, along), fixed(instant, d * w - c, d * along)};
}

Homogeneous conjugate_center(const TurningInstant& instant, double ray_angle, double distance) {
  const double s = std::sin(ray_angle), d = instant.diameter;
  return fixed(instant, d * s - distance, distance * d * s * Point{std::cos(ray_angle), s});
}

std::optional<Point> ball_point(const TurningInstant& instant) {
  const double a3 = instant.a3, b3 = instant.b3, d = instant.diameter, square = a3 * a3 + b3 * b3;
  if (!(square > tolerance::vanishing_motion * tolerance::vanishing_motion * d * d)) return std::nullopt;
  return instant.to_fixed(d * a3 / square * Point{-b3, a3});
}

std::vector<CurvaturePair> burmester_points_at(const TurningInstant& instant) {
  require(instant.fourth.has_value(), "Burmester's points take the fourth order");
  constexpr double on_conditions = 1e-9;
  const double d = instant.diameter, m = d * instant.m(), n = d * instant.n();
  const UnitInstant unit{instant.a3 / d, instant.b3 / d, instant.fourth->a4 / d, instant.fourth->b4 / d};
  const double a = 1 - m, c0 = 3 * m, c1 = 15 * n, c2 = 6 - 9 * m, c3 = 3 * n;
  const std::array<double, 5> quartic = {a * c0, unit.a4 + a * c1 - n * c0, unit.b4 + 1 + a * c2 - n * c1,
                                         a * c3 - n * c2, -n * c3};
  std::vector<Candidate> candidates;
  if (std::any_of(quartic.begin(), quartic.end(), [](double value) { return value != 0; }))
    for (const FormRoot& root : real_roots(quartic, same_point))
      if (const auto there = on_ray(m, n, root.angle)) candidates.push_back(*there);
  if (std::abs(n) < same_point)
    for (const Candidate& there : on_normal(unit)) candidates.push_back(there);
  std::vector<CurvaturePair> points;
  std::vector<Point> taken;
  for (const Candidate& rough : candidates) {
    const Candidate at = polished(unit, rough);
    const double size = 1 + std::norm(at.z) * std::abs(at.k);
    const auto is_same = [&](Point other) { return std::abs(other - at.z) <= same_point * std::abs(at.z); };
    if (!(worst(unit.conditions(at)) <= on_conditions * size) || std::any_of(taken.begin(), taken.end(), is_same))
      continue;
    taken.push_back(at.z);
    // The centre is z − k z.
    points.push_back({fixed(instant, 1, d * at.z), fixed(instant, 1, d * (1 - at.k) * at.z)});
  }
  return points;
}

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
