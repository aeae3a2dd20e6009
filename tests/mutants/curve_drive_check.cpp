// What is told of untimed paths: what driving along a circuit shows, the linkages that trace a curve, errors and turns.
// Random linkages against the tree's own motion. Prints the number of disagreements; exits with 1 when there are any.
// mutants.py builds it with wrong signs.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "approximate/coupler_circuit.hpp"
#include "approximate/drive_verdict.hpp"
#include "approximate/fit_result.hpp"
#include "linkwright/core/angle.hpp"
#include "traced_cycle.hpp"

namespace linkwright {
namespace {

using testing::RandomFourBars;

// ---- driving

int wrong_drives(RandomFourBars& draw) {
  Traced t = drawn(draw, 40);
  int wrong = 0;
  const CircuitDrive drive = drive_along_circuit(t.linkage, t.states, t.points, true, 1e-9);
  const LinkageType type = linkage_type(t.bars.lengths());
  if (!drive.one_circuit || !drive.in_order) ++wrong;
  if (drive.of(CurveDriver::e).full_turn != input_is_crank(type)) ++wrong;
  if (drive.of(CurveDriver::g).full_turn != input_is_crank(swapped(type))) ++wrong;
  const auto stands = [&](CurveDriver driver, bool turns) {
    if (drive.of(driver).no_dead_point != turns) ++wrong;
  };
  stands(CurveDriver::e, input_is_crank(type));
  stands(CurveDriver::g, input_is_crank(swapped(type)));
  const CurveDrive told = verdict(drive, CurveDriver::e, CurveDriver::g);
  if (told.input_drives != input_is_crank(type) || told.full_turn != input_is_crank(type)) ++wrong;
  if (told.output_drives != input_is_crank(swapped(type))) ++wrong;
  std::swap(t.states[3], t.states[7]);
  std::swap(t.points[3], t.points[7]);
  if (drive_along_circuit(t.linkage, t.states, t.points, true, 1e-9).in_order) ++wrong;
  std::swap(t.states[3], t.states[7]);
  std::swap(t.points[3], t.points[7]);
  if (is_grashof(type)) {
    const Point ground = (t.linkage.b0 - t.linkage.a0) / std::abs(t.linkage.b0 - t.linkage.a0);
    t.states[5] = {ground * ground * std::conj(t.states[5].e), ground * ground * std::conj(t.states[5].u)};
    if (drive_along_circuit(t.linkage, t.states, t.points, true, 1e-9).one_circuit) ++wrong;
  }
  return wrong;
}

double to_segment(Point p, Point from, Point to) {
  const Point along = to - from;
  const double share = std::clamp(dot(p - from, along) / std::norm(along), 0.0, 1.0);
  return std::abs(p - from - share * along);
}

// Turns, excursion and length between sparse states, by the tree's own motion in 7200 steps.
int wrong_ways(RandomFourBars& draw) {
  const Traced fine = drawn(draw, 7200, true);
  std::vector<LoopState> states;
  std::vector<Point> points;
  const std::vector<std::size_t> at = {0, 900, 2300, 4000, 6000};
  for (const std::size_t k : at) {
    states.push_back(fine.states[k]);
    points.push_back(fine.points[k]);
  }
  const CircuitDrive drive = drive_along_circuit(fine.linkage, states, points, true, 0);
  const std::vector<double> turns = input_turns(states, drive.of(CurveDriver::e).turns);
  int wrong = drive.in_order ? 0 : 1;
  double excursion = 0, length = 0, polygon = 0;
  for (std::size_t s = 0; s < at.size(); ++s) {
    const std::size_t from = at[s], to = s + 1 < at.size() ? at[s + 1] : fine.points.size();
    polygon += std::abs(points[(s + 1) % at.size()] - points[s]);
    const double turn = two_pi * static_cast<double>(from) / 7200;
    const double sense = turns[1] > 0 ? 1 : -1;
    if (differs(turns[s], sense * turn, 1e-6)) ++wrong;
    for (std::size_t k = from; k < to; ++k) {
      length += std::abs(fine.points[(k + 1) % fine.points.size()] - fine.points[k]);
      double off = 1e9;
      for (const std::size_t side : {s + at.size() - 1, s, s + 1}) {
        const Point a = points[side % at.size()], b = points[(side + 1) % at.size()];
        off = std::min(off, to_segment(fine.points[k], a, b));
      }
      excursion = std::max(excursion, off);
    }
  }
  if (differs(drive.excursion, excursion, 1e-3)) ++wrong;
  if (differs(drive.path_length_ratio, length / polygon, 1e-3)) ++wrong;
  return wrong;
}

// ---- what is told

// The first realisation is a crank without defects, whichever of the four-bars was fitted.
int wrong_first(const CurveFit& fit, const CurveTarget& target, const CurveFitOptions& options) {
  int wrong = 0;
  for (std::size_t k = 0; k < fit.realisation_count; ++k) {
    TracingFourBar other = fit.realisations[k];
    for (const bool turned_round : {false, true}) {
      if (turned_round) other.bars = other.bars.swapped();
      const auto compared = compare_with_curve(other, target);
      if (!compared) return 1;
      std::vector<LoopState> states;
      for (const FitState& state : compared->states) states.push_back(state_of(state.bars));
      const CurveFit again = curve_fit_of(coupler_linkage(other), states, target, options, FirstRealisation::best);
      if (!again.drive.no_defects(true) || !input_is_crank(linkage_type(again.linkage().bars.lengths()))) ++wrong;
    }
  }
  return wrong;
}

// On three pairs of three pivots, each traces the points, and its input turns by what is told.
int wrong_realisations(const CurveFit& fit, const CurveTarget& target) {
  int wrong = 0;
  for (std::size_t k = 0; k < fit.realisation_count; ++k) {
    const TracingFourBar& one = fit.realisations[k];
    const auto path = motion_cycle(one.bars, one.point, 4001);
    const bool crank = input_is_crank(linkage_type(one.bars.lengths()));
    const std::vector<double>& turns = fit.input_turns[k];
    for (std::size_t j = 0; j < target.points.size(); ++j) {
      double least = 1e9;
      for (std::size_t s = 1; s < path.size(); ++s)
        least = std::min(least, to_segment(target.points[j], path[s - 1].coupler_point, path[s].coupler_point));
      if (least > 1e-3) ++wrong;
      if (j > 0 && std::abs(turns[j] - turns[j - 1]) > pi) ++wrong;
      if (!crank || j == 0) continue;
      const auto way = motion_sweep(one.bars, one.point, turns[j], 2 + static_cast<int>(100 * std::abs(turns[j])));
      if (std::abs(way.back().coupler_point - target.points[j]) > 1e-6) ++wrong;
    }
    for (std::size_t i = 0; i < k; ++i) {
      const FourBar& a = one.bars;
      const FourBar& b = fit.realisations[i].bars;
      const auto same = [](Point p, Point q) { return std::abs(p - q) < 1e-6; };
      const int shared = same(a.input_fixed, b.input_fixed) + same(a.input_fixed, b.output_fixed) +
                         same(a.output_fixed, b.input_fixed) + same(a.output_fixed, b.output_fixed);
      if (shared != 1) ++wrong;
    }
  }
  return wrong;
}

int wrong_results(RandomFourBars& draw) {
  const Traced t = drawn(draw, 18, true);
  CurveTarget target{t.points, {}, true};
  for (std::size_t j = 0; j < target.points.size(); ++j) target.weights.push_back(1.0 + static_cast<double>(j % 4));
  CurveFitOptions options;
  options.max_length = 100;
  const CurveFit fit = curve_fit_of(t.linkage, t.states, target, options, FirstRealisation::best);
  int wrong = fit.realisation_count == 3 && fit.drive.no_defects(true) ? 0 : 1;
  wrong += wrong_first(fit, target, options) + wrong_realisations(fit, target);
  for (const FitState& state : fit.states)
    if (state.distance > 1e-9) ++wrong;
  // A shifted target: all distances the same.
  const Point shift{0.03, -0.04};
  for (Point& p : target.points) p += shift;
  const CurveError error = curve_fit_of(t.linkage, t.states, target, options, FirstRealisation::as_given).error;
  if (differs(error.rms, 0.05, 1e-9) || differs(error.max, 0.05, 1e-9)) ++wrong;
  if (differs(error.rms_over_diagonal, 0.05 / target.diagonal(), 1e-9)) ++wrong;
  return wrong > 0 ? 1 : 0;
}

}  // namespace
}  // namespace linkwright

int main() {
  using namespace linkwright;
  RandomFourBars draw(17);
  int drives = 0, ways = 0, results = 0;
  for (int k = 0; k < 40; ++k) {
    drives += wrong_drives(draw);
    ways += wrong_ways(draw);
    results += wrong_results(draw);
  }
  std::printf("drives %d, ways %d, results %d\n", drives, ways, results);
  return drives + ways + results > 0 ? 1 : 0;
}
