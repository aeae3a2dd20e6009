#include "linkwright/mechanism/pose.hpp"

#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"

namespace linkwright::pose_test {
namespace {

PrescribedPose with_derivatives(std::size_t count) { return {{}, std::vector<PoseDerivative>(count)}; }

TEST(Pose, DisplacesItsOriginToTheOtherOrigin) {
  const Pose from{{1, 2}, 0.3}, to{{-4, 5}, 2};
  EXPECT_EQ(displaced(from.origin, from, to), to.origin);
}

TEST(Pose, DisplacementTurnsAboutTheOrigin) {
  const Pose from{{1, 0}, 0}, to{{1, 0}, pi / 2};
  EXPECT_NEAR(std::abs(displaced({3, 0}, from, to) - Point{1, 2}), 0, 1e-15);
}

TEST(Pose, DisplacementsFollowOneAnother) {
  const Pose first{{1, 2}, 0.3}, second{{-4, 5}, 2}, third{{0.5, -1}, -3};
  const Point p{0.7, -0.6};
  EXPECT_NEAR(std::abs(displaced(displaced(p, first, second), second, third) - displaced(p, first, third)), 0, 1e-14);
  EXPECT_NEAR(std::abs(displaced(displaced(p, first, second), second, first) - p), 0, 1e-14);
}

TEST(Pose, PatternRepeatsPForEachDerivative) {
  EXPECT_EQ(pattern({{}, {}, {}, {}}), "P-P-P-P");
  EXPECT_EQ(pattern({with_derivatives(1), {}, {}}), "PP-P-P");
  EXPECT_EQ(pattern({{}, with_derivatives(2)}), "P-PPP");
  EXPECT_EQ(pattern({with_derivatives(3)}), "PPPP");
  EXPECT_EQ(pattern({}), "");
}

TEST(Pose, PositionsCountWithTheirMultiplicity) {
  EXPECT_EQ(position_count({}), 0);
  EXPECT_EQ(position_count({{}, {}, {}, {}}), 4);
  EXPECT_EQ(position_count({with_derivatives(1), {}, with_derivatives(1)}), 5);
}

}  // namespace
}  // namespace linkwright::pose_test
