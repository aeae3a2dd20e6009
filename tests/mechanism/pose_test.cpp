#include "linkwright/mechanism/pose.hpp"

#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"

namespace linkwright::pose_test {
namespace {

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

}  // namespace
}  // namespace linkwright::pose_test
