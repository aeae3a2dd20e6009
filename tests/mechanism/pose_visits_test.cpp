#include "linkwright/mechanism/pose_visits.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/planar/task_family.hpp"
#include "linkwright/synthesis/solve.hpp"
#include "support/planar_case.hpp"
#include "support/random_four_bar.hpp"

namespace linkwright::pose_visits_test {
namespace {

using testing::coupler_pose;
using testing::four_bar_at;

constexpr LinkLengths crank_rocker{4, 1, 3, 2.5}, rocker_crank{4, 2.5, 3, 1};

struct Stand {
  double input_angle = 0;
  Assembly assembly = Assembly::positive;
};

/// The poses of a body on the coupler where the linkage stands so, and the linkage at the first.
std::pair<FourBar, std::vector<PrescribedPose>> passing(const LinkLengths& lengths, const std::vector<Stand>& stands) {
  std::vector<PrescribedPose> poses;
  for (const auto& [angle, assembly] : stands)
    poses.push_back({coupler_pose(four_bar_at(lengths, angle, assembly)), {}});
  return {four_bar_at(lengths, stands.front().input_angle, stands.front().assembly), poses};
}

std::string text_of(const Notice& notice, std::size_t value) {
  const auto& held = notice.values.at(value).value;
  return std::holds_alternative<double>(held) ? std::to_string(static_cast<int>(std::get<double>(held)))
                                              : std::get<std::string>(held);
}

TEST(PoseVisits, OfNoPosesAreNone) {
  const PoseVisits visits = pose_visits(passing(crank_rocker, {{0.5}, {1.5}}).first, {});
  EXPECT_TRUE(visits.four_bars.empty());
  EXPECT_TRUE(visits.order.empty());
}

TEST(PoseVisits, ACrankMeetsThePosesInTheOrderOfItsTurn) {
  const auto [bars, poses] = passing(crank_rocker, {{0.5}, {1.5}, {1.0}, {2.5}});
  const PoseVisits visits = pose_visits(bars, poses);
  EXPECT_TRUE(visits.full_turn);
  EXPECT_TRUE(visits.counter_clockwise);
  EXPECT_EQ(visits.order, (std::vector<int>{0, 2, 1, 3}));
  EXPECT_NEAR(visits.turn[3], 2, 1e-12);
  EXPECT_NEAR(visits.travel.to - visits.travel.from, two_pi, 1e-12);
  const auto notice = defect_notice(find_defects(bars, poses).defects, visits);
  ASSERT_TRUE(notice);
  EXPECT_EQ(notice->code, "order_defect");
  EXPECT_EQ(text_of(*notice, 0), "1-3-2-4");
}

TEST(PoseVisits, TurnsInTheSenseInWhichThePosesComeInOrder) {
  const auto [bars, poses] = passing(crank_rocker, {{0.5}, {0.1}, {-0.4}, {-1.5}});
  const PoseVisits visits = pose_visits(bars, poses);
  EXPECT_FALSE(visits.counter_clockwise);
  EXPECT_EQ(visits.order, (std::vector<int>{0, 1, 2, 3}));
  EXPECT_NEAR(visits.turn[3], 2, 1e-12);
  EXPECT_FALSE(defect_notice(find_defects(bars, poses).defects, visits));
}

TEST(PoseVisits, ARockerTravelsFromDeadPointToDeadPoint) {
  const auto range = input_ranges(rocker_crank).back();
  const auto [bars, poses] =
      passing(rocker_crank, {{range.from + 0.3}, {range.from + 0.5}, {range.from + 0.6}, {range.to - 0.1}});
  const PoseVisits visits = pose_visits(bars, poses);
  EXPECT_FALSE(visits.full_turn);
  EXPECT_NEAR(visits.travel.from, -0.3, 1e-9);
  EXPECT_NEAR(visits.travel.to, range.to - range.from - 0.3, 1e-9);
  EXPECT_EQ(visits.order, (std::vector<int>{0, 1, 2, 3}));
}

TEST(PoseVisits, TellBetweenWhichPosesADeadPointLies) {
  const auto range = input_ranges(rocker_crank).back();
  const double middle = (range.from + range.to) / 2;
  const auto [bars, poses] = passing(
      rocker_crank, {{middle}, {middle + 0.1}, {middle + 0.2, Assembly::negative}, {middle, Assembly::negative}});
  const PoseVisits visits = pose_visits(bars, poses);
  EXPECT_EQ(visits.first_on_another_branch(), 2);
  EXPECT_EQ(visits.first_on_another_circuit(), 0);
  EXPECT_EQ(visits.order, (std::vector<int>{0, 1}));
  const auto notice = defect_notice(find_defects(bars, poses).defects, visits);
  ASSERT_TRUE(notice);
  EXPECT_EQ(notice->code, "branch_defect");
  EXPECT_EQ(text_of(*notice, 0) + text_of(*notice, 1), "23");
}

TEST(PoseVisits, TellWhichPosesNeedTakingApart) {
  const auto [bars, poses] = passing(crank_rocker, {{0.5}, {1.0}, {1.5}, {2.5, Assembly::negative}});
  const PoseVisits visits = pose_visits(bars, poses);
  EXPECT_EQ(visits.on_circuit, (std::vector<bool>{true, true, true, false}));
  const auto notice = defect_notice(find_defects(bars, poses).defects, visits);
  ASSERT_TRUE(notice);
  EXPECT_EQ(notice->code, "circuit_defect");
  EXPECT_EQ(text_of(*notice, 0) + text_of(*notice, 1), "34");
}

// The same joint signs, so the same verdict: over all four-bars of a task's map.
TEST(PoseVisits, AgreeWithFindDefects) {
  for (const auto& c : testing::planar_cases()) {
    if (!c.is_finite()) continue;
    const MotionTask task{c.poses};
    const TaskFamily given = task_family(task, {}, Objective::min_transmission_angle);
    if (given.degeneracy) continue;
    const auto samples = given.curve->samples(24, Spacing::coordinate);
    for (const double input : samples)
      for (const double output : samples) {
        if (input == output) continue;
        const auto found = make_four_bar(given, {input, output}, true, false);
        if (!found || found->report.type == LinkageType::change_point) continue;
        const Defects defects = found->report.defects;
        const PoseVisits visits = pose_visits(found->four_bar, task.poses);
        ASSERT_FALSE(visits.order.empty()) << c.name << " " << input << " " << output;
        EXPECT_EQ(visits.first_on_another_circuit() > 0, defects.circuit()) << c.name << " " << input << " " << output;
        EXPECT_EQ(visits.first_on_another_branch() > 0, defects.branch()) << c.name << " " << input << " " << output;
        if (!defects.branch()) {
          EXPECT_EQ(visits.order != (std::vector<int>{0, 1, 2, 3}), defects.order())
              << c.name << " " << input << " " << output;
        }
      }
  }
}

TEST(PoseVisits, AreEmptyWhereThereIsNoLinkage) {
  const std::vector<PrescribedPose> poses(4);
  EXPECT_TRUE(pose_visits(FourBar{}, poses).order.empty());
}

}  // namespace
}  // namespace linkwright::pose_visits_test
