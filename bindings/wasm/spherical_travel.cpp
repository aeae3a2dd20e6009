#include "spherical_travel.hpp"

#include <algorithm>
#include <cmath>

#include "linkwright/core/angle.hpp"

namespace linkwright::wasm {
namespace {

constexpr double at_the_start = 1e-9;  // radians: rounding of what is position 1

/// Positions met, each with its turn, in the order in which they are passed.
using Visits = std::vector<std::pair<double, int>>;

double turn_of(const SphericalAnalysis& analysis, const SphericalState& state, double sense) {
  const double turn = sense * (state.configuration.input_angle - analysis.configuration.input_angle);
  if (!analysis.input_range.is_full_turn()) return turn;
  const double positive = wrap_positive(turn);
  return positive > two_pi - at_the_start ? 0 : positive;
}

Visits visits_in(const SphericalAnalysis& analysis, double sense) {
  Visits visits;
  for (const SphericalState& state : analysis.motion)
    if (const auto met = state.met()) visits.emplace_back(turn_of(analysis, state, sense), *met);
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

/// Whole turns more or less, as near as can be to where the drive runs.
double beside(double turn, const std::vector<SphericalPassage>& passages) {
  const double middle = (passages.front().input_turn + passages.back().input_turn) / 2;
  return middle + wrap_signed(turn - middle);
}

void run_on_without_jumps(std::vector<SphericalPassage>& passages, std::size_t start) {
  const auto angle = [&](std::size_t row) { return passages[row].state.configuration.output_angle; };
  for (std::size_t row = start + 1; row < passages.size(); ++row)
    passages[row].output_turn = passages[row - 1].output_turn + wrap_signed(angle(row) - angle(row - 1));
  for (std::size_t row = start; row-- > 0;)
    passages[row].output_turn = passages[row + 1].output_turn + wrap_signed(angle(row) - angle(row + 1));
}

/// The turn ends where it has begun.
void close_turn(std::vector<SphericalPassage>& passages) {
  SphericalPassage last = passages.front();
  last.input_turn += two_pi;
  last.state.position.reset();
  passages.push_back(last);
}

}  // namespace

SphericalTravel spherical_travel(const SphericalAnalysis& analysis, std::size_t positions) {
  SphericalTravel travel;
  travel.row_of_position.assign(positions, -1);
  if (analysis.motion.empty()) return travel;
  const Visits ccw = visits_in(analysis, 1), cw = visits_in(analysis, -1);
  const bool forward = inversions(ccw) <= inversions(cw);
  const double sense = forward ? 1 : -1;
  const Visits& visits = forward ? ccw : cw;
  travel.full_turn = analysis.input_range.is_full_turn();
  const double before = travel.full_turn ? (two_pi - (visits.empty() ? 0 : visits.back().first)) / 2 : 0;

  for (const SphericalState& state : analysis.motion) {
    if (travel.full_turn && &state == &analysis.motion.back() && !state.met()) continue;  // the first once more
    const double turn = turn_of(analysis, state, sense);
    travel.passages.push_back({state, travel.full_turn ? moved_before(turn, before) : turn, 0});
  }
  std::stable_sort(travel.passages.begin(), travel.passages.end(),
                   [](const auto& a, const auto& b) { return a.input_turn < b.input_turn; });
  if (travel.full_turn) close_turn(travel.passages);
  for (std::size_t row = 0; row < travel.passages.size(); ++row)
    if (const auto position = travel.passages[row].state.met())
      travel.row_of_position[static_cast<std::size_t>(*position) - 1] = static_cast<int>(row);
  run_on_without_jumps(travel.passages, static_cast<std::size_t>(std::max(travel.row_of_position.front(), 0)));
  for (const SphericalDeadPoint& dead : analysis.dead_points)
    travel.dead_points.push_back(
        beside(sense * (dead.configuration.input_angle - analysis.configuration.input_angle), travel.passages));
  std::sort(travel.dead_points.begin(), travel.dead_points.end());
  return travel;
}

double least_link_angle(const LinkAngles& angles) {
  double least = pi / 2;
  for (const double arc : angles.all()) least = std::min(least, std::min(arc, pi - arc));
  return least;
}

}  // namespace linkwright::wasm
