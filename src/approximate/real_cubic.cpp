#include "approximate/real_cubic.hpp"

#include <algorithm>
#include <cmath>

namespace linkwright {
namespace {

double cubic_at(const std::array<double, 4>& c, double t) { return c[0] + t * (c[1] + t * (c[2] + t * c[3])); }

// Newton's method where it stays between the ends, and halving elsewhere.
double root_between(const std::array<double, 4>& c, double low, double high) {
  constexpr int most_steps = 60;
  constexpr double there = 1e-10;
  const bool rises = cubic_at(c, high) > 0;
  double t = 0.5 * (low + high);
  for (int step = 0; step < most_steps; ++step) {
    const double value = cubic_at(c, t);
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
  std::array<double, 6> knots = {-farthest};
  std::size_t count = 1;
  const auto add = [&](double at) {
    if (at > knots[count - 1] && at < farthest) knots[count++] = at;
  };
  // About the bend the cubic is odd. Its extremes are `apart` from there, and where it has three roots, none is farther
  // than twice that.
  const double bend = -c[2] / (3 * c[3]), square = bend * bend - c[1] / (3 * c[3]);
  const double apart = std::sqrt(std::abs(square));
  add(bend - 2 * apart);
  if (square > 0) add(bend - apart);
  if (square > 0) add(bend + apart);
  add(bend + 2 * apart);
  knots[count] = farthest;
  RealRoots roots;
  for (std::size_t k = 0; k < count && roots.count < roots.values.size(); ++k)
    if ((cubic_at(c, knots[k]) > 0) != (cubic_at(c, knots[k + 1]) > 0))
      roots.values[roots.count++] = root_between(c, knots[k], knots[k + 1]);
  return roots;
}

}  // namespace linkwright
