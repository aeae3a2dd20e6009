#include "linkwright/analysis/six_bar_motion.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace linkwright {
namespace {

bool by_turn(const SixBarState& a, const SixBarState& b) { return std::abs(a.turn) < std::abs(b.turn); }

/// A pose may be met a little beyond the end of the step in which it is found.
void sort_by_travel(std::vector<SixBarState>& states) {
  for (std::size_t i = 1; i < states.size(); ++i)
    for (std::size_t k = i; k > 0 && by_turn(states[k], states[k - 1]); --k) std::swap(states[k], states[k - 1]);
}

/// The least sine as the driver turns by `low` … `high` radians from a configuration; by golden sections, which end
/// where it has one minimum there.
double least_sine_near(const SixBar& six_bar, const SixBarTurns& turns, double low, double high) {
  constexpr double golden = 0.6180339887498949;
  constexpr int sections = 25;  // to 6e-6 of the interval
  const auto sine_at = [&](double turn) {
    SixBarTurns guess = turns;
    guess[SixBar::driver] *= std::polar(1.0, turn);
    const auto there = closed(six_bar, guess);
    return there ? six_bar_transmission(six_bar, *there).sine : 1.0;
  };
  double one = high - golden * (high - low), other = low + golden * (high - low);
  double sine_one = sine_at(one), sine_other = sine_at(other), least = std::min(sine_one, sine_other);
  for (int section = 0; section < sections; ++section) {
    if (sine_one < sine_other) {
      high = std::exchange(other, one);
      one = high - golden * (high - low);
      sine_other = std::exchange(sine_one, sine_at(one));
    } else {
      low = std::exchange(one, other);
      other = low + golden * (high - low);
      sine_one = std::exchange(sine_other, sine_at(other));
    }
    least = std::min({least, sine_one, sine_other});
  }
  return least;
}

/// Between states a degree apart it can be a tenth of a degree less than at any of them.
double least_sine(const SixBar& six_bar, const std::vector<SixBarMotionState>& states, bool full_turn) {
  double least = states.empty() ? 0 : 1;
  for (const SixBarMotionState& state : states) least = std::min(least, state.sine);
  const auto look_near = [&](const SixBarMotionState& here, double one, double other) {
    const auto [low, high] = std::minmax(one, other);
    least = std::min(least, least_sine_near(six_bar, turns_of(six_bar, here.place.joints), low, high));
  };
  for (std::size_t i = 1; i + 1 < states.size(); ++i) {
    const auto &before = states[i - 1], &here = states[i], &after = states[i + 1];
    if (here.sine <= before.sine && here.sine <= after.sine)
      look_near(here, before.place.turn - here.place.turn, after.place.turn - here.place.turn);
  }
  if (full_turn && states.size() > 1)
    look_near(states[0], states[1].place.turn - states[0].place.turn, states[0].place.turn - states[1].place.turn);
  return least;
}

SixBarMotion rated(const SixBar& six_bar, const std::vector<SixBarState>& states, bool full_turn = false) {
  SixBarMotion motion;
  motion.full_turn = full_turn && !states.empty();
  for (const SixBarState& state : states) {
    const SixBarTransmission transmission = six_bar_transmission(six_bar, turns_of(six_bar, state.joints));
    motion.states.push_back({state, transmission.sine});
    motion.dyadic = transmission.dyadic;
  }
  motion.min_sine = least_sine(six_bar, motion.states, motion.full_turn);
  return motion;
}

bool passes_in_order(const SixBarCheck& check, std::size_t poses) {
  return check.visited.size() + 1 == poses && std::is_sorted(check.visited.begin(), check.visited.end());
}

}  // namespace

SixBarTurns turns_of(const SixBar& six_bar, const std::array<Point, SixBar::joint_count>& joints) {
  SixBarTurns turns{};
  turns[0] = 1;
  for (int body = 1; body < SixBar::bodies; ++body) {
    const std::vector<std::size_t> own = six_bar.joints_of(body);
    const Point before = six_bar.joints[own.back()].point - six_bar.joints[own.front()].point;
    const Point turn = (joints[own.back()] - joints[own.front()]) * std::conj(before);
    const double size = std::abs(turn);
    turns[static_cast<std::size_t>(body)] = size > 0 ? turn / size : Point{1, 0};
  }
  return turns;
}

SixBarMotion six_bar_motion(const SixBar& six_bar, std::span<const PrescribedPose> poses, double step) {
  SixBarCheckOptions options;
  options.step = step;
  options.full_travel = true;
  SixBarCheck ccw = check_by_driving(six_bar, poses, +1, options);
  sort_by_travel(ccw.states);
  if (!ccw.stopped) return rated(six_bar, ccw.states, true);
  SixBarCheck cw = check_by_driving(six_bar, poses, -1, options);
  sort_by_travel(cw.states);
  std::vector<SixBarState> states(cw.states.rbegin(), cw.states.rend());
  if (!states.empty()) states.pop_back();  // position 1 again
  states.insert(states.end(), ccw.states.begin(), ccw.states.end());
  return rated(six_bar, states);
}

SixBarMotion travel_through(const SixBar& six_bar, std::span<const PrescribedPose> poses, double step) {
  SixBarCheckOptions options;
  options.step = step;
  std::vector<SixBarState> best;
  for (const int sense : {+1, -1}) {
    SixBarCheck check = check_by_driving(six_bar, poses, sense, options);
    if (!passes_in_order(check, poses.size())) continue;
    sort_by_travel(check.states);
    const int last = static_cast<int>(poses.size()) - 1;
    while (check.states.back().pose != last) check.states.pop_back();
    if (best.empty() || by_turn(check.states.back(), best.back())) best = std::move(check.states);
  }
  return rated(six_bar, best);
}

}  // namespace linkwright
