#include "planar/curve_on_lines_family.hpp"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "linkwright/core/angle.hpp"
#include "linkwright/planar/task_family.hpp"
#include "support/circle_conditions.hpp"
#include "support/random_task.hpp"
#include "support/tailgate.hpp"

namespace linkwright::curve_on_lines_family_test {
namespace {

using testing::uniform;

struct FourPoses {
  explicit FourPoses(const std::vector<PrescribedPose>& poses)
      : conditions(pose_conditions(poses)), curve(std::make_shared<const BurmesterCurve>(conditions)) {}

  [[nodiscard]] std::optional<std::vector<Dyad>> on_line(PivotKind kind, const DirectedLine& line) const {
    return dyads_on_line(conditions, *curve, kind, {conditions.frame.to_working(line.point), line.direction});
  }
  [[nodiscard]] Point user(Homogeneous p) const { return conditions.frame.to_user(finite_point(p).value()); }

  PoseConditions conditions;
  std::shared_ptr<const BurmesterCurve> curve;
};

// By four circle equations and Newton's method with forty digits, elsewhere.
TEST(DyadsOnLine, AreThreeForTheTailgate) {
  const FourPoses task(testing::tailgate_task().poses);
  const auto found = task.on_line(PivotKind::ground, {{0, 340}, 1});
  ASSERT_TRUE(found);
  ASSERT_EQ(found->size(), 3u);
  const std::array<std::array<Point, 2>, 3> expected = {
      {{Point{120.48053051212581, 340}, Point{17.868633939000347, 92.8561435330648}},
       {Point{140.31719165458614, 340}, Point{148.19932641026318, 359.45551268729974}},
       {Point{200.296447168056, 340}, Point{-16.82643133369812, 262.1156097963709}}}};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_LT(std::abs(task.user((*found)[i].center) - expected[i][0]), 1e-7);
    EXPECT_LT(std::abs(task.user((*found)[i].circle) - expected[i][1]), 1e-7);
  }
}

// Every crossing of the polygon of the curve with the line is one of them, and each of them keeps its length.
TEST(DyadsOnLine, AreWhereTheCurveCrossesIt) {
  std::mt19937_64 random(3);
  std::array<int, 4> of_count{};
  for (int trial = 0; trial < 40; ++trial)
    for (const PivotKind kind : {PivotKind::ground, PivotKind::moving}) {
      const auto poses = testing::random_poses(random);
      const FourPoses task(poses);
      const DirectedLine line{{uniform(random, -3, 3), uniform(random, -3, 3)}, direction(uniform(random, -pi, pi))};
      const auto found = task.on_line(kind, line);
      ASSERT_TRUE(found);
      ASSERT_LE(found->size(), 3u);
      ++of_count[found->size()];
      const auto pivot_of = [&](const Dyad& dyad) { return kind == PivotKind::ground ? dyad.center : dyad.circle; };
      for (const Dyad& dyad : *found) {
        EXPECT_NEAR(line.to_line(task.user(pivot_of(dyad))).imag(), 0, 1e-9);
        EXPECT_LT(testing::length_change(poses, task.user(dyad.center), task.user(dyad.circle)), 1e-7);
      }
      const auto polygon = task.curve->polygon(0.01);
      for (std::size_t i = 1; i < polygon.size(); ++i) {
        const auto p = finite_point(pivot_of(polygon[i - 1])), q = finite_point(pivot_of(polygon[i]));
        if (!p || !q || std::abs(*p) > 10 || std::abs(*p - *q) > 0.5) continue;
        const Point before = line.to_line(task.conditions.frame.to_user(*p)),
                    after = line.to_line(task.conditions.frame.to_user(*q));
        if ((before.imag() < 0) == (after.imag() < 0)) continue;
        double nearest = 1e9;
        for (const Dyad& dyad : *found)
          nearest = std::min(nearest, std::abs(line.to_line(task.user(pivot_of(dyad))).real() - after.real()));
        EXPECT_LT(nearest, 2 * std::abs(after - before) + 1e-3);
      }
    }
  EXPECT_GT(of_count[1], 5);
  EXPECT_GT(of_count[3], 5);
}

TEST(CurveOnLinesFamily, KeepsOneLinkToItsLineAndLeavesTheOtherOnTheCurve) {
  MotionTask task = testing::tailgate_task();
  task.pivots_on = {{Side::output, PivotKind::ground, LineAtAngle({0, 340}, 0)}};
  const TaskFamily given = task_family(task, {}, Objective::min_transmission_angle);
  ASSERT_TRUE(given.family);
  EXPECT_EQ(given.family->axis(Side::output).branches.size(), 3u);
  EXPECT_EQ(given.family->axis(Side::input).quantity, AxisQuantity::curve_coordinate);
  EXPECT_EQ(given.family->samples(Side::input, 50, Spacing::coordinate).size(), 50u);
  RegionMap map;
  given.family->classify(map, given.family->samples(Side::input, 50, Spacing::coordinate),
                         given.family->samples(Side::output, 50, Spacing::coordinate), true);
  EXPECT_EQ(map.rows(), 50u);
  ASSERT_EQ(map.columns(), 3u);
  for (const auto& pivots : given.family->pivots(map).columns) EXPECT_NEAR(pivots.ground->y, 340, 1e-9);
  EXPECT_GT(map.counts().defect_free, 0);
}

TEST(CurveOnLinesFamily, HasFewPairsWhereBothLinksKeepToALine) {
  MotionTask task = testing::tailgate_task();
  task.pivots_on = {{Side::output, PivotKind::ground, LineAtAngle({0, 340}, 0)},
                    {Side::input, PivotKind::moving, LineAtAngle({0, 200}, 0.3)}};
  const TaskFamily given = task_family(task, {}, Objective::min_transmission_angle);
  ASSERT_TRUE(given.family);
  EXPECT_TRUE(given.family->axis(Side::input).is_discrete());
  EXPECT_TRUE(given.family->axis(Side::output).is_discrete());
}

}  // namespace
}  // namespace linkwright::curve_on_lines_family_test
