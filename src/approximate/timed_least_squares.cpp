#include "approximate/timed_least_squares.hpp"

#include <cmath>
#include <optional>

#include "approximate/damped_least_squares.hpp"
#include "approximate/fit_hinges.hpp"

namespace linkwright {
namespace {

constexpr std::size_t timed_dimensions = fit_dimensions + 1;
constexpr std::size_t datum_at = fit_dimensions;
using TimedEquations = NormalEquations<timed_dimensions>;
using TimedNumbers = TimedEquations::Numbers;

// Coupler's direction at that of the input: of the two that close the loop the one of the branch, which is the sign of
// cross(u, B − B0).
std::optional<Point> coupler_at(const CouplerLinkage& l, Point e, int branch) {
  const Point w = l.a0 - l.b0 + l.a * e;
  const double square = std::norm(w), along = (l.b * l.b - l.h * l.h - square) / (2 * l.h);
  const double across = square - along * along;
  if (!(across > 0)) return std::nullopt;
  const Point u = product(w, {along, -branch * std::sqrt(across)}) / square;
  return (1.5 - 0.5 * std::norm(u)) * u;  // a step of Newton's towards unit length
}

// How a state moves with the linkage and with the datum: the coupler turns so that the loop stays closed.
struct TimedState {
  LoopGradient loop;
  TimedNumbers coupler_row;  ///< of the coupler's angle

  TimedState(const CouplerLinkage& l, const LoopState& at) : loop(l, at) {
    const Point g = loop.g;
    const TimedNumbers closure = {g.real(),     g.imag(), -g.real(), -g.imag(), dot(g, at.e),
                                  dot(g, at.u), -l.b,     0,         0,         loop.f_e};
    for (std::size_t i = 0; i < timed_dimensions; ++i) coupler_row[i] = -closure[i] / loop.f_u;
  }
};

std::array<Point, timed_dimensions> point_rows_of(const CouplerLinkage& l, const LoopState& at,
                                                  const TimedState& state) {
  std::array<Point, timed_dimensions> rows = {Point{1, 0},
                                              Point{0, 1},
                                              Point{},
                                              Point{},
                                              at.e,
                                              Point{},
                                              Point{},
                                              at.u,
                                              quarter_turn(at.u),
                                              l.a * quarter_turn(at.e)};
  const Point by_u = quarter_turn(product(l.p, at.u));
  for (std::size_t i = 0; i < timed_dimensions; ++i) rows[i] += state.coupler_row[i] * by_u;
  return rows;
}

// The square of what the sine of the transmission angle lacks, as branch_hinge() has it for states that slide.
using TimedRow = LeastSquaresRow<timed_dimensions>;
std::optional<TimedRow> timed_branch_hinge(double min_sine, int branch, const CouplerLinkage& l, const LoopState& at,
                                           const TimedState& state) {
  const Point u = at.u, g = state.loop.g;
  const double sine = cross(u, g) / l.b, lacks = min_sine - branch * sine;
  if (lacks <= 0) return std::nullopt;
  const double by_u = (l.h - dot(u, g)) / l.b;
  TimedRow hinge{{-u.imag(), u.real(), u.imag(), -u.real(), cross(u, at.e), 0, -sine, 0, 0, l.a * dot(u, at.e)},
                 branch_weight * lacks};
  for (std::size_t i = 0; i < timed_dimensions; ++i)
    hinge.row[i] = -branch_weight * branch * (hinge.row[i] / l.b + by_u * state.coupler_row[i]);
  return hinge;
}

class TimedStep {
 public:
  TimedStep(const TimedTask& task, const TimedStart& start) : task_(task), start_(start) {
    for (std::size_t j = 0; j < start.states.size(); ++j) add_point(j);
    std::vector<FitRow> hinges;
    append_linkage_hinges(task.limits, start.linkage, hinges);
    for (const FitRow& row : hinges) equations_.add(row, 1);
    equations_.hold(start.held);
  }

  [[nodiscard]] bool take(double damping, TimedStart& next) const {
    TimedNumbers by{};
    if (!equations_.damped_step(damping, by)) return false;
    const CouplerLinkage& l = start_.linkage;
    next.linkage = {l.a0 + Point{by[0], by[1]}, l.b0 + Point{by[2], by[3]}, l.a + by[4], l.h + by[5], l.b + by[6],
                    l.p + Point{by[7], by[8]}};
    if (!(next.linkage.a > 0 && next.linkage.h > 0 && next.linkage.b > 0)) return false;
    next.datum = product(start_.datum, direction_of_turn(by[datum_at]));
    if (!place_states(task_, next)) return false;
    evaluate(task_, next);
    return std::isfinite(next.cost());
  }

 private:
  static Point direction_of_turn(double turn) { return {std::cos(turn), std::sin(turn)}; }

  void add_point(std::size_t j) {
    const CouplerLinkage& l = start_.linkage;
    const LoopState& at = start_.states[j];
    const TimedState state(l, at);
    const auto rows = point_rows_of(l, at, state);
    const Point off = traced_point(l, at) - task_.points[j];
    TimedNumbers x, y;
    for (std::size_t i = 0; i < timed_dimensions; ++i) {
      x[i] = rows[i].real();
      y[i] = rows[i].imag();
    }
    equations_.add(TimedRow{x, off.real()}, task_.weights[j]);
    equations_.add(TimedRow{y, off.imag()}, task_.weights[j]);
    if (const auto hinge = timed_branch_hinge(task_.limits.min_sine, start_.branch, l, at, state))
      equations_.add(*hinge, 1);
  }

  const TimedTask& task_;
  const TimedStart& start_;
  TimedEquations equations_;
};

}  // namespace

void TimedStart::take_datum(const TimedTask& task) {
  const Point turn = task.turns.front();
  datum = product(states.front().e, reversed ? turn : std::conj(turn));
}

bool place_states(const TimedTask& task, TimedStart& start) {
  start.states.resize(task.points.size());
  for (std::size_t j = 0; j < task.points.size(); ++j) {
    const Point e = start.input_at(task.turns[j]);
    const auto u = coupler_at(start.linkage, e, start.branch);
    if (!u) return false;
    start.states[j] = {e, *u};
  }
  return true;
}

void evaluate(const TimedTask& task, TimedStart& start) {
  start.squares = start.penalties = 0;
  for (std::size_t j = 0; j < start.states.size(); ++j) {
    const LoopState& at = start.states[j];
    start.squares += task.weights[j] * std::norm(traced_point(start.linkage, at) - task.points[j]);
    const double sine = start.branch * cross(at.u, LoopGradient(start.linkage, at).g) / start.linkage.b;
    if (sine < task.limits.min_sine) start.penalties += std::pow(branch_weight * (task.limits.min_sine - sine), 2);
  }
  std::vector<FitRow> hinges;
  append_linkage_hinges(task.limits, start.linkage, hinges);
  for (const FitRow& row : hinges) start.penalties += row.residual * row.residual;
}

void improve(const TimedTask& task, TimedStart& start, int iterations) {
  improve_by_steps<TimedStep>(task, start, iterations);
}

}  // namespace linkwright
