#include "spherical_travel.hpp"

#include <algorithm>
#include <cmath>

#include "linkwright/core/angle.hpp"

namespace linkwright {
namespace {

constexpr double at_the_start = 1e-9;  // radians: rounding of what is position 1

/// A state of the motion, and the input's turn there from position 1, positive in the sense of travel.
struct Passage {
  SphericalState state;
  double turn = 0;
};

/// Positions met, each with its turn, in the order in which they are passed.
using Visits = std::vector<std::pair<double, int>>;

double turn_at(const SphericalAnalysis& analysis, const SphericalState& state, double sense) {
  const double turn = sense * (state.configuration.input_angle - analysis.configuration.input_angle);
  if (!analysis.input_range.is_full_turn()) return turn;
  const double positive = wrap_positive(turn);
  return positive > two_pi - at_the_start ? 0 : positive;
}

Visits visits_in(const SphericalAnalysis& analysis, double sense) {
  Visits visits;
  for (const SphericalState& state : analysis.motion)
    if (const auto met = state.met()) visits.emplace_back(turn_at(analysis, state, sense), *met);
  std::sort(visits.begin(), visits.end());
  return visits;
}

int inversions(const Visits& visits) {
  int count = 0;
  for (std::size_t i = 0; i < visits.size(); ++i)
    for (std::size_t j = i + 1; j < visits.size(); ++j) count += visits[i].second > visits[j].second;
  return count;
}

/// Turns of a crank run from half of what the positions leave before them.
double moved_before(double turn, double before) { return turn > two_pi - before ? turn - two_pi : turn; }

/// By rising turn; a crank's ends where it has begun.
std::vector<Passage> passages_of(const SphericalAnalysis& analysis, double sense, const Visits& visits) {
  const bool full_turn = analysis.input_range.is_full_turn();
  const double before = full_turn ? (two_pi - (visits.empty() ? 0 : visits.back().first)) / 2 : 0;
  std::vector<Passage> passages;
  for (const SphericalState& state : analysis.motion) {
    if (full_turn && &state == &analysis.motion.back() && !state.met()) continue;  // the first once more
    const double turn = turn_at(analysis, state, sense);
    passages.push_back({state, full_turn ? moved_before(turn, before) : turn});
  }
  std::stable_sort(passages.begin(), passages.end(), [](const auto& a, const auto& b) { return a.turn < b.turn; });
  if (full_turn) {
    passages.push_back({passages.front().state, passages.front().turn + two_pi});
    passages.back().state.position.reset();
  }
  return passages;
}

TravelState travel_state(const Passage& passage) {
  const auto& [configuration, bars, turn, transmission_angle, velocity_ratio, position, error] = passage.state;
  TravelState state;
  state.turn = passage.turn;
  state.hinges = {bars.input_fixed, bars.input_moving, bars.output_moving, bars.output_fixed};
  state.attitude = turn.canonical();
  state.transmission_angle = transmission_angle;
  state.velocity_ratio = velocity_ratio.value_or(0);
  state.mechanical_advantage = state.velocity_ratio != 0 ? std::abs(1 / state.velocity_ratio) : 0;
  return state;
}

/// The output's turns from the state `start`, without jumps.
void run_on_without_jumps(Travel& travel, const std::vector<Passage>& passages, std::size_t start) {
  const auto angle = [&](std::size_t row) { return passages[row].state.configuration.output_angle; };
  std::vector<TravelState>& states = travel.states;
  for (std::size_t row = start + 1; row < states.size(); ++row)
    states[row].output_turn = states[row - 1].output_turn + wrap_signed(angle(row) - angle(row - 1));
  for (std::size_t row = start; row-- > 0;)
    states[row].output_turn = states[row + 1].output_turn + wrap_signed(angle(row) - angle(row + 1));
}

/// Turns of dead points, whole turns more or less as near as can be to where the drive runs.
std::vector<double> dead_points_of(const SphericalAnalysis& analysis, double sense, const Travel& travel) {
  const double middle = (travel.states.front().turn + travel.states.back().turn) / 2;
  std::vector<double> turns;
  for (const SphericalDeadPoint& dead : analysis.dead_points) {
    const double turn = sense * (dead.configuration.input_angle - analysis.configuration.input_angle);
    turns.push_back(middle + wrap_signed(turn - middle));
  }
  std::sort(turns.begin(), turns.end());
  return turns;
}

}  // namespace

Travel travel_of(const SphericalAnalysis& analysis, std::size_t positions) {
  Travel travel{hinged_four_bar(true), {}, std::vector<int>(positions, -1), {}, false, false, false};
  if (analysis.motion.empty()) return travel;
  const Visits ccw = visits_in(analysis, 1), cw = visits_in(analysis, -1);
  const bool forward = inversions(ccw) <= inversions(cw);
  const double sense = forward ? 1 : -1;
  const std::vector<Passage> passages = passages_of(analysis, sense, forward ? ccw : cw);
  travel.full_turn = analysis.input_range.is_full_turn();
  travel.starts_dead = travel.ends_dead = !travel.full_turn;
  for (const Passage& passage : passages) {
    if (const auto position = passage.state.met())
      travel.state_of_position[static_cast<std::size_t>(*position) - 1] = static_cast<int>(travel.states.size());
    travel.states.push_back(travel_state(passage));
  }
  run_on_without_jumps(travel, passages, static_cast<std::size_t>(std::max(travel.state_of_position.front(), 0)));
  travel.dead_points = dead_points_of(analysis, sense, travel);
  return travel;
}

}  // namespace linkwright
