#include "linkwright/planar/timed_path.hpp"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/drive_through.hpp"
#include "linkwright/planar/path_task.hpp"
#include "support/path_case.hpp"

namespace linkwright::timed_path_test {
namespace {

constexpr std::array names = {"film_claw_timed", "dough_mixer_timed_full_turn", "thread_takeup_timed_mixed",
                              "stirrer_timed_five", "packaging_feeder_timed_five_mixed"};

Point crank_at(const FourBar& bars, double turn) {
  return bars.input_fixed + direction(turn) * (bars.input_moving - bars.input_fixed);
}

TEST(TimedPath, HasTheTurnsOfTheCoupler) {
  int compared = 0;
  for (const char* name : names) {
    const testing::PathCase c = testing::path_case(name);
    for (const auto& linkage : c.json.at("linkages")) {
      const FourBar bars = testing::bars_of(linkage);
      const TimedPath path = timed_path(bars, angled_poses(c.task));
      EXPECT_EQ(path.point, c.task.points[0].point);
      for (std::size_t j = 0; j < c.task.points.size(); ++j) {
        EXPECT_NEAR(wrap_signed(path.coupler[j] - radians(linkage.at("coupler_deg_at_points")[j].get<double>())), 0,
                    1e-9)
            << name;
        EXPECT_NEAR(wrap_signed(path.input[j] - radians(linkage.at("input_deg_at_points")[j].get<double>())), 0, 1e-9)
            << name;
        ++compared;
      }
      const auto turns = linkage.at("type") == "crank_rocker" || linkage.at("type") == "double_crank";
      EXPECT_EQ(path.full_turn, turns) << name;
    }
  }
  EXPECT_GT(compared, 150);
}

// Both arms of the point keep their lengths, and so does the output link: by the poses alone.
TEST(TimedPath, PosesOfTheCouplerLeaveTheLinksAsLongAsTheyAre) {
  for (const char* name : names) {
    const testing::PathCase c = testing::path_case(name);
    for (const auto& linkage : c.json.at("linkages")) {
      const FourBar bars = testing::bars_of(linkage);
      const auto cranks = angled_poses(c.task), poses = path_poses(bars, cranks);
      const double size = bars.lengths().longest();
      for (std::size_t j = 0; j < poses.size(); ++j) {
        const Point a = displaced(bars.input_moving, poses[0].pose, poses[j].pose);
        const Point b = displaced(bars.output_moving, poses[0].pose, poses[j].pose);
        EXPECT_NEAR(std::abs(a - crank_at(bars, cranks[j].pose.angle)), 0, 1e-11 * size) << name;
        EXPECT_NEAR(std::abs(b - bars.output_fixed), bars.lengths().output, 1e-11 * size) << name;
      }
    }
  }
}

// The derivative of the coupler's turn moves the output's pivot at right angles to its link.
TEST(TimedPath, DerivativesOfTheCouplerLeaveTheOutputLinkAsLongAsItIs) {
  int compared = 0;
  for (const char* name : {"thread_takeup_timed_mixed", "packaging_feeder_timed_five_mixed"}) {
    const testing::PathCase c = testing::path_case(name);
    for (const auto& linkage : c.json.at("linkages")) {
      const FourBar bars = testing::bars_of(linkage);
      const auto poses = path_poses(bars, angled_poses(c.task));
      for (const PrescribedPose& pose : poses) {
        if (pose.derivatives.empty()) continue;
        const Point b = displaced(bars.output_moving, poses[0].pose, pose.pose);
        const PoseDerivative& d = pose.derivatives.front();
        const Point rate = d.origin + Point{0, d.angle} * (b - pose.pose.origin);
        EXPECT_NEAR(dot(rate, b - bars.output_fixed) / (std::abs(rate) * bars.lengths().output), 0, 1e-10) << name;
        ++compared;
      }
    }
  }
  EXPECT_EQ(compared, 14);
}

// Its cognate draws the same path: it closes with the same point at every angle of the crank.
TEST(TimedPath, TheCognateHasTheSamePathAndTiming) {
  for (const char* name : names) {
    const testing::PathCase c = testing::path_case(name);
    for (const auto& linkage : c.json.at("linkages")) {
      const FourBar bars = testing::bars_of(linkage);
      const auto cranks = angled_poses(c.task);
      const TimedPath path = timed_path(bars, cranks);
      const FourBar cognate = path.cognate.value();
      const double size = cognate.lengths().longest();
      const auto poses = path_poses(cognate, cranks);
      for (std::size_t j = 0; j < poses.size(); ++j) {
        const Point a = displaced(cognate.input_moving, poses[0].pose, poses[j].pose);
        const Point b = displaced(cognate.output_moving, poses[0].pose, poses[j].pose);
        EXPECT_NEAR(std::abs(a - crank_at(cognate, cranks[j].pose.angle)), 0, 1e-11 * size) << name;
        EXPECT_NEAR(std::abs(b - cognate.output_fixed), cognate.lengths().output, 1e-11 * size) << name;
      }
      EXPECT_NEAR(path.cognate_size * bars.lengths().ground, cognate.lengths().ground, 1e-11 * size) << name;
      const FourBar back = timed_cognate(cognate, path.point);
      EXPECT_NEAR(std::abs(back.input_moving - bars.input_moving), 0, 1e-10 * size) << name;
      EXPECT_NEAR(std::abs(back.output_fixed - bars.output_fixed), 0, 1e-10 * size) << name;
    }
  }
}

// The case files traced the circuits by the length of their arcs.
TEST(TimedPath, OrderAlongTheCircuitIsThatOfTracing) {
  int in_order = 0, in_another = 0, on_other_circuits = 0;
  for (const char* name : names) {
    const testing::PathCase c = testing::path_case(name);
    for (const auto& linkage : c.json.at("linkages")) {
      const FourBar bars = testing::bars_of(linkage);
      const auto poses = path_poses(bars, angled_poses(c.task));
      const auto found = circuit_order(bars, poses);
      const auto& traced = linkage.at("order_along_circuit_by_tracing");
      if (traced.is_null()) {
        EXPECT_FALSE(found.has_value()) << name;
        ++on_other_circuits;
        continue;
      }
      std::vector<int> order = traced.get<std::vector<int>>(), listed;
      for (std::size_t j = 0; j < order.size(); ++j) listed.push_back(static_cast<int>(j) + 1);
      if (order.size() > 2 && order[1] != 2) std::reverse(order.begin() + 1, order.end());
      ASSERT_TRUE(found.has_value()) << name;
      EXPECT_EQ(*found, order == listed) << name;
      ++(order == listed ? in_order : in_another);
    }
  }
  EXPECT_GT(in_order, 20);
  EXPECT_GT(on_other_circuits, 1);
  EXPECT_GT(in_another, 0);
}

// The same by continuation along the curve of configurations, for linkages with defects of all kinds.
TEST(TimedPath, OrderAlongTheCircuitIsThatOfDriving) {
  int compared = 0;
  for (const char* name : names) {
    const testing::PathCase c = testing::path_case(name);
    if (c.task.points.size() < 4) continue;
    for (const auto& linkage : c.json.at("linkages")) {
      const FourBar bars = testing::bars_of(linkage);
      const auto poses = path_poses(bars, angled_poses(c.task));
      const auto found = circuit_order(bars, poses);
      const DriveThroughReport driven = drive_through(bars, poses);
      if (!found || !driven.completed) continue;
      std::vector<int> listed;
      for (std::size_t j = 0; j < poses.size(); ++j) listed.push_back(static_cast<int>(j));
      EXPECT_EQ(*found, driven.visited == listed) << name;
      ++compared;
    }
  }
  EXPECT_GT(compared, 15);
}

}  // namespace
}  // namespace linkwright::timed_path_test
