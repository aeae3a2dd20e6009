#include "binary_form.hpp"

#include <algorithm>
#include <cmath>

#include "algebra/dense.hpp"
#include "linkwright/core/angle.hpp"

namespace linkwright {
namespace {

// The coefficients over the frame whose second axis is the direction (cos t, sin t) turned to (0, 1).
std::vector<double> turned(std::span<const double> a, double t) {
  const double c0 = std::sin(t), s0 = -std::cos(t);  // c = c0 c' + c1 s', s = s0 c' + s1 s'
  const double c1 = std::cos(t), s1 = std::sin(t);
  const std::size_t degree = a.size() - 1;
  const auto times = [](std::vector<double> p, double constant, double linear) {
    p.push_back(0);
    for (std::size_t k = p.size() - 1; k > 0; --k) p[k] = constant * p[k] + linear * p[k - 1];
    p[0] *= constant;
    return p;
  };
  std::vector<double> sum(a.size(), 0);
  for (std::size_t k = 0; k <= degree; ++k) {
    std::vector<double> term = {a[k]};
    for (std::size_t i = 0; i < degree - k; ++i) term = times(std::move(term), c0, c1);
    for (std::size_t i = 0; i < k; ++i) term = times(std::move(term), s0, s1);
    for (std::size_t i = 0; i <= degree; ++i) sum[i] += term[i];
  }
  return sum;
}

double direction_of_largest(std::span<const double> a) {
  constexpr int looks = 37;
  double best = 0, largest = -1;
  for (int i = 0; i < looks; ++i) {
    const double t = pi * i / looks, value = std::abs(form_value(a, std::cos(t), std::sin(t)));
    if (value > largest) {
      largest = value;
      best = t;
    }
  }
  return best;
}

// ∂/∂t, again a form of the same degree.
std::vector<double> derivative(std::span<const double> a) {
  const std::size_t degree = a.size() - 1;
  std::vector<double> slope(a.size(), 0);
  for (std::size_t k = 0; k <= degree; ++k) {
    if (k < degree) slope[k] += static_cast<double>(k + 1) * a[k + 1];
    if (k > 0) slope[k] -= static_cast<double>(degree - k + 1) * a[k - 1];
  }
  return slope;
}

double polished(std::span<const double> a, double t) {
  constexpr int turns = 3;  // what the eigenvalues leave is 1e-13, and convergence is quadratic
  const std::vector<double> slope = derivative(a);
  for (int turn = 0; turn < turns; ++turn) {
    const double value = form_value(a, std::cos(t), std::sin(t)), rise = form_value(slope, std::cos(t), std::sin(t));
    if (rise == 0) return t;
    const double next = t - value / rise;
    if (!(std::abs(form_value(a, std::cos(next), std::sin(next))) < std::abs(value))) return t;
    t = next;
  }
  return t;
}

}  // namespace

double form_value(std::span<const double> a, double c, double s) {
  double sum = 0, power_of_s = 1;
  for (std::size_t k = 0; k < a.size(); ++k) {
    double term = a[k] * power_of_s;
    for (std::size_t i = k + 1; i < a.size(); ++i) term *= c;
    sum += term;
    power_of_s *= s;
  }
  return sum;
}

std::vector<FormRoot> real_roots(std::span<const double> a, double same) {
  const double t0 = direction_of_largest(a);
  std::vector<double> near;
  for (const std::complex<double> root : all_roots(turned(a, t0))) {
    const double x = root.real(), off = std::abs(root.imag()) / (1 + x * x);
    if (off < same) near.push_back(wrap_period(t0 - pi / 2 + std::atan(x), pi));
  }
  std::sort(near.begin(), near.end());
  std::vector<FormRoot> roots;
  for (const double angle : near) {
    if (!roots.empty() && angle - roots.back().angle < same) {
      FormRoot& known = roots.back();
      known.angle = (known.angle * known.multiplicity + angle) / (known.multiplicity + 1);
      ++known.multiplicity;
    } else {
      roots.push_back({angle, 1});
    }
  }
  if (roots.size() > 1 && roots.front().angle + pi - roots.back().angle < same) {
    roots.front().multiplicity += roots.back().multiplicity;
    roots.pop_back();
  }
  for (FormRoot& root : roots)
    if (root.multiplicity == 1) root.angle = wrap_period(polished(a, root.angle), pi);
  std::sort(roots.begin(), roots.end(), [](const FormRoot& p, const FormRoot& q) { return p.angle < q.angle; });
  return roots;
}

}  // namespace linkwright
