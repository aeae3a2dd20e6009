#include "linkwright/mechanism/six_bar_check.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/six_bar_position.hpp"
#include "support/random_six_bar.hpp"

namespace linkwright::six_bar_check_test {
namespace {

/// A crank of 1 with all other links long: turns fully. The guided body 3 is a link of the second dyad.
SixBar with_crank() {
  return SixBar::of({Point{0, 0}, Point{1, 0}, Point{3, 2}}, {BodyPair{0, 2}, BodyPair{0, 3}},
                    {Point{5, 0}, Point{4, 3}}, {Point{6, -4}, Point{8, 3}});
}

TEST(SixBarCheck, GoesRoundAndComesHome) {
  const SixBar six_bar = with_crank();
  const std::vector<PrescribedPose> poses = {{{{3, 2}, 0}, {}}, {{{99, 99}, 0}, {}}};  // the second out of reach
  for (const int sense : {+1, -1}) {
    const SixBarCheck check = check_by_driving(six_bar, poses, sense);
    EXPECT_FALSE(check.stopped);
    EXPECT_TRUE(check.visited.empty());
    EXPECT_LT(check.worst_length, 1e-12);
    ASSERT_GT(check.states.size(), 300u);
    EXPECT_NEAR(std::abs(check.states.back().turn), two_pi, 1e-6);
    EXPECT_LT(std::abs(check.states.back().joints[SixBar::z5] - six_bar.at(SixBar::z5)), 1e-5);
  }
}

TEST(SixBarCheck, MeetsThePosesThatTheLoopsGive) {
  const SixBar six_bar = with_crank();
  const Pose first{{3, 2}, 0.4};
  std::vector<PrescribedPose> poses = {{first, {}}};
  SixBarTurns turns{1, 1, 1, 1, 1, 1};
  for (int step = 1; step <= 30; ++step) {
    turns[1] = direction(0.1 * step);
    const auto found = closed(six_bar, turns);
    ASSERT_TRUE(found);
    turns = *found;
    if (step % 10 == 0) poses.push_back({guided_pose(six_bar, turns, first), {}});
  }
  const SixBarCheck there = check_by_driving(six_bar, poses, +1), back = check_by_driving(six_bar, poses, -1);
  EXPECT_EQ(there.visited, (std::vector<int>{1, 2, 3}));
  EXPECT_EQ(back.visited, (std::vector<int>{3, 2, 1}));
  EXPECT_LT(there.worst_pose, 1e-9);
  const SixBarState& last = there.states[there.states.size() - 1];
  EXPECT_GE(last.turn, 3.0);
  EXPECT_LT(last.turn, 3.1);
}

TEST(SixBarCheck, MarksPosesAndDrivesOnIfAsked) {
  const SixBar six_bar = with_crank();
  const Pose first{{3, 2}, 0.4};
  const auto there = closed(six_bar, {1, direction(0.5), 1, 1, 1, 1});
  ASSERT_TRUE(there);
  const std::vector<PrescribedPose> poses = {{first, {}}, {guided_pose(six_bar, *there, first), {}}};
  for (const bool full_travel : {false, true}) {
    SixBarCheckOptions options;
    options.full_travel = full_travel;
    const SixBarCheck check = check_by_driving(six_bar, poses, +1, options);
    EXPECT_EQ(check.states.front().pose, 0);
    const auto met = std::find_if(check.states.begin(), check.states.end(), [](const auto& s) { return s.pose == 1; });
    ASSERT_NE(met, check.states.end());
    EXPECT_NEAR(met->turn, 0.5, 1e-9);
    EXPECT_NEAR(check.states.back().turn, full_travel ? two_pi : 0.51, full_travel ? 1e-6 : 0.02);
  }
}

TEST(SixBarCheck, StopsAtADeadPoint) {
  // Links 2 and 4 just reach: the crank cannot go round.
  const SixBar six_bar = SixBar::of({Point{0, 0}, Point{1, 1}, Point{2, 2}}, {BodyPair{0, 2}, BodyPair{0, 3}},
                                    {Point{3, 0}, Point{2.5, 1.2}}, {Point{5, 0}, Point{4, 2}});
  const std::vector<PrescribedPose> poses = {{{{0, 0}, 0}, {}}, {{{9, 9}, 0}, {}}};
  const SixBarCheck check = check_by_driving(six_bar, poses, +1);
  EXPECT_TRUE(check.stopped);
  EXPECT_LT(check.states.back().turn, pi);
  EXPECT_LT(check.worst_length, 1e-9);
}

TEST(SixBarCheck, FollowsTheBodyWithoutJumps) {
  const std::vector<PrescribedPose> poses = {{{{3, 2}, 3.1}, {}}, {{{99, 99}, 0}, {}}};
  const SixBarCheck check = check_by_driving(with_crank(), poses, +1);
  for (std::size_t i = 1; i < check.states.size(); ++i)
    EXPECT_LT(std::abs(check.states[i].body.angle - check.states[i - 1].body.angle), 0.1);
}

TEST(SixBarCheck, OfNoPosesIsEmpty) { EXPECT_TRUE(check_by_driving(with_crank(), {}, 1).states.empty()); }

}  // namespace
}  // namespace linkwright::six_bar_check_test
