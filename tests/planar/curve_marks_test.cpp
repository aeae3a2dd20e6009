#include "linkwright/planar/curve_marks.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "linkwright/core/tolerance.hpp"
#include "linkwright/planar/task_curve.hpp"
#include "support/planar_case.hpp"
#include "support/tailgate.hpp"

namespace linkwright::curve_marks_test {
namespace {

struct Marked {
  TaskCurve given;
  std::vector<CurveMark> marks;
};

Marked marked(const MotionTask& task) {
  TaskCurve given = task_curve(task);
  auto marks = curve_marks(task.poses, *given.curve, given.conditions.frame, given.curve->polygon(0.05));
  return {std::move(given), std::move(marks)};
}

std::ptrdiff_t count(const std::vector<CurveMark>& marks, CurveMark::Kind kind) {
  return std::count_if(marks.begin(), marks.end(), [&](const CurveMark& mark) { return mark.kind == kind; });
}

TEST(CurveMarks, PolesLieOnBothCurves) {
  const auto [given, marks] = marked(testing::tailgate_task());
  EXPECT_EQ(count(marks, CurveMark::Kind::pole), 6);
  const WorkingFrame& frame = given.conditions.frame;
  for (const CurveMark& mark : marks) {
    if (mark.kind != CurveMark::Kind::pole) continue;
    ASSERT_EQ(mark.tau.size(), 2u);
    const auto center = frame.finite_user_point(frame.to_user(given.curve->dyad(mark.tau[0]).center));
    const auto circle = frame.finite_user_point(frame.to_user(given.curve->dyad(mark.tau[1]).circle));
    EXPECT_LT(std::abs(*center - *mark.center), 1e-6);
    EXPECT_LT(std::abs(*circle - *mark.circle), 1e-6);
  }
}

TEST(CurveMarks, PointsAtInfinityAreThere) {
  for (const auto& c : testing::planar_cases()) {
    const TaskCurve given = task_curve({c.poses});
    // Where the arithmetic is at its end, a whole loop of one curve may belong to less than a side of the polygon.
    if (!given.curve->kappa() || !c.is_finite() || given.conditions.condition() > tolerance::ill_conditioned) continue;
    const auto marks = curve_marks(c.poses, *given.curve, given.conditions.frame, given.curve->polygon(0.025));
    // A circular cubic has one real point at infinity, or touches the line there.
    EXPECT_EQ(count(marks, CurveMark::Kind::center_at_infinity), 1) << c.name;
    EXPECT_EQ(count(marks, CurveMark::Kind::circle_at_infinity), 1) << c.name;
    for (const CurveMark& mark : marks) {
      const bool center = mark.kind == CurveMark::Kind::center_at_infinity;
      if (!center && mark.kind != CurveMark::Kind::circle_at_infinity) continue;
      const Dyad dyad = given.curve->dyad(mark.tau[0]);
      EXPECT_TRUE(is_at_infinity(center ? dyad.center : dyad.circle)) << c.name;
    }
  }
}

TEST(CurveMarks, PolesOfParallelPosesAreAtInfinity) {
  MotionTask task = testing::tailgate_task();
  task.poses[2].pose.angle = task.poses[0].pose.angle;
  const auto [given, marks] = marked(task);
  const auto pole = std::find_if(marks.begin(), marks.end(), [](const CurveMark& mark) {
    return mark.kind == CurveMark::Kind::pole && mark.poses == std::array{0, 2};
  });
  ASSERT_NE(pole, marks.end());
  EXPECT_FALSE(pole->center);
  EXPECT_TRUE(pole->tau.empty());
}

}  // namespace
}  // namespace linkwright::curve_marks_test
