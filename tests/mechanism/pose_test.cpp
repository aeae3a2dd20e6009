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

TEST(PrescribedOrientation, CountsItsDerivatives) {
  EXPECT_EQ((PrescribedOrientation{}).multiplicity(), 1);
  EXPECT_EQ((PrescribedOrientation{{}, {{1, 0, 0}, {0, 1, 0}}}).multiplicity(), 3);
  EXPECT_EQ(pattern(std::vector<PrescribedOrientation>{{{}, {{1, 0, 0}}}, {}, {}}), "PP-P-P");
}

TEST(PrescribedOrientation, AxesTurnWithTheBody) {
  const UnitQuaternion from = UnitQuaternion::about({1, 0, 0}, 0.4),
                       to = UnitQuaternion::about({0, 0, 1}, pi / 2) * from;
  EXPECT_LT(norm(turned({1, 0, 0}, from, to) - Vector3{0, 1, 0}), 1e-15);
  EXPECT_LT(norm(turned(turned({0.6, 0.8, 0}, from, to), to, from) - Vector3{0.6, 0.8, 0}), 1e-15);
}

TEST(BodyError, IsADistanceAndAnAngleModuloWholeTurns) {
  const Pose wanted{{1, 2}, 0.5};
  EXPECT_EQ(body_error(wanted, wanted), (BodyError{0, 0}));
  const BodyError off = body_error({{4, 6}, 0.5 - two_pi - 0.25}, wanted);
  EXPECT_DOUBLE_EQ(off.distance, 5);
  EXPECT_NEAR(off.angle, 0.25, 1e-14);
  EXPECT_NEAR(body_error({{1, 2}, 0.5 + pi}, wanted).angle, pi, 1e-14);
}

using Poses = std::vector<PrescribedPose>;

PrescribedPose with_derivatives(std::size_t count) { return {{}, std::vector<PoseDerivative>(count)}; }

TEST(Positions, PatternRepeatsPForEachDerivative) {
  EXPECT_EQ(pattern(Poses{{}, {}, {}, {}}), "P-P-P-P");
  EXPECT_EQ(pattern(Poses{with_derivatives(1), {}, {}}), "PP-P-P");
  EXPECT_EQ(pattern(Poses{{}, with_derivatives(2)}), "P-PPP");
  EXPECT_EQ(pattern(Poses{with_derivatives(3)}), "PPPP");
  EXPECT_EQ(pattern(Poses{}), "");
}

TEST(Positions, CountWithTheirMultiplicity) {
  EXPECT_EQ(position_count(Poses{}), 0);
  EXPECT_EQ(position_count(Poses{{}, {}, {}, {}}), 4);
  EXPECT_EQ(position_count(Poses{with_derivatives(1), {}, with_derivatives(1)}), 5);
}

}  // namespace
}  // namespace linkwright::pose_test
