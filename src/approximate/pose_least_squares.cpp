#include "approximate/pose_least_squares.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "approximate/fit_hinges.hpp"

namespace linkwright {
namespace {

using BodyEquations = NormalEquations<body_dimensions>;
using BodyNumbers = BodyEquations::Numbers;

// Of the two conditions, by the numbers of their own dyads at the same pose.
using DyadNumbers = std::array<double, 5>;
constexpr std::array<std::size_t, 5> numbers_of_a = {0, 1, 4, 6, 7}, numbers_of_b = {2, 3, 5, 8, 9};

DyadNumbers by_own_numbers(Point unit, Point axis) {
  const Point in_body = product(std::conj(axis), unit);
  return {-unit.real(), -unit.imag(), -0.5 * (1 + std::norm(unit)), in_body.real(), in_body.imag()};
}

// What a state does while the linkage changes: it closes across its curve, and slides along it to the nearest.
struct BodySlide {
  BodyHold hold;
  BodyMove off;    // from the pose asked for to the state
  BodyMove along;  // unit vector
  DyadNumbers by_a, by_b;
  std::array<double, 2> closing;  // components across the curve
  double slide;

  BodySlide(const BodyLinkage& linkage, const BodyPose& at, const BodyPose& pose, double turning_length)
      : hold(linkage, at, turning_length),
        off(move_between(pose, at, turning_length)),
        along(cross(hold.first, hold.second)),
        by_a(by_own_numbers(hold.va, at.axis)),
        by_b(by_own_numbers(hold.vb, at.axis)),
        closing(hold.closing(hold.fa, hold.fb)),
        slide(-dot(along, off)) {}

  [[nodiscard]] std::array<double, 2> residuals() const {
    return {dot(hold.first, off) + closing[0], dot(hold.second, off) + closing[1]};
  }

  [[nodiscard]] std::array<BodyRow, 2> rows() const {
    std::array<BodyRow, 2> rows;
    for (std::size_t i = 0; i < by_a.size(); ++i) {
      const auto of_a = hold.closing(by_a[i], 0), of_b = hold.closing(0, by_b[i]);
      for (std::size_t k = 0; k < 2; ++k) {
        rows[k].row[numbers_of_a[i]] = of_a[k];
        rows[k].row[numbers_of_b[i]] = of_b[k];
      }
    }
    for (std::size_t k = 0; k < 2; ++k) rows[k].residual = residuals()[k];
    return rows;
  }

