#include "linkwright/straight_line/straight_line_solution.hpp"

#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"

namespace linkwright {
namespace {

using namespace straight_cases;

TEST(StraightLineSolution, IsMeasuredExactly) {
  const StraightLineFamily family({LineAtAngle({1.5, 2}, radians(20)), FourPointPivots{{0, 0}, {3, 0}}},
                                  {0.001, 0.2, LineMeasure::tangent});
  const MapPoint place = family.point_of({1, {100, 35}}).value();
  const auto found = make_straight_line(family, place);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->contact.points, 4);
  EXPECT_EQ(found->place.layer, 1);
  EXPECT_LT(found->residual, 1e-12);
  EXPECT_TRUE(found->verified_by_driving);
  EXPECT_TRUE(found->defects.none());
  EXPECT_DOUBLE_EQ(found->deviation, 0.001);
  EXPECT_GE(found->usable_strip.length(), found->usable.length());
  ASSERT_TRUE(found->stroke);
  EXPECT_DOUBLE_EQ(found->stroke->from, -0.1);
  EXPECT_NEAR(found->point_to_input(), std::abs(found->linkage.point - found->linkage.bars.input_moving), 0);
  EXPECT_EQ(&found->counted(LineMeasure::strip), &found->usable_strip);
}

TEST(StraightLineSolution, HasCognatesAsStraightAsItself) {
  const StraightLineFamily family({LineAtAngle({1.5, 2}, radians(20)), FourPointPivots{{0, 0}, {3, 0}}},
                                  {0.001, 0.2, LineMeasure::strip});
  const auto found = make_straight_line(family, family.point_of({1, {100, 35}}).value());
  ASSERT_TRUE(found);
  ASSERT_EQ(found->cognates.size(), 2U);
  for (const StraightLineCognate& other : found->cognates) {
    EXPECT_EQ(other.linkage.point, found->linkage.point);
    EXPECT_GT(std::abs(other.linkage.bars.input_moving - found->linkage.bars.input_moving), 1e-3);
    EXPECT_EQ(other.type, linkage_type(other.linkage.bars.lengths()));
    const StrokeReport &here = found->over_usable, &there = other.over_usable;
    EXPECT_NEAR(there.from, here.from, 1e-9);
    EXPECT_NEAR(there.to, here.to, 1e-9);
    EXPECT_NEAR(there.max_deviation, here.max_deviation, 1e-12);
    EXPECT_NEAR(there.best_line_deviation, here.best_line_deviation, 1e-12);
    const auto backwards = StraightPath::of(other.linkage.swapped(), family.task().line.direction);
    EXPECT_LT(backwards->stroke(there.from, there.to)->min_transmission_angle, there.min_transmission_angle);
  }
}

TEST(StraightLineSolution, FailsALimitOfTheDeviationWhereItsPointTurnsBackBeforeTheStrokeEnds) {
  const StraightLineTask task{LineAtAngle({1.5, 2}, radians(20)), FourPointPivots{{0, 0}, {3, 0}}};
  Requirements wanted;
  wanted.max_length = Requirements::unlimited;
  const auto failed = [&](double stroke) {
    const StraightLineFamily family(task, {0.001, stroke, LineMeasure::tangent});
    const auto found = make_straight_line(family, family.point_of({1, {100, 35}}).value());
    EXPECT_TRUE(found && found->asks_stroke);
    return failures_of(found.value(), wanted);
  };
  EXPECT_TRUE(failed(0.2).empty());
  EXPECT_EQ(failed(1000), std::vector{RequirementKind::max_deviation})
      << "what does not reach the stroke is not listed";
  wanted.max_deviation = 0.01;
  EXPECT_TRUE(failed(0.2).empty());
  EXPECT_EQ(failed(1000), std::vector{RequirementKind::max_deviation});
}

TEST(StraightLineSolution, OfContactsAtPlacesIsDrivenThroughThem) {
  const MixedContacts contacts{{0, 0}, {{1, 2, -1}, {3, 2, -1}}, 0};
  const StraightLineFamily family({LineAtAngle({0, 4}, 0), contacts}, {});
  EXPECT_EQ(family.stroke(), (std::array{0.0, 2.0}));
  const auto found = make_straight_line(family, family.point_of({0, {1.1, 4.8}}).value());
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->defects.none());
  EXPECT_TRUE(found->verified_by_driving);
  ASSERT_TRUE(found->stroke);
  EXPECT_NEAR(found->stroke->max_deviation, 0.005727019601583699, 1e-9);
}

TEST(StraightLineSolution, IsNothingWhereTheMathematicsGivesNothing) {
  const StraightLineFamily family({LineAtAngle({0, 4}, 0), SixPoint{1}}, {});
  int none = 0;
  for (double v = -89; v < 90; v += 7)
    for (double u = -89; u < 90; u += 7) none += !make_straight_line(family, family.point_of({0, {u, v}}).value());
  EXPECT_GT(none, 10);
}

}  // namespace
}  // namespace linkwright
