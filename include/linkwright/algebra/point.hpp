#pragma once

#include <cmath>
#include <complex>

namespace linkwright {

/// A point or vector of the plane as a complex number x + iy; multiplying by e^{iθ} turns it by θ counter-clockwise.
using Point = std::complex<double>;

/// Scalar product Re(ū v).
[[nodiscard]] inline double dot(Point u, Point v) { return u.real() * v.real() + u.imag() * v.imag(); }

/// Vector product Im(ū v): positive when v lies counter-clockwise of u.
[[nodiscard]] inline double cross(Point u, Point v) { return u.real() * v.imag() - u.imag() * v.real(); }

/// e^{iθ}, θ in radians.
[[nodiscard]] inline Point direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// Both coordinates are finite numbers.
[[nodiscard]] inline bool is_finite(Point p) { return std::isfinite(p.real()) && std::isfinite(p.imag()); }

}  // namespace linkwright
