#include "approximate/timed_scan.hpp"

#include <algorithm>
#include <cmath>

#include "approximate/timed_scan_kernel.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/core/precondition.hpp"

namespace linkwright {
namespace {

constexpr int phases = 24, shapes_in_block = TimedBlock::size / phases;

double radical_inverse(std::size_t k, std::size_t base) {
  double value = 0, digit = 1;
  for (; k > 0; k /= base) value += static_cast<double>(k % base) * (digit /= static_cast<double>(base));
  return value;
}

bool input_turns_fully(const BarRatios& r) {
  return std::abs(r.ground - 1) > std::abs(r.coupler - r.output) && r.ground + 1 < r.coupler + r.output;
}

// Weights of sum 1, points about their weighted mean.
TimedBlock block_for(const TimedTask& task, bool absolute) {
  TimedBlock block{};
  require(task.points.size() <= TimedBlock::most_points, "a scan takes few points");
  block.points = static_cast<int>(task.points.size());
  block.absolute = absolute;
  double weights = 0;
  Point mean{};
  for (std::size_t j = 0; j < task.points.size(); ++j) {
    weights += task.weights[j];
    mean += task.weights[j] * task.points[j];
  }
  mean /= weights;
  for (std::size_t j = 0; j < task.points.size(); ++j) {
    block.weight[j] = task.weights[j] / weights;
    block.turn[j][0] = task.turns[j].real();
    block.turn[j][1] = task.turns[j].imag();
    block.point[j][0] = (task.points[j] - mean).real();
    block.point[j][1] = (task.points[j] - mean).imag();
  }
  return block;
}

double phase_of(int k) { return two_pi * k / phases; }

void lay_shape(const BarRatios& shape, int from, TimedBlock& block) {
  for (int k = 0; k < phases; ++k) {
    block.ground[from + k] = shape.ground;
    block.coupler[from + k] = shape.coupler;
    block.output[from + k] = shape.output;
    block.phase[0][from + k] = std::cos(phase_of(k));
    block.phase[1][from + k] = std::sin(phase_of(k));
  }
}

// Even variants have the coupler to the left of the diagonal from the output's fixed pivot; mirrored ones, turned back,
// to the other side and the phase the other way.
void take_best_phases(const BarRatios& shape, const TimedBlock& block, int from, std::vector<TimedCell>& cells) {
  const int variants = block.absolute ? 2 : TimedBlock::variants;
  for (int variant = 0; variant < variants; ++variant) {
    const double* const squares = block.squares[variant] + from;
    const bool mirrored = variant >= 2;
    for (int k = 0; k < phases; ++k) {
      if (squares[k] >= TimedBlock::unreached) continue;
      if (squares[k] > squares[(k + 1) % phases] || squares[k] >= squares[(k + phases - 1) % phases]) continue;
      const int left = variant % 2 == 0 ? 1 : -1;
      cells.push_back({shape, mirrored ? -phase_of(k) : phase_of(k), mirrored ? left : -left, mirrored, squares[k]});
    }
  }
}

// T = c0 + c1 E + c2 V at its least sum of squares.
struct LinearFit {
  Point origin{}, input{}, arm{};
};
LinearFit linear_fit(const TimedTask& task, bool absolute, Point datum, std::span<const LoopState> states) {
  double weights = 0;
  Point t{}, e{}, v{};
  for (std::size_t j = 0; j < states.size(); ++j) {
    const double w = task.weights[j];
    weights += w;
    t += w * task.points[j];
    e += w * states[j].e;
    v += w * states[j].u;
  }
  t /= weights;
  e /= weights;
  v /= weights;
  double ee = 0, vv = 0;
  Point ev{}, et{}, vt{};
  for (std::size_t j = 0; j < states.size(); ++j) {
    const double w = task.weights[j] / weights;
    const Point a = states[j].e - e, b = states[j].u - v, c = task.points[j] - t;
    ee += w * std::norm(a);
    vv += w * std::norm(b);
    ev += w * std::conj(a) * b;
    et += w * std::conj(a) * c;
    vt += w * std::conj(b) * c;
  }
  constexpr double regular = 1e-12;
  LinearFit fit;
  fit.input = (vv * et - ev * vt) / (ee * vv - std::norm(ev) + regular);
  if (absolute) fit.input = std::max(dot(std::conj(datum), fit.input), 1e-6) * std::conj(datum);
  fit.arm = (vt - std::conj(ev) * fit.input) / (vv + regular);
  fit.origin = t - fit.input * e - fit.arm * v;
  return fit;
}

}  // namespace

BarRatios bar_ratios(std::size_t k) {
  constexpr double widest = 9.5;
  const auto ratio = [&](std::size_t base) { return std::pow(widest, 2 * radical_inverse(k, base) - 1); };
  return {ratio(2), ratio(3), ratio(5)};
}

std::vector<BarRatios> scanned_ratios(std::size_t count, bool full_turn) {
  std::vector<BarRatios> shapes;
  for (std::size_t k = 1; shapes.size() < count; ++k) {
    const BarRatios shape = bar_ratios(k);
    if (!full_turn || input_turns_fully(shape)) shapes.push_back(shape);
  }
  return shapes;
}

std::vector<TimedCell> scan_ratios(const TimedTask& task, bool absolute, std::span<const BarRatios> shapes, Simd simd) {
  TimedBlock block = block_for(task, absolute);
  std::vector<TimedCell> cells;
  for (std::size_t first = 0; first < shapes.size(); first += shapes_in_block) {
    const auto here = static_cast<int>(std::min<std::size_t>(shapes_in_block, shapes.size() - first));
    for (int k = 0; k < here; ++k) lay_shape(shapes[first + static_cast<std::size_t>(k)], k * phases, block);
    block.count = here * phases;
    timed_scan_kernel.for_simd(simd)(block);
    for (int k = 0; k < here; ++k)
      take_best_phases(shapes[first + static_cast<std::size_t>(k)], block, k * phases, cells);
  }
  return cells;
}

std::optional<TimedStart> timed_start(const TimedTask& task, bool absolute, const TimedCell& cell) {
  TimedStart start;
  start.linkage = {{0, 0}, {cell.ratios.ground, 0}, 1, cell.ratios.coupler, cell.ratios.output, {}};
  start.branch = cell.branch;
  start.reversed = cell.reversed;
  start.datum = direction(cell.phase);
  if (!place_states(task, start)) return std::nullopt;
  const LinearFit fit = linear_fit(task, absolute, start.datum, start.states);
  const double scale = std::abs(fit.input);
  if (!(scale > 0) || !std::isfinite(scale)) return std::nullopt;
  const Point turn = fit.input / scale;
  start.linkage = {fit.origin,
                   fit.origin + cell.ratios.ground * fit.input,
                   scale,
                   scale * cell.ratios.coupler,
                   scale * cell.ratios.output,
                   fit.arm / turn};
  start.datum = product(start.datum, turn);
  if (absolute) {
    start.datum = {1, 0};
    start.held |= TimedStart::hold_datum;
  }
  if (!place_states(task, start)) return std::nullopt;
  return start;
}

}  // namespace linkwright
