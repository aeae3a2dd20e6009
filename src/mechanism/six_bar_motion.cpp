#include "linkwright/mechanism/six_bar_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "linkwright/core/angle.hpp"

namespace linkwright {
namespace {

bool by_turn(const SixBarState& a, const SixBarState& b) { return std::abs(a.turn) < std::abs(b.turn); }

/// A pose may be met a little beyond the end of the step in which it is found.
void sort_by_travel(std::vector<SixBarState>& states) {
  for (std::size_t i = 1; i < states.size(); ++i)
    for (std::size_t k = i; k > 0 && by_turn(states[k], states[k - 1]); --k) std::swap(states[k], states[k - 1]);
}

/// Where a function of one minimum between `low` and `high` is least, by golden sections, to 6e-6 of the interval.
struct Least {
  double at, value;
};
template <class Function>
Least least_of(const Function& function, double low, double high) {
  constexpr double golden = 0.6180339887498949;
  constexpr int sections = 25;
  Least one{high - golden * (high - low), 0}, other{low + golden * (high - low), 0};
  one.value = function(one.at);
  other.value = function(other.at);
  Least least = one.value <= other.value ? one : other;
  for (int section = 0; section < sections; ++section) {
    if (one.value < other.value) {
      high = std::exchange(other, one).at;
      one.at = high - golden * (high - low);
      one.value = function(one.at);
    } else {
      low = std::exchange(one, other).at;
      other.at = low + golden * (high - low);
      other.value = function(other.at);
    }
    for (const Least& tried : {one, other})
      if (tried.value < least.value) least = tried;
  }
  return least;
}

/// The configuration with the driver turned on from another one; nothing where it cannot go there.
std::optional<SixBarTurns> turned_on(const SixBar& six_bar, SixBarTurns turns, double turn) {
  turns[SixBar::driver] *= std::polar(1.0, turn);
  return closed(six_bar, turns);
}

/// The least sine as the driver turns by `low` … `high` radians from a configuration.
double least_sine_near(const SixBar& six_bar, const SixBarTurns& turns, double low, double high) {
  const auto sine_at = [&](double turn) {
    const auto there = turned_on(six_bar, turns, turn);
    return there ? six_bar_transmission(six_bar, *there).sine : 1.0;
  };
  return least_of(sine_at, low, high).value;
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

/// The guided body's hinges in a configuration, and where a pose wants them: the sum of their squared distances.
class NearestState {
 public:
  NearestState(const SixBar& six_bar, const Pose& first, const Pose& wanted)
      : six_bar_(six_bar), first_(first), wanted_(wanted) {
    const std::vector<std::size_t> own = six_bar.joints_of(SixBar::guided);
    guided_ = {own.front(), own.back()};
    for (std::size_t i = 0; i < guided_.size(); ++i)
      targets_[i] = displaced(six_bar.joints[guided_[i]].point, first, wanted);
  }

  [[nodiscard]] double squared(const std::array<Point, SixBar::joint_count>& joints) const {
    return std::norm(joints[guided_[0]] - targets_[0]) + std::norm(joints[guided_[1]] - targets_[1]);
  }

  /// Where the body comes nearest between the states beside `at`.
  [[nodiscard]] std::optional<SixBarMotionState> beside(const std::vector<SixBarMotionState>& states,
                                                        std::size_t at) const {
    const SixBarState& here = states[at].place;
    const SixBarTurns turns = turns_of(six_bar_, here.joints);
    const double before = states[at > 0 ? at - 1 : at].place.turn - here.turn,
                 after = states[std::min(at + 1, states.size() - 1)].place.turn - here.turn;
    const auto squared_at = [&](double turn) {
      const auto there = turned_on(six_bar_, turns, turn);
      return there ? squared(joints_at(six_bar_, *there)) : std::numeric_limits<double>::infinity();
    };
    const double turn = least_of(squared_at, std::min(before, after), std::max(before, after)).at;
    const auto found = turned_on(six_bar_, turns, turn);
    if (!found) return std::nullopt;
    SixBarMotionState state{here, six_bar_transmission(six_bar_, *found).sine};
    state.place.turn += turn;
    state.place.joints = joints_at(six_bar_, *found);
    state.place.body = guided_pose(six_bar_, *found, first_);
    state.place.body.angle = here.body.angle + wrap_signed(state.place.body.angle - here.body.angle);
    state.place.error = body_error(state.place.body, wanted_);
    return state;
  }

 private:
  const SixBar& six_bar_;
  Pose first_, wanted_;
  std::array<std::size_t, 2> guided_{};
  std::array<Point, 2> targets_{};
};

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

double longest_link(const SixBar& six_bar) {
  double longest = 0;
  for (const SixBarLength& length : six_bar.lengths()) longest = std::max(longest, length.length);
  return longest;
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

SixBarMotion with_nearest_states(const SixBar& six_bar, std::span<const PrescribedPose> poses, SixBarMotion motion) {
  constexpr double near = 0.1;  // of the longest link: what is farther off is no position of this motion
  const std::vector<SixBarMotionState> states = motion.states;
  for (std::size_t pose = 0; pose < poses.size() && !states.empty(); ++pose) {
    if (std::any_of(states.begin(), states.end(),
                    [&](const SixBarMotionState& state) { return state.place.pose == static_cast<int>(pose); }))
      continue;
    const NearestState wanted(six_bar, poses.front().pose, poses[pose].pose);
    const auto nearest = std::min_element(states.begin(), states.end(), [&](const auto& a, const auto& b) {
      return wanted.squared(a.place.joints) < wanted.squared(b.place.joints);
    });
    auto state = wanted.beside(states, static_cast<std::size_t>(nearest - states.begin()));
    if (!state || !(std::sqrt(wanted.squared(state->place.joints)) <= near * longest_link(six_bar))) continue;
    state->place.pose = static_cast<int>(pose);
    const bool rises = states.back().place.turn >= states.front().place.turn;
    const auto after = std::find_if(motion.states.begin(), motion.states.end(), [&](const auto& other) {
      return rises ? other.place.turn > state->place.turn : other.place.turn < state->place.turn;
    });
    motion.states.insert(after, *state);
  }
  return motion;
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
