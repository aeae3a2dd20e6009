// What fits of untimed paths stand on: rows of the least squares and of the hinges, the second dyad, the sides of the
// first. Random linkages, moved by the tree's own motion; derivatives by differences. Prints the number of
// disagreements; exits with 1 when there are any. mutants.py builds it with wrong signs.

#include <cmath>
#include <cstdio>
#include <vector>

#include "approximate/curve_least_squares.hpp"
#include "approximate/dyad_scan.hpp"
#include "approximate/dyad_scan_kernel.hpp"
#include "approximate/fit_hinges.hpp"
#include "approximate/pair_rating.hpp"
#include "linkwright/core/angle.hpp"
#include "traced_cycle.hpp"

namespace linkwright {
namespace {

using testing::RandomFourBars;

CouplerLinkage changed(CouplerLinkage l, std::size_t number, double by) {
  const Point step = number % 2 == 0 ? Point{by, 0} : Point{0, by};
  if (number < 2) l.a0 += step;
  if (number == 2 || number == 3) l.b0 += step;
  if (number == 4) l.a += by;
  if (number == 5) l.h += by;
  if (number == 6) l.b += by;
  if (number > 6) l.p += number == 7 ? Point{by, 0} : Point{0, by};
  return l;
}

// ---- least squares

int wrong_rows(RandomFourBars& draw) {
  const Traced t = drawn(draw, 9);
  constexpr double h = 1e-6;
  int wrong = 0;
  for (std::size_t j = 0; j < t.states.size(); ++j) {
    const LoopGradient loop(t.linkage, t.states[j]);
    if (std::sqrt(loop.square()) < 0.1) continue;
    const Point target = t.points[j] + 1e-3 * direction(draw.uniform(0, two_pi));
    const std::vector<Point> targets = {target};
    const std::vector<double> weights = {1};
    const FitTask task{targets, weights, {}};
    const auto nearest = [&](const CouplerLinkage& linkage) {
      CurveStart at{linkage, {t.states[j]}};
      close_loop(linkage, at.states[0]);
      slide_to_nearest(task, at);
      return at;
    };
    const CurveStart at = nearest(t.linkage);
    const auto rows = distance_rows(t.linkage, at.states[0], target);
    const auto sine = transmission_sine_row(t.linkage, at.states[0], traced_point(t.linkage, at.states[0]));
    for (std::size_t i = 0; i < fit_dimensions; ++i) {
      const CurveStart more = nearest(changed(t.linkage, i, h)), less = nearest(changed(t.linkage, i, -h));
      const double by = (more.squares - less.squares) / (2 * h);
      if (differs(2 * rows[0].residual * rows[0].row[i], by, 1e-4)) ++wrong;
      // Of the sine: the target being where the point is now.
      const std::vector<Point> here = {traced_point(t.linkage, at.states[0])};
      const auto sine_of = [&](const CouplerLinkage& linkage) {
        CurveStart s{linkage, {at.states[0]}};
        close_loop(linkage, s.states[0]);
        slide_to_nearest({here, weights, {}}, s);
        return cross(s.states[0].u, LoopGradient(linkage, s.states[0]).g) / linkage.b;
      };
      const double by_sine = (sine_of(changed(t.linkage, i, h)) - sine_of(changed(t.linkage, i, -h))) / (2 * h);
      if (differs(sine.row[i], by_sine, 1e-3)) ++wrong;
    }
  }
  return wrong;
}

// From near a linkage back to it: quadratic steps do, wrong ones do not.
bool returns(RandomFourBars& draw) {
  const Traced t = drawn(draw, 16);
  const std::vector<double> weights(t.points.size(), 1);
  const FitTask task{t.points, weights, {}};
  CurveStart start{t.linkage, t.states};
  for (std::size_t i = 0; i < fit_dimensions; ++i) start.linkage = changed(start.linkage, i, draw.uniform(-5e-3, 5e-3));
  for (LoopState& state : start.states)
    if (!close_loop(start.linkage, state)) return true;
  evaluate(task, start);
  improve(task, start, 14);
  return start.squares < 1e-18;
}

int wrong_hinges(RandomFourBars& draw) {
  const CouplerLinkage linkage = drawn(draw, 3).linkage;
  FitLimits limits;
  limits.max_length = draw.uniform(0.5, 2);
  limits.min_length = draw.uniform(0.1, 0.5);
  limits.max_link_ratio = draw.uniform(1.5, 6);
  limits.grashof_margin = draw.uniform(-0.5, 0.5);
  limits.min_turn_sine = draw.uniform(0, 0.7);
  limits.ground = Box{-0.5, 0.5, -0.5, 0.5};
  std::vector<FitRow> rows;
  append_linkage_hinges(limits, linkage, rows);
  const LinkLengths l = linkage.lengths();
  std::size_t broken = 0;
  for (const double length : {l.ground, l.input, l.coupler, l.output})
    broken += (length > limits.max_length ? 1u : 0u) + (length < limits.min_length ? 1u : 0u);
  broken += l.longest() > limits.max_link_ratio * l.shortest() ? 1 : 0;
  broken += grashof_excess(l) < limits.grashof_margin ? 1 : 0;
  for (const double apart : {std::abs(l.ground - l.input), l.ground + l.input}) {
    const double cosine = closing_cosine(l, apart), most = std::sqrt(1 - limits.min_turn_sine * limits.min_turn_sine);
    broken += std::abs(cosine) > most ? 1 : 0;
  }
  for (const double place : {linkage.a0.real(), linkage.a0.imag(), linkage.b0.real(), linkage.b0.imag()})
    broken += std::abs(place) > 0.5 ? 1 : 0;
  if (broken != rows.size()) return 1;
  constexpr double h = 1e-7;
  for (std::size_t i = 0; i < 7; ++i) {
    std::vector<FitRow> more, less;
    append_linkage_hinges(limits, changed(linkage, i, h), more);
    append_linkage_hinges(limits, changed(linkage, i, -h), less);
    if (more.size() != rows.size() || less.size() != rows.size()) continue;  // one of them is just broken
    for (std::size_t k = 0; k < rows.size(); ++k)
      if (differs(rows[k].row[i], (more[k].residual - less[k].residual) / (2 * h), 1e-4)) return 1;
  }
  return 0;
}

// A hinge where the branch is left, and its way back.
int wrong_branch(RandomFourBars& draw) {
  const Traced t = drawn(draw, 5);
  const double min_sine = draw.uniform(0.1, 0.9);
  int wrong = 0;
  for (std::size_t j = 0; j < t.states.size(); ++j)
    for (const int branch : {1, -1}) {
      const double sine = cross(t.states[j].u, LoopGradient(t.linkage, t.states[j]).g) / t.linkage.b;
      const auto row = branch_hinge(min_sine, branch, t.linkage, t.states[j], t.points[j]);
      if (row.has_value() != (branch * sine < min_sine)) ++wrong;
      if (!row) continue;
      const FitRow by = transmission_sine_row(t.linkage, t.states[j], t.points[j]);
      if (!(row->residual > 0) || differs(row->residual / branch_weight, min_sine - branch * sine, 1e-9)) ++wrong;
      if (row->row[6] * by.row[6] * branch > 0) ++wrong;
    }
  return wrong;
}

// ---- scan

struct Sides {
  std::uint32_t right = 0;
  double arm = 0;
};
Sides sides_of(const Traced& t) {
  Sides sides{0, std::abs(t.linkage.p)};
  for (std::size_t j = 0; j < t.points.size(); ++j)
    if (cross(t.points[j] - t.linkage.a0, t.states[j].e) < 0) sides.right |= std::uint32_t{1} << j;
  return sides;
}

using DyadNumbers = std::array<double, DyadBlock::numbers>;

// The first dyad of the block.
std::array<DyadNumbers, 2> vectors_of(const DyadBlock& block) {
  std::array<DyadNumbers, 2> vectors;
  for (std::size_t v = 0; v < 2; ++v)
    for (std::size_t i = 0; i < DyadBlock::numbers; ++i) vectors[v][i] = block.vector[v][i][0];
  return vectors;
}

// aᵀ G b, G being the weighted mean of the squared rows of Freudenstein's equation at some states.
double form(const std::vector<LoopState>& states, const std::vector<double>& weights, const DyadNumbers& a,
            const DyadNumbers& b) {
  double sum = 0, all = 0;
  for (std::size_t j = 0; j < states.size(); ++j) {
    const auto [e, u] = states[j];
    const Point turn = std::conj(e) * u;
    const DyadNumbers row = {turn.real(), -turn.imag(), e.real(), e.imag(), u.real(), u.imag(), 1};
    double by_a = 0, by_b = 0;
    for (std::size_t i = 0; i < row.size(); ++i) {
      by_a += row[i] * a[i];
      by_b += row[i] * b[i];
    }
    sum += weights[j] * by_a * by_b;
    all += weights[j];
  }
  return sum / all;
}

// How far the numbers of a second dyad lie from the span of two vectors, their constants left out: a share.
double off_span(const CouplerLinkage& dyad, const std::array<DyadNumbers, 2>& vectors) {
  const Point z = dyad.h * std::conj(dyad.p) / std::abs(dyad.p), c = dyad.b0 - dyad.a0, w = -c * std::conj(z);
  std::array<double, 6> left = {dyad.a * z.real(),  dyad.a * z.imag(), -dyad.a * c.real(),
                                -dyad.a * c.imag(), w.real(),          w.imag()};
  const auto inner = [](const auto& a, const auto& b) {
    double sum = 0;
    for (std::size_t i = 0; i < 6; ++i) sum += a[i] * b[i];
    return sum;
  };
  const double whole = inner(left, left);
  const DyadNumbers& v = vectors[0];
  DyadNumbers across = vectors[1];
  const double share = inner(across, v) / inner(v, v);
  for (std::size_t i = 0; i < 6; ++i) across[i] -= share * v[i];
  for (const DyadNumbers& unit : {v, across}) {
    const double along = inner(left, unit) / inner(unit, unit);
    for (std::size_t i = 0; i < 6; ++i) left[i] -= along * unit[i];
  }
  return std::sqrt(inner(left, left) / whole);
}

// Of points that no linkage passes: orthogonal unit vectors, to which the values belong; combinations that are dyads.
int wrong_vectors(RandomFourBars& draw) {
  DyadBlock block{};
  block.count = 1;
  block.points = 12;
  block.input[0] = draw.uniform(0.3, 1);
  block.arm[0] = draw.uniform(0.3, 1);
  block.assembly[0] = draw.below(1 << 12);
  std::vector<LoopState> states;
  std::vector<double> weights;
  for (int j = 0; j < block.points; ++j) {
    const double shortest = std::abs(block.input[0] - block.arm[0]), longest = block.input[0] + block.arm[0];
    const Point along = direction(draw.uniform(0, two_pi));
    const double d = block.distance[j] = draw.uniform(shortest, longest);
    block.direction[j][0] = along.real();
    block.direction[j][1] = along.imag();
    weights.push_back(block.weight[j] = draw.uniform(0.1, 2));
    const double a = block.input[0], r = block.arm[0], cosine = (d * d + a * a - r * r) / (2 * d * a);
    const double side = (block.assembly[0] >> j & 1) != 0 ? -1 : 1;
    const Point e = along * Point{cosine, side * std::sqrt(1 - cosine * cosine)}, to_point = d * along - a * e;
    states.push_back({e, to_point / std::abs(to_point)});
  }
  dyad_scan_kernel.for_simd(Simd::scalar)(block);
  const auto [v, w] = vectors_of(block);
  double vv = 0, vw = 0, ww = 0;
  for (std::size_t i = 0; i < v.size(); ++i) {
    vv += v[i] * v[i];
    vw += v[i] * w[i];
    ww += w[i] * w[i];
  }
  int wrong = std::abs(vv - 1) + std::abs(ww - 1) + std::abs(vw) < 1e-9 ? 0 : 1;
  if (std::abs(form(states, weights, v, v) - block.value[0][0]) > 1e-10) ++wrong;
  if (std::abs(form(states, weights, w, w) - block.value[1][0]) > 1e-10) ++wrong;
  if (std::abs(form(states, weights, v, w)) > 1e-10 || block.value[0][0] > block.value[1][0]) ++wrong;
  const SecondDyads seconds = second_dyads({}, block.input[0], block.arm[0], {v, w});
  for (std::size_t k = 1; k < seconds.count; ++k)  // the first is what is nearest without a combination
    if (off_span(seconds.linkages[k], {v, w}) > 1e-6) ++wrong;
  return wrong;
}

int wrong_second_dyads(RandomFourBars& draw) {
  const Traced t = drawn(draw, DyadBlock::most_points);
  const Sides sides = sides_of(t);
  const Point pivot = t.linkage.a0;
  DyadBlock block{};
  block.count = 1;
  block.points = DyadBlock::most_points;
  for (int j = 0; j < block.points; ++j) {
    const Point to = t.points[static_cast<std::size_t>(j)] - pivot;
    block.distance[j] = std::abs(to);
    block.direction[j][0] = to.real() / std::abs(to);
    block.direction[j][1] = to.imag() / std::abs(to);
    block.weight[j] = 1 + 0.5 * (j % 3);
  }
  block.input[0] = t.linkage.a;
  block.arm[0] = sides.arm;
  block.assembly[0] = sides.right;
  dyad_scan_kernel.for_simd(Simd::scalar)(block);
  double nearest = 1e9;
  const SecondDyads seconds = second_dyads(pivot, t.linkage.a, sides.arm, vectors_of(block));
  for (std::size_t k = 0; k < seconds.count; ++k) {
    const CouplerLinkage& found = seconds.linkages[k];
    nearest = std::min(
        nearest, std::abs(found.b0 - t.linkage.b0) + std::abs(found.p - t.linkage.p) + std::abs(found.h - t.linkage.h));
  }
  int wrong = nearest < 1e-3 ? 0 : 1;

  std::vector<LoopState> driven;
  const std::vector<double> weights(t.points.size(), 1);
  for (const LoopState& at : t.states) driven.push_back({at.e, at.u * t.linkage.p / sides.arm});
  const auto at_pivot = second_dyad_at(t.linkage.b0 - pivot, t.linkage.a, sides.arm, driven, weights);
  if (!at_pivot || std::abs(at_pivot->h - t.linkage.h) + std::abs(at_pivot->p - t.linkage.p) > 1e-6) ++wrong;

  // Rated: no gap, the length of the output, and the states it stands for.
  PairRating rating(t.points, weights, pivot, true);
  rating.drive(t.linkage.a, sides.arm, sides.right);
  ScannedPair pair{t.linkage, sides.right};
  pair.linkage.b = 0;
  rating.score(pair);
  if (!(pair.score < 1e-6) || differs(pair.linkage.b, t.linkage.b, 1e-6)) ++wrong;
  const bool crank = input_is_crank(linkage_type(t.bars.lengths()));
  if (crank && rating.driver(pair.linkage) != 'e') ++wrong;
  if (!crank && rating.driver(pair.linkage, "e") == 'e') ++wrong;
  for (std::size_t j = 0; j < t.states.size(); ++j)
    if (std::abs(states_of(pair, t.points)[j].u - t.states[j].u) > 1e-6) ++wrong;
  return wrong > 0 ? 1 : 0;
}

// The sides and the lengths of a crank-rocker's first dyad are among those that are tried.
bool is_tried(RandomFourBars& draw) {
  const Traced t = drawn(draw, DyadBlock::most_points, true);
  const Sides sides = sides_of(t);
  CurveTarget target;
  target.closed = true;
  for (const MotionState& at : motion_cycle(t.bars, traced_point(t.linkage, state_of(t.bars)), 721))
    target.points.push_back(at.coupler_point);
  target.points.pop_back();
  ScaledTarget scaled;
  scaled.closed = true;
  scaled.points = target.points;
  const std::uint32_t all = (std::uint32_t{1} << DyadBlock::most_points) - 1;
  for (const DrivingDyad& dyad : driving_dyads(scaled, t.points, t.linkage.a0)) {
    const auto is_it = [&](double input, double arm, std::uint32_t right) {
      return std::abs(input - t.linkage.a) + std::abs(arm - sides.arm) < 0.02 * (t.linkage.a + sides.arm) &&
             ((right ^ sides.right) & all) == 0;
    };
    if (is_it(dyad.input, dyad.arm, dyad.right) || is_it(dyad.arm, dyad.input, ~dyad.right)) return true;
  }
  return false;
}

}  // namespace
}  // namespace linkwright

int main() {
  using namespace linkwright;
  RandomFourBars draw(17);
  int rows = 0, back = 0, hinges = 0, branches = 0, dyads = 0, tried = 0;
  constexpr int trials = 40;
  for (int k = 0; k < trials; ++k) {
    rows += wrong_rows(draw);
    back += returns(draw) ? 1 : 0;
    hinges += wrong_hinges(draw);
    branches += wrong_branch(draw);
    dyads += wrong_second_dyads(draw) + wrong_vectors(draw);
    tried += is_tried(draw) ? 1 : 0;
  }
  std::printf("rows %d, not back %d, hinges %d, branches %d, dyads %d, not tried %d\n", rows, trials - back, hinges,
              branches, dyads, trials - tried);
  return rows + hinges + branches + (dyads > 2) + (back < trials - 4) + (tried < trials - 4) > 0 ? 1 : 0;
}
