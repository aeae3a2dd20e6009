#include "approximate/real_cubic.hpp"

#include <algorithm>
#include <cmath>

namespace linkwright {
namespace {

double cubic_at(const std::array<double, 4>& c, double t) { return c[0] + t * (c[1] + t * (c[2] + t * c[3])); }

// Newton's method where it stays between the ends, and halving elsewhere.
double root_between(const std::array<double, 4>& c, double low, double high) {
  constexpr int most_steps = 80;
  constexpr double there = 1e-14;
  const bool rises = cubic_at(c, high) > 0;
  double t = 0.5 * (low + high);
  for (int step = 0; step < most_steps && high - low > there * (std::abs(low) + std::abs(high)); ++step) {
    const double value = cubic_at(c, t);
    if (value == 0) return t;
    ((value > 0) == rises ? high : low) = t;
    const double slope = c[1] + t * (2 * c[2] + 3 * t * c[3]), next = t - value / slope;
    if (std::abs(next - t) <= there * std::abs(t)) return next;
    t = next > low && next < high ? next : 0.5 * (low + high);
  }
  return t;
}

}  // namespace

RealRoots real_cubic_roots(const std::array<double, 4>& c) {
  constexpr double farthest = 1e6;
  std::array<double, 4> knots = {-farthest, farthest, farthest, farthest};
  std::size_t count = 1;
  const double half = c[2], square = half * half - 3 * c[3] * c[1];
  if (square > 0) {  // extremes at (−c₂ ± √square)/(3 c₃), written without cancellation
    const double q = -(half + std::copysign(std::sqrt(square), half));
    std::array<double, 2> extremes = {q / (3 * c[3]), c[1] / q};
    std::sort(extremes.begin(), extremes.end());
    for (const double at : extremes)
      if (std::abs(at) < farthest) knots[count++] = at;
  }
  knots[count] = farthest;
  RealRoots roots;
  for (std::size_t k = 0; k < count; ++k)
    if ((cubic_at(c, knots[k]) > 0) != (cubic_at(c, knots[k + 1]) > 0))
      roots.values[roots.count++] = root_between(c, knots[k], knots[k + 1]);
  return roots;
}

}  // namespace linkwright
