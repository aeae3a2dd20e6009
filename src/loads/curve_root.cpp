#include "curve_root.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace linkwright {

// Inverse quadratic interpolation while the curve bends little, else halving (T. R. Chandrupatla, Advances in
// Engineering Software 28, 145, 1997).
double root_between(double low, double high, const Curve& curve) {
  constexpr int most_turns = 100;
  const auto value = [&](double turn) { return curve(turn).value_or(std::numeric_limits<double>::infinity()); };
  double a = high, b = low, f_a = value(a), f_b = value(b);
  double share = 0.5;
  for (int i = 0; i < most_turns && f_b != 0; ++i) {
    const double turn = a + share * (b - a);
    const double f = value(turn);
    double c = b, f_c = f_b;
    if ((f < 0) == (f_a < 0))
      c = a, f_c = f_a;
    else
      b = a, f_b = f_a;
    a = turn;
    f_a = f;
    const double tolerance = 2 * std::numeric_limits<double>::epsilon() * std::abs(a) / std::abs(b - a);
    if (f_a == 0 || !(tolerance < 0.5)) return a;
    const double x = (a - b) / (c - b), y = (f_a - f_b) / (f_c - f_b);
    const bool bends_little = std::isfinite(y) && y * y < x && (1 - y) * (1 - y) < 1 - x;
    share = 0.5;
    if (bends_little)
      share = f_a / (f_b - f_a) * f_c / (f_b - f_c) + (c - a) / (b - a) * f_a / (f_c - f_a) * f_b / (f_c - f_b);
    share = std::clamp(std::isfinite(share) ? share : 0.5, tolerance, 1 - tolerance);
  }
  return b;
}

}  // namespace linkwright
