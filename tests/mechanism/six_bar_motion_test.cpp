#include "linkwright/mechanism/six_bar_motion.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/six_bar_drive.hpp"
#include "linkwright/planar/six_bar_solution.hpp"
#include "support/draws.hpp"
#include "support/random_six_bar.hpp"

namespace linkwright::six_bar_motion_test {
namespace {

constexpr double step = radians(1);

/// Whatever the driver does, 4-3 never locks: a crank of 1 among long links.
SixBar with_crank() {
  return SixBar::of({Point{0, 0}, Point{1, 0}, Point{3, 2}}, {BodyPair{0, 2}, BodyPair{0, 3}},
                    {Point{5, 0}, Point{4, 3}}, {Point{6, -4}, Point{8, 3}});
}

/// Its driver stops both ways.
SixBar with_rocker() {
  return SixBar::of({Point{0, 0}, Point{1, 1}, Point{2, 2}}, {BodyPair{0, 2}, BodyPair{0, 3}},
                    {Point{3, 0}, Point{2.5, 1.2}}, {Point{5, 0}, Point{4, 2}});
}

std::vector<PrescribedPose> one_pose(Point origin) { return {{{origin, 0}, {}}}; }

TEST(SixBarMotion, OfACrankIsAFullTurn) {
  const auto poses = one_pose({3, 2});
  const SixBarMotion motion = six_bar_motion(with_crank(), poses, step);
  EXPECT_TRUE(motion.full_turn);
  EXPECT_TRUE(motion.dyadic);
  EXPECT_GE(motion.states.size(), 361u);
  EXPECT_EQ(motion.states.front().place.turn, 0);
  EXPECT_NEAR(motion.states.back().place.turn, two_pi, 1e-6);
  EXPECT_GT(motion.min_sine, 0.1);
}

TEST(SixBarMotion, EndsAtDeadPoints) {
  const auto poses = one_pose({2, 2});
  const SixBarMotion motion = six_bar_motion(with_rocker(), poses, step);
  EXPECT_FALSE(motion.full_turn);
  ASSERT_GT(motion.states.size(), 20u);
  EXPECT_LT(motion.states.front().place.turn, 0);
  EXPECT_GT(motion.states.back().place.turn, 0);
  EXPECT_LT(motion.states.front().sine, 0.01);
  EXPECT_LT(motion.states.back().sine, 0.01);
  int marked = 0;
  for (std::size_t i = 0; i < motion.states.size(); ++i) {
    if (i > 0) {
      EXPECT_LT(motion.states[i - 1].place.turn, motion.states[i].place.turn);
    }
    marked += motion.states[i].place.pose == 0 ? 1 : 0;
  }
  EXPECT_EQ(marked, 1);
}

TEST(SixBarMotion, TurnsPutTheHingesWhereTheyWere) {
  const SixBar six_bar = with_crank();
  const auto turned = closed(six_bar, {1, direction(0.7), 1, 1, 1, 1});
  ASSERT_TRUE(turned);
  const SixBarTurns again = turns_of(six_bar, joints_at(six_bar, *turned));
  for (std::size_t body = 0; body < again.size(); ++body) EXPECT_LT(std::abs(again[body] - (*turned)[body]), 1e-13);
}

/// What travels through the poses is what drive_six_bar finds, with the same least transmission angle.
TEST(SixBarMotion, TravelsAsTheDriveReportSays) {
  std::mt19937_64 random(5);
  int travelled = 0, stuck = 0;
  for (const SixBarRow& row : six_bar_rows())
    for (int i = 0; i < 12; ++i) {
      const auto found = testing::random_six_bar(random, row);
      const SixBarDriveReport report = drive_six_bar(found.member.six_bar, found.member.turns);
      if (!report.completed) continue;
      const SixBarMotion motion = travel_through(found.member.six_bar, found.task.poses, step);
      ASSERT_EQ(motion.states.empty(), !report.defects.none()) << text(row.added[0]) << " " << text(row.added[1]);
      (motion.states.empty() ? stuck : travelled) += 1;
      if (motion.states.empty()) continue;
      EXPECT_EQ(motion.states.back().place.pose, 3);
      EXPECT_NEAR(std::abs(motion.states.back().place.turn), report.sweep, 1e-6);
      EXPECT_NEAR(motion.min_sine, report.min_sine, 0.01);
    }
  EXPECT_GT(travelled, 5);
  EXPECT_GT(stuck, 20);
}

/// Smaller steps find nothing smaller, though between states a degree apart γ may fall.
TEST(SixBarMotion, HasItsLeastSineWhateverTheStep) {
  std::mt19937_64 random(6);
  int between_states = 0, compared = 0;
  for (const SixBarRow& row : six_bar_rows())
    for (int i = 0; i < std::min(12, testing::draws(40)); ++i) {
      const auto found = testing::random_six_bar(random, row);
      const SixBarMotion coarse = travel_through(found.member.six_bar, found.task.poses, radians(1)),
                         fine = travel_through(found.member.six_bar, found.task.poses, radians(0.02));
      ASSERT_EQ(coarse.states.empty(), fine.states.empty());
      if (coarse.states.empty()) continue;
      ++compared;
      EXPECT_NEAR(coarse.min_sine, fine.min_sine, 1e-6);
      const auto at_states = std::min_element(coarse.states.begin(), coarse.states.end(),
                                              [](const auto& a, const auto& b) { return a.sine < b.sine; });
      between_states += coarse.min_sine < at_states->sine - 1e-9 ? 1 : 0;
    }
  EXPECT_GT(compared, testing::draws(20) / 4);
  EXPECT_GT(between_states, 0);
}

}  // namespace
}  // namespace linkwright::six_bar_motion_test