  [[nodiscard]] BodyPose after(const BodyPose& at, const BodyNumbers& step, double turning_length) const {
    constexpr double longest = 0.5;  // radians: beyond it linear means little
    double a = hold.fa, b = hold.fb;
    for (std::size_t i = 0; i < by_a.size(); ++i) {
      a += by_a[i] * step[numbers_of_a[i]];
      b += by_b[i] * step[numbers_of_b[i]];
    }
    const auto [one, other] = hold.closing(a, b);
    BodyMove by = one * hold.first + other * hold.second + slide * along;
    const double most = longest * turning_length, turn = std::abs(by.turn);
    if (turn > most) by = (most / turn) * by;
    return moved(at, by, turning_length);
  }
};

// The squares of a state's two rows: −first·(1/g) of dyad a, and of both dyads, each a half of them zeros.
void add_squares(const BodySlide& slide, double weight, BodyEquations& equations) {
  const BodyHold& hold = slide.hold;
  const double one = 1 / hold.first_length, two = 1 / hold.second_length, mixed = hold.share * two;
  const auto residual = slide.residuals();
  const double ga = weight * (mixed * residual[1] - one * residual[0]), gb = -weight * two * residual[1];
  const double aa = weight * (one * one + mixed * mixed), ab = -weight * mixed * two, bb = weight * two * two;
  for (std::size_t i = 0; i < slide.by_a.size(); ++i) {
    const double a = slide.by_a[i], b = slide.by_b[i];
    const std::size_t at_a = numbers_of_a[i], at_b = numbers_of_b[i];
    equations.g[at_a] += ga * a;
    equations.g[at_b] += gb * b;
    for (std::size_t j = 0; j <= i; ++j) {
      equations.h[at_a][numbers_of_a[j]] += aa * a * slide.by_a[j];
      equations.h[at_b][numbers_of_b[j]] += bb * b * slide.by_b[j];
    }
    for (std::size_t j = 0; j < slide.by_b.size(); ++j)
      equations.h[std::max(at_a, numbers_of_b[j])][std::min(at_a, numbers_of_b[j])] += ab * a * slide.by_b[j];
  }
}

// From the numbers of the coupler curve to those of the body.
BodyRow of_body(const FitRow& row, const BodyLinkage& linkage) {
  const Point along = linkage.zb - linkage.za, unit = along / std::abs(along);
  const double by_h = row.row[5];
  return {{row.row[0], row.row[1], row.row[2], row.row[3], row.row[4], row.row[6], -by_h * unit.real(),
           -by_h * unit.imag(), by_h * unit.real(), by_h * unit.imag()},
          row.residual};
}

std::optional<BodyRow> branch_row(const PoseFitTask& task, int branch, const BodyLinkage& linkage, const BodyPose& at,
                                  const BodyPose& pose) {
  if (branch * transmission_sine(linkage, at) >= task.limits.min_sine) return std::nullopt;
  BodyRow row = transmission_sine_row(linkage, at, pose, task.turning_length);
  for (double& entry : row.row) entry *= -branch_weight * branch;
  row.residual = branch_weight * (task.limits.min_sine - branch * row.residual);
  return row;
}

class BodyStep {
 public:
  BodyStep(const PoseFitTask& task, const BodyStart& start) : task_(task), start_(start) {
    slides_.reserve(start.states.size());
    for (std::size_t j = 0; j < start.states.size(); ++j) {
      const BodySlide& slide = slides_.emplace_back(start.linkage, start.states[j], task.poses[j], task.turning_length);
      add_squares(slide, task.weights[j], equations_);
      if (start.branch == 0) continue;
      const auto row = branch_row(task, start.branch, start.linkage, start.states[j], task.poses[j]);
      if (row) equations_.add(*row, 1);
    }
    std::vector<FitRow> hinges;
    append_linkage_hinges(task.limits, coupler_linkage(start.linkage), hinges);
    for (const FitRow& row : hinges) equations_.add(of_body(row, start.linkage), 1);
    equations_.hold(start.held);
  }

  /// The start after a damped step; false where there is none, or a loop does not close.
  [[nodiscard]] bool take(double damping, BodyStart& next) const {
    BodyNumbers step{};
    if (!equations_.damped_step(damping, step)) return false;
    const BodyLinkage& l = start_.linkage;
    next.linkage = {l.a0 + Point{step[0], step[1]}, l.b0 + Point{step[2], step[3]}, l.a + step[4], l.b + step[5],
                    l.za + Point{step[6], step[7]}, l.zb + Point{step[8], step[9]}};
    if (!(next.linkage.a > 0 && next.linkage.b > 0 && next.linkage.za != next.linkage.zb)) return false;
    const BodyClosing closing(next.linkage, task_.turning_length);
    for (std::size_t j = 0; j < slides_.size(); ++j) {
      next.states[j] = slides_[j].after(start_.states[j], step, task_.turning_length);
      if (!closing.close(next.states[j])) return false;
    }
    evaluate(task_, next);
    return std::isfinite(next.cost());
  }

