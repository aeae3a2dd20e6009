#include "configuration_curve.hpp"

#include <algorithm>
#include <cmath>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

constexpr int max_corrections = 8;  // quadratic from a certified start: four do

double wrapped(double angle) { return angle > pi ? angle - two_pi : angle < -pi ? angle + two_pi : angle; }

TorusVector real_row(Point by_input, Point by_coupler, Point by_output) {
  return {by_input.real(), by_coupler.real(), by_output.real()};
}

TorusVector imaginary_row(Point by_input, Point by_coupler, Point by_output) {
  return {by_input.imag(), by_coupler.imag(), by_output.imag()};
}

/// Smaller singular value of the 2×3 matrix with rows u and v, whose vector product has length `volume`: the product of
/// the two is the volume (Cauchy–Binet), the sum of their squares that of the entries.
double smaller_singular_value(TorusVector u, TorusVector v, double volume) {
  const double uu = dot(u, u), vv = dot(v, v), uv = dot(u, v);
  const double larger = std::sqrt((uu + vv + std::hypot(uu - vv, 2 * uv)) / 2);
  return larger > 0 ? volume / larger : 0;
}

}  // namespace

double norm(TorusVector a) { return std::sqrt(dot(a, a)); }

TorusVector wrapped(TorusVector p) { return {wrapped(p.input), wrapped(p.coupler), wrapped(p.output)}; }

TorusVector shortest_way(TorusVector from, TorusVector to) { return wrapped(to + -1 * from); }

PlanarConfigurationCurve::PlanarConfigurationCurve(const LinkLengths& lengths) : lengths_(lengths) {
  const double perimeter = lengths.perimeter();
  shape_ = {lengths.ground / perimeter, lengths.input / perimeter, lengths.coupler / perimeter,
            lengths.output / perimeter};
}

PlanarConfigurationCurve::Loop PlanarConfigurationCurve::loop_at(TorusVector p) const {
  const Point input = shape_.input * direction(p.input), coupler = shape_.coupler * direction(p.coupler),
              output = shape_.output * direction(p.output);
  const auto quarter_turn = [](Point v) { return Point{-v.imag(), v.real()}; };
  return {input + coupler - shape_.ground - output, quarter_turn(input), quarter_turn(coupler), -quarter_turn(output)};
}

// Let σ be the Jacobian's smaller singular value at the point and Λ = max(a, h, b): the Jacobian changes by at most
// Λ|d| over a distance d. Within |d| < σ/Λ it thus stays regular on the planes normal to the tangent, and F is
// injective on the part of each plane within the ball: one strand. At a quarter of that radius the strand's slope
// against the tangent is at most (1/4)/(1 − 1/4) = 1/3, and Newton's method converges from the tangent (Kantorovich).
ConfigurationCurve::Strand PlanarConfigurationCurve::strand_at(TorusVector point) const {
  const Loop loop = loop_at(point);
  const TorusVector u = real_row(loop.by_input, loop.by_coupler, loop.by_output);
  const TorusVector v = imaginary_row(loop.by_input, loop.by_coupler, loop.by_output);
  const TorusVector along = cross(u, v);
  const double volume = norm(along);
  const double sigma = smaller_singular_value(u, v, volume);
  const double steepest = std::max({shape_.input, shape_.coupler, shape_.output});
  return {point, volume > 0 ? (1 / volume) * along : along, sigma / (4 * steepest), sigma, std::abs(loop.closure)};
}

std::optional<TorusVector> PlanarConfigurationCurve::advanced(const Strand& strand, double along,
                                                              double accuracy) const {
  // |F| / σ is the distance from the curve: it must be small beside the reach, but cannot be less than rounding makes
  // it.
  const double enough =
      std::max(tolerance::loop_rounding, std::min(accuracy, 0.01 * strand.singular_value * strand.reach));
  const TorusVector t = strand.tangent;
  TorusVector p = strand.point + along * t;
  for (int i = 0; i < max_corrections; ++i) {
    const Loop loop = loop_at(p);
    if (std::abs(loop.closure) <= enough) return p;
    const TorusVector u = real_row(loop.by_input, loop.by_coupler, loop.by_output);
    const TorusVector v = imaginary_row(loop.by_input, loop.by_coupler, loop.by_output);
    // Cramer's rule for u·δ = −Re F, v·δ = −Im F, t·δ = 0.
    const TorusVector vt = cross(v, t), tu = cross(t, u);
    const double determinant = dot(u, vt);
    if (!(std::abs(determinant) > 0)) return std::nullopt;
    p = p + (-1 / determinant) * (loop.closure.real() * vt + loop.closure.imag() * tu);
  }
  return std::nullopt;
}

HingePlaces PlanarConfigurationCurve::moving_hinges(TorusVector p) const {
  const Point input = lengths_.input * direction(p.input),
              output = lengths_.ground + lengths_.output * direction(p.output);
  return {{{input.real(), input.imag(), 0}, {output.real(), output.imag(), 0}}};
}

}  // namespace linkwright
