#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace linkwright {

/// A row of a least squares problem in `dimensions` unknowns: residual + row·dx.
template <std::size_t dimensions>
struct LeastSquaresRow {
  std::array<double, dimensions> row{};
  double residual = 0;
};

/// H dx = −g, lower triangle.
template <std::size_t dimensions>
struct NormalEquations {
  using Numbers = std::array<double, dimensions>;

  std::array<Numbers, dimensions> h{};
  Numbers g{};

  /// A row may leave the last unknowns out.
  template <std::size_t some>
  void add(const LeastSquaresRow<some>& row, double weight) {
    static_assert(some <= dimensions);
    for (std::size_t i = 0; i < some; ++i) {
      const double weighted = weight * row.row[i];
      g[i] += weighted * row.residual;
      for (std::size_t j = 0; j <= i; ++j) h[i][j] += weighted * row.row[j];
    }
  }
  /// Unknowns of these bits do not move.
  void hold(unsigned held) {
    for (std::size_t i = 0; i < dimensions; ++i) {
      if ((held >> i & 1) == 0) continue;
      for (std::size_t j = 0; j < dimensions; ++j) (j < i ? h[i][j] : h[j][i]) = 0;
      g[i] = 0;
    }
  }

  /// By Cholesky's method with the diagonal magnified; false where rounding leaves no positive pivot.
  [[nodiscard]] bool damped_step(double damping, Numbers& step) const {
    auto l = h;
    double trace = 0;
    for (std::size_t i = 0; i < dimensions; ++i) trace += l[i][i];
    const double least = 1e-15 * trace + 1e-300;
    for (std::size_t i = 0; i < dimensions; ++i) {
      l[i][i] += damping * l[i][i] + least;
      for (std::size_t j = 0; j <= i; ++j) {
        double sum = l[i][j];
        for (std::size_t k = 0; k < j; ++k) sum -= l[i][k] * l[j][k];
        if (i == j && !(sum > 0)) return false;
        l[i][j] = i == j ? std::sqrt(sum) : sum / l[j][j];
      }
    }
    for (std::size_t i = 0; i < dimensions; ++i) {
      double sum = -g[i];
      for (std::size_t k = 0; k < i; ++k) sum -= l[i][k] * step[k];
      step[i] = sum / l[i][i];
    }
    for (std::size_t i = dimensions; i-- > 0;) {
      for (std::size_t k = i + 1; k < dimensions; ++k) step[i] -= l[k][i] * step[k];
      step[i] /= l[i][i];
    }
    return true;
  }
};

/// Levenberg–Marquardt from a start on (`cost()`, `damping`, `converged`): a Step(task, start) holds the normal
/// equations there, and take(damping, next) says whether a step can be taken. Ends after `iterations`, or `converged`.
template <class Step, class Task, class Start>
void improve_by_steps(const Task& task, Start& start, int iterations) {
  constexpr double least_damping = 1e-14, most_damping = 1e10, standing = 1e-9;
  constexpr int standing_steps = 4;
  Start next = start;
  int stood = 0;
  for (int done = 0; done < iterations && !start.converged;) {
    const Step step(task, start);
    bool accepted = false;
    while (!accepted && done++ < iterations) {
      accepted = step.take(start.damping, next) && next.cost() < start.cost();
      start.damping = accepted ? std::max(start.damping / 6, least_damping) : start.damping * 5;
      if (start.damping > most_damping) break;
    }
    if (!accepted) {
      start.converged = start.damping > most_damping;
      if (start.converged) start.damping = 1e-3;
      return;
    }
    stood = start.cost() - next.cost() <= standing * start.cost() ? stood + 1 : 0;
    next.damping = start.damping;
    std::swap(start, next);
    start.converged = stood >= standing_steps;
  }
}

}  // namespace linkwright
