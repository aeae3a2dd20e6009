#include "mechanism/spherical_travel.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/spherical/spherical_solution.hpp"
#include "support/file_support.hpp"

namespace linkwright::spherical_travel_test {
namespace {

struct Driven {
  SphericalSolution found;
  Travel travel;
};

/// Of the map of the folding wing the linkages of some rows.
std::vector<Driven> driven_linkages() {
  const auto task = std::get<SphericalMotionTask>(testing::example("folding_wing.json", 24).task);
  const SphericalTaskFamily given = task_family(task);
  const std::vector<double> places = given.family->samples(Side::input, 24, Spacing::coordinate);
  std::vector<Driven> all;
  for (const double input : places)
    for (const double output : places) {
      constexpr bool respect_direction = true, verify = false;
      if (auto found = make_spherical_four_bar(given, {input, output}, respect_direction, verify))
        all.push_back({*found, travel_of(analyze(found->four_bar, task.orientations), task.orientations.size())});
    }
  return all;
}

const std::vector<Driven>& linkages() {
  static const std::vector<Driven> all = driven_linkages();
  return all;
}

TEST(SphericalTravel, GoesInTheSenseInWhichThePositionsCome) {
  int clockwise = 0, clean = 0;
  for (const auto& [found, travel] : linkages()) {
    for (std::size_t row = 1; row < travel.states.size(); ++row)
      ASSERT_LE(travel.states[row - 1].turn, travel.states[row].turn);
    ASSERT_GE(travel.state_of_position.front(), 0);
    EXPECT_NEAR(travel.states[static_cast<std::size_t>(travel.state_of_position.front())].turn, 0, 1e-7);
    if (found.report.sense == DriveSense::none) continue;
    ++clean;
    clockwise += found.report.sense == DriveSense::cw;
    ASSERT_TRUE(travel.reaches_all_positions());
    EXPECT_TRUE(std::is_sorted(travel.state_of_position.begin(), travel.state_of_position.end()));
  }
  EXPECT_GT(clean, 20);
  EXPECT_GT(clockwise, 5);
}

TEST(SphericalTravel, TurnsTheOutputWithoutJumpsFromPositionOne) {
  for (const auto& [found, travel] : linkages()) {
    EXPECT_NEAR(travel.states[static_cast<std::size_t>(travel.state_of_position.front())].output_turn, 0, 1e-14);
    for (std::size_t row = 1; row < travel.states.size(); ++row)
      ASSERT_LT(std::abs(travel.states[row].output_turn - travel.states[row - 1].output_turn), pi);
  }
}

TEST(SphericalTravel, CarriesTheAxesAtTheirAnglesAndTheCouplerByItsTurn) {
  for (const auto& [found, travel] : linkages())
    for (std::size_t row = 0; row < travel.states.size(); row += 40) {
      const TravelState& state = travel.states[row];
      EXPECT_NEAR(dot(state.hinges[1], state.hinges[2]), std::cos(found.angles.coupler), 1e-9);
      EXPECT_NEAR(dot(state.hinges[0], state.hinges[1]), std::cos(found.angles.input), 1e-9);
      EXPECT_NEAR(norm(state.attitude.apply(found.four_bar.input_moving) - state.hinges[1]), 0, 1e-9);
    }
}

TEST(SphericalTravel, ClosesATurnAndPutsThePositionsInItsMiddle) {
  int cranks = 0;
  for (const auto& [found, travel] : linkages()) {
    if (!travel.full_turn) continue;
    ++cranks;
    EXPECT_NEAR(travel.states.back().turn - travel.states.front().turn, two_pi, 1e-8);
    EXPECT_LT(travel.states.front().turn, 1e-11);
    EXPECT_TRUE(travel.dead_points.empty());
  }
  EXPECT_GT(cranks, 5);
}

TEST(SphericalTravel, EndsAtDeadPointsWhereTheInputCannotGoRound) {
  for (const auto& [found, travel] : linkages()) {
    if (travel.full_turn) continue;
    EXPECT_TRUE(travel.starts_dead && travel.ends_dead);
    for (const double end : {travel.states.front().turn, travel.states.back().turn}) {
      double nearest = two_pi;
      for (const double dead : travel.dead_points) nearest = std::min(nearest, std::abs(dead - end));
      EXPECT_LT(nearest, 1e-7);
    }
  }
}

}  // namespace
}  // namespace linkwright::spherical_travel_test
