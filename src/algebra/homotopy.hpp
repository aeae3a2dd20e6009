#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "linkwright/algebra/point.hpp"

namespace linkwright {

// Solutions of a square system of polynomials, followed as the system changes with t from 0 to 1 (A. J. Sommese,
// C. W. Wampler, The Numerical Solution of Systems of Polynomials, 2005, chapter 2).

template <std::size_t N>
using ComplexVector = std::array<Point, N>;

/// A system at unknowns and a t: its values, and their derivatives by the unknowns (a row to each) and by t.
template <std::size_t N>
struct SystemAt {
  ComplexVector<N> value{};
  std::array<ComplexVector<N>, N> by_unknown{};
  ComplexVector<N> by_t{};
};

/// A square matrix in triangular factors, with row pivots.
template <std::size_t N>
class Factored {
 public:
  explicit Factored(std::array<ComplexVector<N>, N> matrix) : m_(std::move(matrix)) {
    for (std::size_t k = 0; k < N; ++k) {
      std::size_t best = k;
      for (std::size_t i = k + 1; i < N; ++i)
        if (std::norm(m_[i][k]) > std::norm(m_[best][k])) best = i;
      swapped_[k] = best;
      std::swap(m_[k], m_[best]);
      const Point inverse = 1.0 / m_[k][k];
      for (std::size_t i = k + 1; i < N; ++i) {
        m_[i][k] *= inverse;
        for (std::size_t j = k + 1; j < N; ++j) m_[i][j] -= m_[i][k] * m_[k][j];
      }
    }
  }
  /// Not finite where the matrix is singular.
  [[nodiscard]] ComplexVector<N> solve(ComplexVector<N> right) const {
    for (std::size_t k = 0; k < N; ++k) std::swap(right[k], right[swapped_[k]]);
    for (std::size_t k = 0; k < N; ++k)
      for (std::size_t i = k + 1; i < N; ++i) right[i] -= m_[i][k] * right[k];
    for (std::size_t k = N; k-- > 0;) {
      for (std::size_t j = k + 1; j < N; ++j) right[k] -= m_[k][j] * right[j];
      right[k] /= m_[k][k];
    }
    return right;
  }

 private:
  std::array<ComplexVector<N>, N> m_;
  std::array<std::size_t, N> swapped_{};
};

/// How closely a path is followed. Errors are shares of the unknowns' sizes.
struct TrackLimits {
  double predicted = 1e-3, corrected = 1e-6;  ///< step of the first and of the second Newton iteration
  double first_step = 0.02, longest_step = 0.2, shortest_step = 1e-9;
  double largest = 1e7;  ///< of an unknown; beyond it a solution is on its way to infinity
  int most_steps = 2000;
};

/// The largest change of an unknown, as a share of its size.
template <std::size_t N>
[[nodiscard]] double relative_step(const ComplexVector<N>& step, const ComplexVector<N>& at) {
  constexpr double least = 1e-4;
  double largest = 0;
  for (std::size_t i = 0; i < N; ++i) largest = std::max(largest, std::norm(step[i]) / (std::norm(at[i]) + least));
  return std::sqrt(largest);
}

/// A Newton iteration at a t: the unknowns after it.
template <std::size_t N>
struct NewtonStep {
  ComplexVector<N> unknowns;
  double size = 0;  ///< relative_step(), NaN where the derivatives are singular
  Factored<N> factored;

