#include "linkwright/mechanism/task_cycle.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/pose.hpp"

namespace linkwright::task_cycle_test {
namespace {

constexpr double step = radians(1);
constexpr FourBar crank_rocker{{0, 0}, {0, 2}, {4, 0}, {3, 3.5}};
constexpr FourBar triple_rocker{{0, 0}, {0, 5}, {4, 0}, {2, 6}};

/// The poses of a body whose frame lies at the input's moving pivot, with the input turned by these angles.
std::vector<PrescribedPose> poses_at(const FourBar& bars, std::initializer_list<double> turns) {
  const Configuration start = configuration_of(bars);
  std::vector<PrescribedPose> poses;
  for (const double turn : turns) {
    const auto there = assemble(bars.lengths(), start.input_angle + turn, assembly_of(bars));
    const FourBar moved = placed(bars, *there);
    poses.push_back({{moved.input_moving, there->coupler_angle - start.coupler_angle}, {}});
  }
  return poses;
}

void expect_linkage_holds(const FourBar& bars, const std::vector<CycleState>& cycle) {
  const LinkLengths lengths = bars.lengths();
  for (const CycleState& state : cycle) {
    EXPECT_NEAR(state.four_bar.lengths().coupler, lengths.coupler, 1e-9);
    EXPECT_NEAR(state.four_bar.lengths().output, lengths.output, 1e-9);
    EXPECT_NEAR(std::abs(state.body.origin - state.four_bar.input_moving), 0, 1e-9);
    EXPECT_NEAR(std::sin(state.input_angle - std::arg(state.four_bar.input_moving - state.four_bar.input_fixed)), 0,
                1e-9);
  }
  for (std::size_t i = 1; i < cycle.size(); ++i) {
    EXPECT_LE(std::abs(cycle[i].turn - cycle[i - 1].turn), step + 1e-12);
    EXPECT_LT(std::abs(cycle[i].coupler_angle - cycle[i - 1].coupler_angle), 0.5);
    EXPECT_LT(std::abs(cycle[i].body.angle - cycle[i - 1].body.angle), 0.5);
  }
}

std::vector<int> met(const std::vector<CycleState>& cycle) {
  std::vector<int> poses;
  for (const CycleState& state : cycle)
    if (state.pose >= 0) poses.push_back(state.pose);
  return poses;
}

TEST(TaskCycle, OfACrankTurnsTheWayOfTheTask) {
  for (const double sense : {1.0, -1.0}) {
    const auto poses = poses_at(crank_rocker, {0, sense * 0.31, sense * 1.7});
    const auto cycle = task_cycle(crank_rocker, poses, step);
    expect_linkage_holds(crank_rocker, cycle);
    EXPECT_EQ(met(cycle), (std::vector{0, 1, 2}));
    EXPECT_EQ(cycle.size(), 361u + 2u);
    EXPECT_EQ(cycle.front().pose, 0);
    EXPECT_NEAR(cycle.back().turn, sense * two_pi, 1e-12);
    EXPECT_NEAR(std::abs(cycle.back().body.origin - poses[0].pose.origin), 0, 1e-9);
  }
}

TEST(TaskCycle, OfARockerComesBackToPositionOneByBothDeadPoints) {
  const auto poses = poses_at(triple_rocker, {0, -0.1, -0.2});
  const auto cycle = task_cycle(triple_rocker, poses, step);
  expect_linkage_holds(triple_rocker, cycle);
  EXPECT_EQ(met(cycle), (std::vector{0, 1, 2}));
  EXPECT_LT(cycle[1].turn, 0) << "in the sense of the task";
  EXPECT_EQ(std::count_if(cycle.begin(), cycle.end(), [](const CycleState& state) { return !state.rates; }), 2);
  EXPECT_NEAR(cycle.back().turn, 0, 1e-12);
  EXPECT_NEAR(std::abs(cycle.back().body.origin - poses[0].pose.origin), 0, 1e-9);
}

TEST(TaskCycle, TellsNoPoseOfAnotherCircuit) {
  auto poses = poses_at(crank_rocker, {0, 0.31});
  const Configuration start = configuration_of(crank_rocker);
  const auto other = assemble(crank_rocker.lengths(), start.input_angle + 0.4, Assembly::negative);
  ASSERT_EQ(assembly_of(crank_rocker), Assembly::positive);
  poses.push_back({{placed(crank_rocker, *other).input_moving, other->coupler_angle - start.coupler_angle}, {}});
  EXPECT_EQ(met(task_cycle(crank_rocker, poses, step)), (std::vector{0, 1}));
}

TEST(TaskCycle, OfALinkageThatMissesItsPosesIsItsOwnMotion) {
  for (const FourBar& bars : {crank_rocker, triple_rocker}) {
    auto poses = bars.input_moving == crank_rocker.input_moving ? poses_at(bars, {0, 0.31, 1.7})
                                                                : poses_at(bars, {0, -0.1, -0.2});
    poses[1].pose.origin += Point{0.02, -0.01};
    poses[2].pose.angle += 0.01;
    const auto cycle = task_cycle(bars, poses, step);
    expect_linkage_holds(bars, cycle);
    EXPECT_EQ(met(cycle), (std::vector{0, 1, 2}));
    for (const CycleState& state : cycle) {
      if (state.pose < 0) continue;
      const auto pose = static_cast<std::size_t>(state.pose);
      EXPECT_EQ(state.error, body_error(state.body, poses[pose].pose));
      if (state.pose == 0) {
        EXPECT_EQ(state.error, (BodyError{0, 0}));
      } else {
        EXPECT_GT(state.error.distance + state.error.angle, 1e-4);
        EXPECT_LT(state.error.distance + state.error.angle, 0.1);
      }
      // It comes no nearer in any of the rows, by the distances of its moving pivots.
      const auto off = [&](const CycleState& there) {
        return std::norm(there.four_bar.input_moving - displaced(bars.input_moving, poses[0].pose, poses[pose].pose)) +
               std::norm(there.four_bar.output_moving - displaced(bars.output_moving, poses[0].pose, poses[pose].pose));
      };
      for (const CycleState& other : cycle) EXPECT_GE(off(other), off(state) - 1e-12);
    }
  }
}

// Its input wants to be on one side of the beginning of the turn, and the linkage comes nearest to it on the other.
TEST(TaskCycle, OfACrankComesToAPoseHardByTheFirst) {
  constexpr FourBar bars{
      {0, 0}, {16.209069176044192, 25.244129544236895}, {100, 0}, {88.28846445769186, 79.13810672009568}};
  const std::vector<std::vector<PrescribedPose>> tasks = {
      {{{{36.209069176044196, 35.2441295442369}, radians(0.0)}, {}},
       {{{36.1789437638535, 35.24568295359007}, radians(0.11334996880785239)}, {}},
       {{{-9.496513335560977, 13.816304569861977}, radians(-1.1893772444599418)}, {}}},
      {{{{36.209069176044196, 35.2441295442369}, radians(0.0)}, {}},
       {{{36.23939486313045, 35.28214710921858}, radians(-0.11711064402950175)}, {}},
       {{{-9.496513335560977, 13.816304569861977}, radians(-1.1893772444599418)}, {}}}};
  for (const auto& poses : tasks) {
    std::vector<int> poses_met = met(task_cycle(bars, poses, step));
    std::sort(poses_met.begin(), poses_met.end());
    poses_met.erase(std::unique(poses_met.begin(), poses_met.end()), poses_met.end());
    EXPECT_EQ(poses_met, (std::vector{0, 1, 2}));
  }
}

TEST(TaskCycle, OfALinkWithoutLengthIsEmpty) {
  EXPECT_TRUE(task_cycle({{0, 0}, {0, 0}, {4, 0}, {3, 3}}, poses_at(crank_rocker, {0}), step).empty());
}

}  // namespace
}  // namespace linkwright::task_cycle_test
