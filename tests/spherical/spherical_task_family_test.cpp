#include "linkwright/spherical/spherical_task_family.hpp"

#include <gtest/gtest.h>
#include <random>

#include "support/attitude_case.hpp"
#include "support/spherical_case.hpp"

namespace linkwright::spherical_task_family_test {
namespace {

TEST(SphericalTaskFamily, FourOrientationsLeaveACurve) {
  const SphericalTaskFamily given =
      task_family(SphericalMotionTask{testing::spherical_case("wrist-orthosis-4").orientations, {}});
  EXPECT_EQ(given.pattern, "P-P-P-P");
  ASSERT_TRUE(given.curve && given.family);
  EXPECT_EQ(given.curve->branches().size(), 2u);
  EXPECT_FALSE(given.has_directions);
  EXPECT_TRUE(given.warnings.empty());
}

TEST(SphericalTaskFamily, DegenerateTasksHaveNone) {
  for (const char* name : {"nasty-one-axis-4", "nasty-repeated-orientation-4"}) {
    const SphericalTaskFamily given = task_family(SphericalMotionTask{testing::spherical_case(name).orientations, {}});
    EXPECT_TRUE(given.degeneracy) << name;
    EXPECT_FALSE(given.family) << name;
  }
}

TEST(SphericalTaskFamily, ThreeOrientationsAndGivenAxesHaveOneLinkage) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 100; ++i) {
    const auto orientations = testing::random_orientations(random, 3);
    for (const auto kind : {GivenAxes::Kind::fixed, GivenAxes::Kind::moving}) {
      const GivenAxes axes{kind, {testing::random_direction(random), 3 * testing::random_direction(random)}};
      const SphericalTaskFamily given = task_family(SphericalMotionTask{orientations, axes});
      ASSERT_EQ(given.points.size(), 2u);
      for (std::size_t side = 0; side < 2; ++side) {
        const SphericalDyad& dyad = given.points[side].dyad;
        const Vector3 asked = kind == GivenAxes::Kind::fixed ? dyad.fixed_axis : dyad.moving_axis;
        EXPECT_LT(norm(asked - normalized(axes.axes[side])), 1e-15);
        EXPECT_LT(residual_of(dyad.fixed_axis, dyad.moving_axis, given.conditions.rows), 1e-13);
        EXPECT_GE(dot(dyad.fixed_axis, dyad.moving_axis), 0);
      }
      EXPECT_TRUE(given.family->dyad_pair({0.5, 1.5}));
    }
  }
}

TEST(SphericalTaskFamily, FiveOrientationsHaveAFewDyads) {
  const SphericalTaskFamily given =
      task_family(SphericalMotionTask{testing::spherical_case("folding-wing-5").orientations, {}});
  EXPECT_EQ(given.pattern, "P-P-P-P-P");
  EXPECT_FALSE(given.curve);
  ASSERT_TRUE(given.family || given.has_no_dyads);
  EXPECT_EQ(given.family != nullptr, given.points.size() >= 2);
}

TEST(SphericalTaskFamily, DerivativesHaveRowsOfTheirOwn) {
  std::mt19937_64 random(2);
  auto orientations = testing::random_orientations(random, 3);
  orientations[1].derivatives = {testing::random_direction(random)};
  const SphericalTaskFamily given = task_family(SphericalMotionTask{orientations, {}});
  EXPECT_EQ(given.pattern, "P-PP-P");
  ASSERT_EQ(given.derivative_rows.size(), 1u);
  EXPECT_EQ(given.derivative_rows[0], given.conditions.rows[1]);
  EXPECT_TRUE(given.has_directions);
}

TEST(SphericalTaskFamily, LinksHaveALeastAngleUnlessAskedOtherwise) {
  EXPECT_EQ(with_default_angles({}).min_link_angle, default_min_link_angle);
  Requirements any;
  any.min_link_angle = 0;
  EXPECT_EQ(with_default_angles(any).min_link_angle, 0);
}

}  // namespace
}  // namespace linkwright::spherical_task_family_test