  NewtonStep(ComplexVector<N> from, const SystemAt<N>& at) : unknowns(from), factored(at.by_unknown) {
    const ComplexVector<N> step = factored.solve(at.value);
    for (std::size_t i = 0; i < N; ++i) unknowns[i] -= step[i];
    size = relative_step(step, unknowns);
  }
  /// How they move with t, by the derivatives before it.
  [[nodiscard]] ComplexVector<N> tangent(const SystemAt<N>& at) const {
    ComplexVector<N> tangent = factored.solve(at.by_t);
    for (Point& z : tangent) z = -z;
    return tangent;
  }
};

/// A solution at a t.
template <std::size_t N>
struct FollowedTo {
  double t = 0;
  ComplexVector<N> unknowns, tangent;
};

/// Where a solution would be at a t: by the cubic through the two last places and tangents, from one place by its
/// tangent.
template <std::size_t N>
[[nodiscard]] ComplexVector<N> predicted(const FollowedTo<N>& last, const std::optional<FollowedTo<N>>& before,
                                         double t) {
  ComplexVector<N> found = last.unknowns;
  const double ahead = t - last.t;
  if (!before) {
    for (std::size_t i = 0; i < N; ++i) found[i] += ahead * last.tangent[i];
    return found;
  }
  const double length = last.t - before->t, s = (t - before->t) / length;
  const double h00 = (1 + 2 * s) * (1 - s) * (1 - s), h10 = s * (1 - s) * (1 - s), h01 = s * s * (3 - 2 * s),
               h11 = s * s * (s - 1);
  for (std::size_t i = 0; i < N; ++i)
    found[i] = h00 * before->unknowns[i] + h10 * length * before->tangent[i] + h01 * last.unknowns[i] +
               h11 * length * last.tangent[i];
  return found;
}

/// Where a second Newton iteration ends; nothing where it moves too far or too large a number. A step that does not
/// move it is a singular system's, not a success: derivatives that overflow invert to 0.
template <std::size_t N>
[[nodiscard]] std::optional<FollowedTo<N>> corrected(const NewtonStep<N>& once, const SystemAt<N>& at, double t,
                                                     const TrackLimits& limits) {
  const NewtonStep<N> twice(once.unknowns, at);
  const bool is_taken = twice.size < limits.corrected && once.size + twice.size > 0 &&
                        std::all_of(twice.unknowns.begin(), twice.unknowns.end(),
                                    [&](Point z) { return std::norm(z) < limits.largest * limits.largest; });
  if (!is_taken) return std::nullopt;
  return FollowedTo<N>{t, twice.unknowns, twice.tangent(at)};
}

/// The solution at t = 1 of a path that begins in `start` at t = 0. `system(unknowns, t)`: a SystemAt. Nothing where it
/// runs to infinity, or where it could not be followed.
template <std::size_t N, class System>
[[nodiscard]] std::optional<ComplexVector<N>> followed(const ComplexVector<N>& start, const System& system,
                                                       const TrackLimits& limits = {}) {
  const SystemAt<N> at_start = system(start, 0.0);
  const NewtonStep<N> first(start, at_start);
  FollowedTo<N> last{0, first.unknowns, first.tangent(at_start)};
  std::optional<FollowedTo<N>> before;
  double step = limits.first_step;
  for (int i = 0; i < limits.most_steps && last.t < 1; ++i) {
    const double t = std::min(1.0, last.t + step);
    const ComplexVector<N> guess = predicted(last, before, t);
    const NewtonStep<N> once(guess, system(guess, t));
    auto next = once.size < 10 * limits.predicted ? corrected(once, system(once.unknowns, t), t, limits) : std::nullopt;
    const double fit = 0.85 * std::pow(std::max(once.size, 1e-12) / limits.predicted, -0.25);
    if (next) {
      before = std::exchange(last, *next);
      step = std::min(limits.longest_step, step * std::clamp(fit, 0.3, 2.5));
    } else {
      step *= std::isfinite(fit) ? std::clamp(fit, 0.1, 0.5) : 0.5;
      if (step < limits.shortest_step) return std::nullopt;
    }
  }
  return last.t < 1 ? std::nullopt : std::optional(last.unknowns);
}

/// Newton iterations until they no longer help; how large the last one was, as a share.
template <std::size_t N, class System>
double polish(ComplexVector<N>& unknowns, const System& system, double t) {
  constexpr int most = 6;
  constexpr double exact = 1e-14;
  double size = 1;
  for (int i = 0; i < most && size > exact; ++i) {
    const NewtonStep<N> step(unknowns, system(unknowns, t));
    if (!(step.size < 1)) return 1;
    unknowns = step.unknowns;
    size = step.size;
  }
  return size;
}

}  // namespace linkwright
