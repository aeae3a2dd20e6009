#include "planar/timed_cranks.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

#include "linkwright/core/angle.hpp"
#include "linkwright/planar/burmester_points.hpp"
#include "linkwright/planar/timed_path.hpp"
#include "planar/timed_path_family.hpp"
#include "support/path_case.hpp"

namespace linkwright::timed_cranks_test {
namespace {

double farthest(const FourBar& a, const FourBar& b) {
  return std::max({std::abs(a.input_fixed - b.input_fixed), std::abs(a.input_moving - b.input_moving),
                   std::abs(a.output_fixed - b.output_fixed), std::abs(a.output_moving - b.output_moving)});
}

// All ordered pairs of the few cranks of five positions, user's frame.
std::vector<FourBar> linkages_of(const PathTask& task) {
  const PoseConditions conditions = pose_conditions(angled_poses(task));
  const BurmesterPoints cranks = burmester_points(conditions);
  std::vector<FourBar> found;
  for (const BurmesterPoint& crank : cranks.points)
    for (const BurmesterPoint& cognate : cranks.points) {
      const auto links = linkage_of_cranks(crank.dyad, cognate.dyad);
      const auto bars = links ? four_bar_of(*links) : std::nullopt;
      if (bars) found.push_back(conditions.frame.to_user(*bars));
    }
  return found;
}

void expect_linkages_of_case(const std::string& name, std::size_t count) {
  const testing::PathCase c = testing::path_case(name);
  const std::vector<FourBar> found = linkages_of(c.task);
  ASSERT_EQ(found.size(), count) << name;
  ASSERT_EQ(c.json.at("linkages").size(), count) << name;
  for (const auto& linkage : c.json.at("linkages")) {
    const FourBar wanted = testing::bars_of(linkage);
    double nearest = 1e300;
    for (const FourBar& bars : found) nearest = std::min(nearest, farthest(bars, wanted));
    EXPECT_LT(nearest, 1e-10 * wanted.lengths().longest()) << name;
  }
}

TEST(TimedCranks, PairsOfTheFewAreAllLinkagesOfFivePositions) {
  expect_linkages_of_case("stirrer_timed_five", 12);
  expect_linkages_of_case("packaging_feeder_timed_five_mixed", 2);
}

// Homogeneous coordinates are those of a point whatever their factor, and pivots are written with w = 1.
TEST(TimedCranks, SignsOfHomogeneousCoordinatesDoNotMatter) {
  const BurmesterPoints cranks =
      burmester_points(pose_conditions(angled_poses(testing::path_case("stirrer_timed_five").task)));
  const Dyad one = cranks.points[0].dyad, other = cranks.points[1].dyad;
  const Dyad turned{-1.0 * one.center, -1.0 * one.circle, one.coordinate};
  const auto links = linkage_of_cranks(one, other), same = linkage_of_cranks(turned, other);
  ASSERT_TRUE(links && same);
  for (const Dyad& link : {links->input, links->output, same->input, same->output}) EXPECT_EQ(link.center.w, 1);
  EXPECT_EQ(farthest(*four_bar_of(*links), *four_bar_of(*same)), 0);
}

// 0, 2 or 12, never anything else: cranks are 0, 2 or 4.
TEST(TimedCranks, FivePositionsHaveNoneTwoOrTwelveLinkages) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> place(-1, 1), step(0.3, 1.2);
  std::array<int, 13> tasks{};
  for (int i = 0; i < 200; ++i) {
    PathTask task;
    double angle = 0;
    for (int j = 0; j < 5; ++j) {
      task.points.push_back({{place(random), place(random)}, angle, {}});
      angle += step(random);
    }
    ++tasks.at(linkages_of(task).size());
  }
  EXPECT_EQ(tasks[0] + tasks[2] + tasks[12], 200);
  EXPECT_GT(tasks[0], 5);
  EXPECT_GT(tasks[2], 50);
  EXPECT_GT(tasks[12], 10);
}

TEST(TimedCranks, WhatHasNoLinkageHasNone) {
  const auto dyad = [](Point center, Point circle) {
    return Dyad{Homogeneous::of(center), Homogeneous::of(circle), 0};
  };
  const Dyad crank = dyad({1, 2}, {3, 1});
  EXPECT_FALSE(linkage_of_cranks(crank, crank)) << "its own cognate";
  EXPECT_FALSE(linkage_of_cranks(dyad({1, 2}, {0, 0}), crank)) << "a crank without length";
  EXPECT_TRUE(linkage_of_cranks(crank, dyad({1, 2}, {0, 0}))) << "the output carries the point";
  EXPECT_FALSE(linkage_of_cranks({Homogeneous::at_infinity({1, 0}), Homogeneous::of({3, 1}), 0}, crank));
  EXPECT_FALSE(linkage_of_cranks(crank, {Homogeneous::of({1, 2}), Homogeneous::at_infinity({1, 0}), 0}));
  const auto slider = linkage_of_cranks(crank, {Homogeneous::at_infinity({1, 0}), Homogeneous::of({4, 4}), 0});
  ASSERT_TRUE(slider) << "the output's moving pivot runs along a line";
  EXPECT_TRUE(is_at_infinity(slider->output.center));
  EXPECT_FALSE(four_bar_of(*slider));
}

// The point is carried by the output link round its circle: B is the point, B0 the circle's centre.
TEST(TimedCranks, PointsOnACircleAreCarriedByTheOutput) {
  const auto items = testing::path_case("nasty_timed").json.at("items");
  const auto item = std::find_if(items.begin(), items.end(),
                                 [](const auto& each) { return each.at("name") == "circle_other_timing"; });
  const PathTask task = testing::path_task(item->at("task"));
  const TaskFamily given = family_of_timed(task);
  ASSERT_TRUE(given.paths && given.curve);
  const auto warning = std::find_if(given.warnings.begin(), given.warnings.end(),
                                    [](const Notice& n) { return n.code == "points_on_circle"; });
  ASSERT_NE(warning, given.warnings.end());
  const double tau = std::get<double>(warning->values[2].value);
  const auto links = given.paths->dyad_pair({0.3, tau});
  ASSERT_TRUE(links);
  const auto bars = four_bar_of(*links);
  ASSERT_TRUE(bars);
  const FourBar user = given.frame().to_user(*bars);
  EXPECT_NEAR(std::abs(user.output_moving - task.points[0].point), 0, 1e-6);
  EXPECT_NEAR(std::abs(user.output_fixed - Point{10, 20}), 0, 1e-6);
  EXPECT_FALSE(given.paths->dyad_pair({tau, 0.3}).has_value() &&
               four_bar_of(*given.paths->dyad_pair({tau, 0.3}))->lengths().input > 1e-6);
}

}  // namespace
}  // namespace linkwright::timed_cranks_test