 private:
  const PoseFitTask& task_;
  const BodyStart& start_;
  std::vector<BodySlide> slides_;
  BodyEquations equations_;
};

}  // namespace

std::array<BodyRow, 2> displacement_rows(const BodyLinkage& linkage, const BodyPose& at, const BodyPose& pose,
                                         double turning_length) {
  return BodySlide(linkage, at, pose, turning_length).rows();
}

BodyRow transmission_sine_row(const BodyLinkage& linkage, const BodyPose& at, const BodyPose& pose,
                              double turning_length) {
  const BodySlide slide(linkage, at, pose, turning_length);
  const Point rb = product(linkage.zb, at.axis), along = product(linkage.zb - linkage.za, at.axis);
  const double h = std::abs(along);
  const Point u = along / h, g = slide.hold.vb, across = quarter_turn(u);
  const double sine = cross(u, g);
  // By a displacement of the body; then by the numbers at the same pose.
  const BodyMove by_move{across / linkage.b, (dot(across, quarter_turn(rb)) / linkage.b - dot(u, g)) / turning_length};
  const double by_first = dot(by_move, slide.hold.first), by_second = dot(by_move, slide.hold.second);
  // δu is across what zb − za changes by, over h; the moving pivot of the output goes with zb.
  const Point by_turn = cross(across, g) / h * product(std::conj(at.axis), across);
  const Point by_pivot = product(std::conj(at.axis), across) / linkage.b;
  BodyRow row;
  row.row = {0,
             0,
             -across.real() / linkage.b,
             -across.imag() / linkage.b,
             0,
             -sine / linkage.b,
             -by_turn.real(),
             -by_turn.imag(),
             by_turn.real() + by_pivot.real(),
             by_turn.imag() + by_pivot.imag()};
  row.residual =
      sine + dot(by_move, slide.along) * slide.slide + by_first * slide.closing[0] + by_second * slide.closing[1];
  const auto rows = slide.rows();
  for (std::size_t i = 0; i < body_dimensions; ++i)
    row.row[i] += by_first * rows[0].row[i] + by_second * rows[1].row[i];
  return row;
}

void evaluate(const PoseFitTask& task, BodyStart& start) {
  start.squares = start.penalties = 0;
  for (std::size_t j = 0; j < start.states.size(); ++j) {
    start.squares += task.weights[j] * square(move_between(task.poses[j], start.states[j], task.turning_length));
    if (start.branch == 0) continue;
    const auto row = branch_row(task, start.branch, start.linkage, start.states[j], task.poses[j]);
    if (row) start.penalties += row->residual * row->residual;
  }
  std::vector<FitRow> hinges;
  append_linkage_hinges(task.limits, coupler_linkage(start.linkage), hinges);
  for (const FitRow& row : hinges) start.penalties += row.residual * row.residual;
}

void improve(const PoseFitTask& task, BodyStart& start, int iterations) {
  improve_by_steps<BodyStep>(task, start, iterations);
}

BodyPose nearest_state(const BodyLinkage& linkage, BodyPose state, const BodyPose& pose, double turning_length) {
  constexpr int most_steps = 60;
  constexpr double there = 1e-15, longest = 0.2;  // of the turning length
  const BodyClosing closing(linkage, turning_length);
  if (!closing.close(state)) return state;
  double apart = square(move_between(pose, state, turning_length));
  for (int step = 0; step < most_steps; ++step) {
    const BodySlide slide(linkage, state, pose, turning_length);
    const double by = std::clamp(slide.slide, -longest * turning_length, longest * turning_length);
    BodyPose next = moved(state, by * slide.along, turning_length);
    if (!closing.close(next)) break;
    const double now = square(move_between(pose, next, turning_length));
    if (!(now < apart)) break;
    state = next;
    apart = now;
    if (std::abs(by) < there * turning_length) break;
  }
  return state;
}

void slide_to_nearest(const PoseFitTask& task, BodyStart& start) {
  for (std::size_t j = 0; j < start.states.size(); ++j)
    start.states[j] = nearest_state(start.linkage, start.states[j], task.poses[j], task.turning_length);
  evaluate(task, start);
}

void turn_round(BodyStart& start) {
  start.linkage = swapped(start.linkage);
  if (start.branch != 0) {
    double sum = 0;
    for (const BodyPose& state : start.states) sum += transmission_sine(start.linkage, state) > 0 ? 1 : -1;
    start.branch = sum >= 0 ? 1 : -1;
  }
}

}  // namespace linkwright
