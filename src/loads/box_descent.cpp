#include "box_descent.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace linkwright {
namespace {

constexpr std::size_t n = BoxDescent::unknowns;

double sum_of_squares(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value * value;
  return sum;
}

/// Of a positive definite matrix, by Cholesky's method.
BoxDescent::Place solved(std::array<std::array<double, n>, n> a, BoxDescent::Place b) {
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t j = 0; j < k; ++j) a[k][k] -= a[k][j] * a[k][j];
    a[k][k] = std::sqrt(a[k][k]);
    for (std::size_t i = k + 1; i < n; ++i) {
      for (std::size_t j = 0; j < k; ++j) a[i][k] -= a[i][j] * a[k][j];
      a[i][k] /= a[k][k];
    }
  }
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t j = 0; j < k; ++j) b[k] -= a[k][j] * b[j];
    b[k] /= a[k][k];
  }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t j = k + 1; j < n; ++j) b[k] -= a[j][k] * b[j];
    b[k] /= a[k][k];
  }
  return b;
}

}  // namespace

BoxDescent::BoxDescent(Place low, Place high, double size, Residuals residuals)
    : low_(low), high_(high), size_(size), residuals_(std::move(residuals)) {}

double BoxDescent::square_at(const Place& at) const { return sum_of_squares(residuals_(at)); }

BoxDescent::Place BoxDescent::within(Place at) const {
  for (std::size_t k = 0; k < n; ++k) at[k] = std::clamp(at[k], low_[k], high_[k]);
  return at;
}

std::vector<BoxDescent::Found> BoxDescent::best_of_grid(int along, std::size_t most) const {
  std::array<int, n> count{}, index{};
  for (std::size_t k = 0; k < n; ++k) count[k] = high_[k] > low_[k] ? along : 1;
  std::vector<Found> best;
  const auto worse = [](const Found& a, const Found& b) { return a.square < b.square; };
  for (bool more = true; more;) {
    Found here;
    for (std::size_t k = 0; k < n; ++k) here.at[k] = low_[k] + (high_[k] - low_[k]) * (index[k] + 0.5) / count[k];
    here.square = square_at(here.at);
    if (std::isfinite(here.square) && (best.size() < most || here.square < best.front().square)) {
      if (best.size() == most) {
        std::pop_heap(best.begin(), best.end(), worse);
        best.pop_back();
      }
      best.push_back(here);
      std::push_heap(best.begin(), best.end(), worse);
    }
    std::size_t k = 0;
    while (k < n && ++index[k] == count[k]) index[k++] = 0;
    more = k < n;
  }
  std::sort_heap(best.begin(), best.end(), worse);
  return best;
}

BoxDescent::Slope BoxDescent::slope_at(const Place& at, const std::vector<double>& here) const {
  constexpr double share = 1e-6;
  std::array<std::vector<double>, n> columns;
  for (std::size_t k = 0; k < n; ++k) {
    const double step = share * size_;
    Place ahead = at, back = at;
    ahead[k] += step, back[k] -= step;
    columns[k] = residuals_(ahead);
    const std::vector<double> behind = residuals_(back);
    for (std::size_t i = 0; i < here.size(); ++i) columns[k][i] = (columns[k][i] - behind[i]) / (2 * step);
  }
  Slope slope;
  for (std::size_t i = 0; i < here.size(); ++i)
    for (std::size_t j = 0; j < n; ++j) {
      slope.gradient[j] += columns[j][i] * here[i];
      for (std::size_t k = 0; k < n; ++k) slope.normal[j][k] += columns[j][i] * columns[k][i];
    }
  return slope;
}

BoxDescent::Place BoxDescent::step_of(const Slope& slope, const Place& at, double damping) const {
  auto [normal, gradient] = slope;
  double trace = 0;
  for (std::size_t k = 0; k < n; ++k) trace += normal[k][k];
  Place right{};
  for (std::size_t k = 0; k < n; ++k) {
    const bool rests = (at[k] <= low_[k] && gradient[k] >= 0) || (at[k] >= high_[k] && gradient[k] <= 0);
    right[k] = rests ? 0 : -gradient[k];
    if (rests)
      for (std::size_t j = 0; j < n; ++j) normal[k][j] = normal[j][k] = 0;
    normal[k][k] += rests ? 1 : damping * (normal[k][k] + 1e-9 * trace) + 1e-300;
  }
  return solved(normal, right);
}

BoxDescent::Found BoxDescent::descend(const Place& from) const {
  constexpr int most_steps = 100;
  constexpr double settled = 1e-11, enough = 1e-14, softest = 1e-12, stiffest = 1e12;
  Found best{within(from), 0};
  std::vector<double> here = residuals_(best.at);
  best.square = sum_of_squares(here);
  double damping = 1e-3;
  for (int step = 0; step < most_steps && damping < stiffest; ++step) {
    const Slope slope = slope_at(best.at, here);
    double gain = 0, way = 0;
    for (; damping < stiffest; damping *= 10) {
      const Place by = step_of(slope, best.at, damping);
      Place at = best.at;
      for (std::size_t k = 0; k < n; ++k) at[k] += by[k];
      at = within(at);
      std::vector<double> there = residuals_(at);
      const double square = sum_of_squares(there);
      if (!(square < best.square)) continue;
      for (std::size_t k = 0; k < n; ++k) way = std::max(way, std::abs(at[k] - best.at[k]));
      gain = best.square - square;
      best = {at, square};
      here = std::move(there);
      damping = std::max(softest, damping / 10);
      break;
    }
    if (way <= settled * size_ || gain <= enough * best.square) break;
  }
  return best;
}

}  // namespace linkwright
