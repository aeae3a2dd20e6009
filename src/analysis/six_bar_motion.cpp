#include "linkwright/analysis/six_bar_motion.hpp"

#include <algorithm>
#include <cmath>

namespace linkwright {
namespace {

bool by_turn(const SixBarState& a, const SixBarState& b) { return std::abs(a.turn) < std::abs(b.turn); }

/// A pose may be met a little beyond the end of the step in which it is found.
void sort_by_travel(std::vector<SixBarState>& states) {
  for (std::size_t i = 1; i < states.size(); ++i)
    for (std::size_t k = i; k > 0 && by_turn(states[k], states[k - 1]); --k) std::swap(states[k], states[k - 1]);
}

SixBarMotion rated(const SixBar& six_bar, const std::vector<SixBarState>& states) {
  SixBarMotion motion;
  for (const SixBarState& state : states) {
    const SixBarTransmission transmission = six_bar_transmission(six_bar, turns_of(six_bar, state.joints));
    motion.states.push_back({state, transmission.sine});
    motion.dyadic = transmission.dyadic;
  }
  return motion;
}

bool passes_in_order(const SixBarCheck& check, std::size_t poses) {
  return check.visited.size() + 1 == poses && std::is_sorted(check.visited.begin(), check.visited.end());
}

}  // namespace

double SixBarMotion::min_sine() const {
  double least = states.empty() ? 0 : 1;
  for (const SixBarMotionState& state : states) least = std::min(least, state.sine);
  return least;
}

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
  if (!ccw.stopped) {
    SixBarMotion motion = rated(six_bar, ccw.states);
    motion.full_turn = !motion.states.empty();
    return motion;
  }
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
