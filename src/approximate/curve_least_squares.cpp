#include "approximate/curve_least_squares.hpp"

#include <algorithm>
#include <cmath>

#include "approximate/fit_hinges.hpp"
#include "approximate/loop_slide.hpp"

namespace linkwright {
namespace {

using Numbers = std::array<double, fit_dimensions>;

// H dx = −g, lower triangle.
struct NormalEquations {
  std::array<Numbers, fit_dimensions> h{};
  Numbers g{};

  void add(const FitRow& row, double weight) {
    for (std::size_t i = 0; i < fit_dimensions; ++i) {
      const double weighted = weight * row.row[i];
      g[i] += weighted * row.residual;
      for (std::size_t j = 0; j <= i; ++j) h[i][j] += weighted * row.row[j];
    }
  }
  void hold(unsigned held) {
    for (std::size_t i = 0; i < fit_dimensions; ++i) {
      if ((held >> i & 1) == 0) continue;
      for (std::size_t j = 0; j < fit_dimensions; ++j) (j < i ? h[i][j] : h[j][i]) = 0;
      g[i] = 0;
    }
  }
};

// By Cholesky's method with the diagonal magnified; false where rounding leaves no positive pivot.
bool damped_step(const NormalEquations& equations, double damping, Numbers& step) {
  constexpr std::size_t n = fit_dimensions;
  auto l = equations.h;
  double trace = 0;
  for (std::size_t i = 0; i < n; ++i) trace += l[i][i];
  const double least = 1e-15 * trace + 1e-300;
  for (std::size_t i = 0; i < n; ++i) {
    l[i][i] += damping * l[i][i] + least;
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = l[i][j];
      for (std::size_t k = 0; k < j; ++k) sum -= l[i][k] * l[j][k];
      if (i == j && !(sum > 0)) return false;
      l[i][j] = i == j ? std::sqrt(sum) : sum / l[j][j];
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    double sum = -equations.g[i];
    for (std::size_t k = 0; k < i; ++k) sum -= l[i][k] * step[k];
    step[i] = sum / l[i][i];
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t k = i + 1; k < n; ++k) step[i] -= l[k][i] * step[k];
    step[i] /= l[i][i];
  }
  return true;
}

CouplerLinkage moved(const CouplerLinkage& l, const Numbers& by) {
  return {l.a0 + Point{by[0], by[1]}, l.b0 + Point{by[2], by[3]}, l.a + by[4], l.h + by[5], l.b + by[6],
          l.p + Point{by[7], by[8]}};
}

std::array<FitRow, 2> rows_of(const LoopSlide& slide) {
  const double speed = std::sqrt(std::norm(slide.velocity));
  const Point tangent = speed > 0 ? slide.velocity / speed : Point{1, 0}, normal = quarter_turn(tangent);
  const double left = std::sqrt(LoopSlide::rest * slide.stiffness);
  std::array<FitRow, 2> rows;
  rows[0].residual = dot(normal, slide.off);
  rows[1].residual = left * dot(tangent, slide.off);
  for (std::size_t i = 0; i < fit_dimensions; ++i) {
    rows[0].row[i] = dot(normal, slide.point_rows[i]);
    rows[1].row[i] = left * dot(tangent, slide.point_rows[i]);
  }
  return rows;
}

// Where each state goes while the linkage moves by dx: rows of a state kept from the normal equations.
struct StateMove {
  LoopState at;
  double along, across;
};

class Step {
 public:
  Step(const FitTask& task, const CurveStart& start) : task_(task), start_(start) {
    slides_.reserve(start.states.size());
    constexpr double all_but_at_rest = 1e-3;  // above it what is left along the curve is below a millionth
    for (std::size_t j = 0; j < start.states.size(); ++j) {
      const LoopSlide& slide = slides_.emplace_back(start.linkage, start.states[j], task.points[j]);
      const auto rows = rows_of(slide);
      equations_.add(rows[0], task.weights[j]);
      if (std::norm(slide.velocity) < all_but_at_rest) equations_.add(rows[1], task.weights[j]);
    }
    add_hinges();
    equations_.hold(start.held);
  }

