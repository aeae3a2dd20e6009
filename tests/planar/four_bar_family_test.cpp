#include "linkwright/planar/four_bar_family.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "linkwright/region/requirement_filter.hpp"
#include "planar/task_curve.hpp"
#include "support/tailgate.hpp"

namespace linkwright::four_bar_family_test {
namespace {

class FourBarFamilyTest : public ::testing::Test {
 protected:
  const MotionTask task = testing::tailgate_task();
  const TaskCurve given = task_curve(task);
  const CurveFamily curve{given.conditions.frame, task.poses, given.curve};
};

TEST_F(FourBarFamilyTest, CurvePairsAreItsDyads) {
  const auto links = curve.dyad_pair({1.3125, 1.1125});
  ASSERT_TRUE(links);
  EXPECT_TRUE(same_points(links->input, given.curve->dyad(1.3125)));
  EXPECT_TRUE(same_points(links->output, given.curve->dyad(1.1125)));
  EXPECT_TRUE(four_bar_of(*links));
  EXPECT_EQ(curve.axis(Side::input).coordinate_length(), 2);
  EXPECT_EQ(curve.samples(Side::output, 40, Spacing::coordinate), given.curve->samples(40, Spacing::coordinate));
  EXPECT_FALSE(curve.polygon(Side::input).empty());
}

TEST_F(FourBarFamilyTest, ItsMapIsThatOfItsAxes) {
  const auto tau = curve.samples(Side::input, 50, Spacing::coordinate);
  std::vector<Dyad> dyads;
  for (const double t : tau) dyads.push_back(given.curve->dyad(t));
  const DyadAxis axis(dyads, given.conditions.frame.to_working(task.poses));
  RegionMap wanted;
  classify_pairs(wanted, axis, axis, given.conditions.frame.scale);
  RegionMap map;
  curve.classify(map, tau, tau, true);
  EXPECT_TRUE(std::equal(map.types().begin(), map.types().end(), wanted.types().begin(), wanted.types().end()));
  EXPECT_TRUE(std::equal(map.defects().begin(), map.defects().end(), wanted.defects().begin()));
  EXPECT_EQ(map.counts().pairs, 50 * 49);
}

TEST_F(FourBarFamilyTest, PointsFillTheirBranches) {
  const PointFamily points(given.conditions.frame, task.poses,
                           {given.curve->dyad(1.3125), given.curve->dyad(1.1125), given.curve->dyad(0.2)});
  EXPECT_EQ(points.samples(Side::input, 400, Spacing::coordinate), (std::vector{0.5, 1.5, 2.5}));
  EXPECT_TRUE(points.axis(Side::input).is_discrete());
  EXPECT_EQ(points.dyad(Side::output, 1.9)->coordinate, 1.5);
  EXPECT_TRUE(same_points(*points.dyad(Side::output, 1.01), given.curve->dyad(1.1125)));
  EXPECT_FALSE(points.dyad(Side::input, 3));
  EXPECT_FALSE(points.dyad(Side::input, -0.1));
  EXPECT_FALSE(points.dyad_pair({0.5, std::nan("")}));
  RegionMap map;
  const auto tau = points.samples(Side::input, 3, Spacing::coordinate);
  points.classify(map, tau, tau, true);
  EXPECT_EQ(map.counts().pairs, 6);
  EXPECT_EQ(map.type(map.index(0, 1)), LinkageType::triple_rocker_output);
}

TEST_F(FourBarFamilyTest, AFilterJudgesTheSameByDyadsAndByCells) {
  const auto tau = curve.samples(Side::input, 60, Spacing::coordinate);
  RegionMap by_dyads, by_rows;
  curve.classify(by_dyads, tau, tau, true);
  const auto poses = given.conditions.frame.to_working(task.poses);
  std::vector<Dyad> dyads;
  for (const double t : tau) dyads.push_back(given.curve->dyad(t));
  classify_rows(
      by_rows, tau, tau,
      [&](std::size_t row) {
        return FourBarRow{DyadAxis({dyads[row]}, poses), DyadAxis(dyads, poses), {}};
      },
      given.conditions.frame.scale);
  const Requirements wanted = testing::tailgate_requirements();
  const RequirementFilter first = filter_of(curve, by_dyads, wanted), second = filter_of(curve, by_rows, wanted);
  EXPECT_GT(first.census().meeting, 0);
  EXPECT_EQ(first.census().failing, second.census().failing);
  EXPECT_EQ(by_rows.counts().defect_free, by_dyads.counts().defect_free);
}

}  // namespace
}  // namespace linkwright::four_bar_family_test
