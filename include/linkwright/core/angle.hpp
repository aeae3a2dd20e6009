#pragma once

#include <cmath>

namespace linkwright {

inline constexpr double pi = 3.14159265358979323846;
inline constexpr double two_pi = 2 * pi;

/// Degrees in radians.
[[nodiscard]] constexpr double radians(double degrees) { return degrees * (pi / 180); }
[[nodiscard]] constexpr double degrees(double radians) { return radians * (180 / pi); }

/// The angle in [0, 2π) that differs from `angle` by whole turns.
[[nodiscard]] inline double wrap_positive(double angle) {
  const double wrapped = std::fmod(angle, two_pi);
  const double positive = wrapped < 0 ? wrapped + two_pi : wrapped;
  return positive < two_pi ? positive : 0;
}

/// The angle in (−π, π] that differs from `angle` by whole turns.
[[nodiscard]] inline double wrap_signed(double angle) {
  const double wrapped = std::remainder(angle, two_pi);
  return wrapped <= -pi ? wrapped + two_pi : wrapped;
}

/// The fraction of `value` in [0, period): curve coordinates run round.
[[nodiscard]] inline double wrap_period(double value, double period) {
  const double wrapped = std::fmod(value, period);
  const double positive = wrapped < 0 ? wrapped + period : wrapped;
  return positive < period ? positive : 0;
}

}  // namespace linkwright