  /// The start after a damped step; false where there is none, or a loop does not close.
  [[nodiscard]] bool take(double damping, CurveStart& next) const {
    Numbers step{};
    if (!damped_step(equations_, damping, step)) return false;
    next.linkage = moved(start_.linkage, step);
    if (!(next.linkage.a > 0 && next.linkage.h > 0 && next.linkage.b > 0)) return false;
    for (std::size_t j = 0; j < slides_.size(); ++j) {
      next.states[j] = slid(slides_[j], start_.states[j], step);
      if (!close_loop(next.linkage, next.states[j])) return false;
    }
    evaluate(task_, next);
    return std::isfinite(next.cost());
  }

 private:
  void add_hinges() {
    std::vector<FitRow> hinges;
    append_linkage_hinges(task_.limits, start_.linkage, hinges);
    if (start_.branch != 0) {
      for (std::size_t j = 0; j < start_.states.size(); ++j) {
        const auto row =
            branch_hinge(task_.limits.min_sine, start_.branch, start_.linkage, start_.states[j], task_.points[j]);
        if (row) hinges.push_back(*row);
      }
    }
    for (const FitRow& row : hinges) equations_.add(row, 1);
  }

  static LoopState slid(const LoopSlide& slide, const LoopState& from, const Numbers& step) {
    constexpr double longest = 0.4;  // radians: beyond it the first order means nothing
    double along = slide.slide, closure = slide.loop.f;
    for (std::size_t i = 0; i < fit_dimensions; ++i) {
      along += slide.slide_row[i] * step[i];
      closure += slide.closure_row[i] * step[i];
    }
    along = std::clamp(along, -longest, longest);
    const double across = std::clamp(-closure / slide.length, -longest, longest);
    const double e = slide.loop.f_e / slide.length, u = slide.loop.f_u / slide.length;
    return turned(from, across * e - along * u, across * u + along * e);
  }

  const FitTask& task_;
  const CurveStart& start_;
  std::vector<LoopSlide> slides_;
  NormalEquations equations_;
};

}  // namespace

std::array<FitRow, 2> distance_rows(const CouplerLinkage& linkage, const LoopState& at, Point target) {
  return rows_of(LoopSlide(linkage, at, target));
}

void evaluate(const FitTask& task, CurveStart& start) {
  start.squares = start.penalties = 0;
  for (std::size_t j = 0; j < start.states.size(); ++j) {
    start.squares += task.weights[j] * std::norm(traced_point(start.linkage, start.states[j]) - task.points[j]);
    if (start.branch == 0) continue;
    const auto row = branch_hinge(task.limits.min_sine, start.branch, start.linkage, start.states[j], task.points[j]);
    if (row) start.penalties += row->residual * row->residual;
  }
  std::vector<FitRow> hinges;
  append_linkage_hinges(task.limits, start.linkage, hinges);
  for (const FitRow& row : hinges) start.penalties += row.residual * row.residual;
}

void improve(const FitTask& task, CurveStart& start, int iterations) {
  constexpr double least_damping = 1e-14, most_damping = 1e10, standing = 1e-9;
  constexpr int standing_steps = 4;
  CurveStart next = start;
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

void slide_to_nearest(const FitTask& task, CurveStart& start) {
  constexpr int most_steps = 60;
  constexpr double there = 1e-15, longest = 0.2;
  for (std::size_t j = 0; j < start.states.size(); ++j) {
    for (int step = 0; step < most_steps; ++step) {
      const LoopSlide slide(start.linkage, start.states[j], task.points[j]);
      const double by = std::clamp(slide.slide, -longest, longest);
      LoopState next = turned(start.states[j], -by * slide.loop.f_u / slide.length, by * slide.loop.f_e / slide.length);
      if (!close_loop(start.linkage, next)) break;
      const bool nearer = std::norm(traced_point(start.linkage, next) - task.points[j]) < std::norm(slide.off);
      if (nearer) start.states[j] = next;
      if (!nearer || std::abs(by) < there) break;
    }
  }
  evaluate(task, start);
}

}  // namespace linkwright
