#include "approximate/curve_least_squares.hpp"

#include <algorithm>
#include <cmath>

#include "approximate/fit_hinges.hpp"
#include "approximate/loop_slide.hpp"

namespace linkwright {
namespace {

using Equations = NormalEquations<fit_dimensions>;
using Numbers = Equations::Numbers;

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
    if (!equations_.damped_step(damping, step)) return false;
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
  Equations equations_;
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
  improve_by_steps<Step>(task, start, iterations);
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
