#include "linkwright/mechanism/coupler_curve.hpp"

#include <algorithm>
#include <cmath>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/tolerance.hpp"
#include "range_around.hpp"
#include "transmission_angle.hpp"
#include "triangle.hpp"

namespace linkwright {
namespace {

/// Makes states of one four-bar and strings them together.
class CycleRecorder {
 public:
  CycleRecorder(const FourBar& four_bar, Point traced)
      : reference_(four_bar), lengths_(four_bar.lengths()), start_(configuration_of(four_bar)) {
    traced_ = traced - four_bar.input_moving;
  }

  /// Drives the input from `from` to `to` in `samples` states; the first only where it does not repeat the last one.
  void drive(double from, double to, Assembly assembly, int samples) {
    for (int i = states_.empty() ? 0 : 1; i < samples; ++i) {
      const double angle = from + (to - from) * i / (samples - 1);
      if (const auto configuration = assemble(lengths_, angle, assembly)) record(*configuration);
    }
  }

  [[nodiscard]] std::vector<MotionState> take() { return std::move(states_); }

 private:
  void record(Configuration c) {
    continue_angles(c);
    MotionState state{c, placed(reference_, c), {}, transmission_angle(lengths_, c), angle_rates(lengths_, c)};
    state.coupler_point = state.four_bar.input_moving + direction(c.coupler_angle - start_.coupler_angle) * traced_;
    states_.push_back(state);
  }

  /// Whole turns are added so that angles do not jump from state to state.
  void continue_angles(Configuration& c) const {
    const Configuration& before = states_.empty() ? start_ : states_.back().configuration;
    c.coupler_angle = before.coupler_angle + wrap_signed(c.coupler_angle - before.coupler_angle);
    c.output_angle = before.output_angle + wrap_signed(c.output_angle - before.output_angle);
  }

  FourBar reference_;
  LinkLengths lengths_;
  Configuration start_;
  Point traced_;  ///< from the input's moving pivot, as the coupler lies at the start
  std::vector<MotionState> states_;
};

bool can_be_driven(const FourBar& four_bar, Point traced, int samples) {
  return samples >= 2 && is_finite(traced) && are_links(four_bar.lengths());
}

// Beside the parallelogram of crank and arm, triangles similar to the coupler's: on the crank, and on the ground link.
TracingFourBar cognate_on_input(const TracingFourBar& linkage) {
  const auto& [center, pin, other_center, other_pin] = linkage.bars;
  const Point arm = linkage.point - pin, shape = arm / (other_pin - pin);
  return {{center, center + arm, center + shape * (other_center - center), center + arm + shape * (pin - center)},
          linkage.point};
}

}  // namespace

std::vector<MotionState> motion_cycle(const FourBar& four_bar, Point traced, int samples) {
  if (!can_be_driven(four_bar, traced, samples)) return {};
  const std::vector<AngleRange> ranges = input_ranges(four_bar.lengths());
  if (ranges.empty()) return {};
  const double start = configuration_of(four_bar).input_angle;
  const AngleRange range = range_around(ranges, start);
  const Assembly assembly = assembly_of(four_bar);
  CycleRecorder recorder(four_bar, traced);
  if (range.is_full_turn()) {
    recorder.drive(start, start + two_pi, assembly, samples);
  } else {
    recorder.drive(range.from, range.to, assembly, samples);
    recorder.drive(range.to, range.from, opposite(assembly), samples);
  }
  return recorder.take();
}

std::vector<MotionState> motion_sweep(const FourBar& four_bar, Point traced, double sweep, int samples) {
  if (!can_be_driven(four_bar, traced, samples) || !std::isfinite(sweep)) return {};
  const std::vector<AngleRange> ranges = input_ranges(four_bar.lengths());
  if (ranges.empty()) return {};
  const double start = configuration_of(four_bar).input_angle;
  const AngleRange range = range_around(ranges, start);
  double end = start + sweep;
  if (!range.is_full_turn()) end = std::clamp(end, range.from, range.to);
  CycleRecorder recorder(four_bar, traced);
  recorder.drive(start, end, assembly_of(four_bar), samples);
  return recorder.take();
}

std::optional<std::array<TracingFourBar, 2>> cognates(const TracingFourBar& linkage) {
  const FourBar& bars = linkage.bars;
  const double shortest = std::min({bars.lengths().coupler, std::abs(linkage.point - bars.input_moving),
                                    std::abs(linkage.point - bars.output_moving)});
  if (!(shortest > tolerance::vanishing_link * linkage.longest())) return std::nullopt;
  return std::array{cognate_on_input(linkage), cognate_on_input(linkage.swapped())};
}

}  // namespace linkwright
