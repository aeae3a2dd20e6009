#include "planar/instant_center.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

#include "linkwright/core/angle.hpp"
#include "linkwright/planar/burmester_curve.hpp"
#include "planar/three_pose_dyads.hpp"
#include "support/random_task.hpp"

namespace linkwright::instant_center_test {
namespace {

using testing::uniform;

InstantCenter random_center(std::mt19937_64& random, bool at_infinity) {
  return {{uniform(random, -2, 2), uniform(random, -2, 2)}, at_infinity};
}

// Working frame.
Homogeneous homogeneous(const InstantCenter& center, const WorkingFrame& frame) {
  return normalized(center.at_infinity ? Homogeneous::at_infinity(center.point)
                                       : frame.to_working(Homogeneous::of(center.point)));
}

TEST(InstantCenter, MakesAFirstPositionWithADirectionOfTravel) {
  std::mt19937_64 random(2);
  const auto poses = testing::random_poses(random, 3);
  for (const bool at_infinity : {false, true}) {
    const InstantCenter center = random_center(random, at_infinity);
    const auto task = with_instant_center(poses, center);
    EXPECT_EQ(pattern(task), "PP-P-P");
    const PoseDerivative& first = task[0].derivatives[0];
    EXPECT_EQ(first.angle, at_infinity ? 0 : 1);
    // The body's point at the centre is at rest; with the centre at infinity all move across its direction.
    if (at_infinity)
      EXPECT_NEAR(dot(first.origin, center.point), 0, 1e-14);
    else
      EXPECT_LT(std::abs(first.origin + Point{0, 1} * (center.point - poses[0].pose.origin)), 1e-14);
  }
}

TEST(InstantCenter, EverySideLinkPointsAtIt) {
  std::mt19937_64 random(4);
  for (int trial = 0; trial < 300; ++trial) {
    const InstantCenter center = random_center(random, trial % 4 == 0);
    const PoseConditions conditions = pose_conditions(with_instant_center(testing::random_poses(random, 3), center));
    const BurmesterCurve curve(conditions);
    const Homogeneous at = homogeneous(center, conditions.frame);
    for (const double tau : curve.samples(12, Spacing::coordinate)) {
      const Dyad dyad = curve.dyad(tau);
      EXPECT_NEAR(determinant(normalized(dyad.circle), normalized(dyad.center), at), 0, 1e-13);
    }
  }
}

// The other way: the lines through the centre, each with its two dyads in closed form, carry the same dyads.
TEST(InstantCenter, LinesThroughItCarryTheDyadsOfTheCurve) {
  std::mt19937_64 random(6);
  int on_lines = 0, on_curves = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const auto poses = testing::random_poses(random, 3);
    const InstantCenter center = random_center(random, trial % 4 == 0);
    const PoseConditions three = pose_conditions(poses), four = pose_conditions(with_instant_center(poses, center));
    const ThreePoseDyads dyads(three);
    const BurmesterCurve curve(four);
    const auto in_three = [&](Homogeneous p) { return three.frame.to_working(four.frame.to_user(p)); };
    const auto in_four = [&](Homogeneous p) { return four.frame.to_working(three.frame.to_user(p)); };

    const Point at = three.frame.to_working(center.point), e = direction(uniform(random, 0, pi));
    const Point aside = Point{0, 1} * center.point / std::abs(center.point);
    const DirectedLine line = center.at_infinity
                                  ? DirectedLine{uniform(random, -2, 2) * aside, center.point / std::abs(center.point)}
                                  : DirectedLine{at, e};
    const auto found = dyads.dyads_on_lines(line, line);
    ASSERT_TRUE(found);
    for (const Dyad& dyad : *found) {
      EXPECT_LT(curve.residual({in_four(dyad.center), in_four(dyad.circle), 0}), 1e-12);
      ++on_lines;
    }
    for (const double tau : curve.samples(8, Spacing::coordinate)) {
      const Dyad dyad = curve.dyad(tau);
      const auto circle = finite_point(in_three(dyad.circle)), fixed = finite_point(in_three(dyad.center));
      if (!circle || !fixed || std::abs(*circle - *fixed) < 1e-3) continue;
      double nearest = 1;
      const DirectedLine along{*fixed, (*circle - *fixed) / std::abs(*circle - *fixed)};
      const auto beside = dyads.dyads_on_lines(along, along);
      ASSERT_TRUE(beside);
      for (const Dyad& other : *beside)
        nearest = std::min(nearest, norm(cross(normalized(other.circle), normalized(in_three(dyad.circle)))));
      EXPECT_LT(nearest, 1e-6);
      ++on_curves;
    }
  }
  EXPECT_GT(on_lines, 150);
  EXPECT_GT(on_curves, 1500);
}

TEST(InstantCenter, NeitherUnitNorPlaceMatters) {
  std::mt19937_64 random(14);
  for (int trial = 0; trial < 50; ++trial) {
    const auto poses = testing::random_poses(random, 3);
    const InstantCenter center = random_center(random, trial % 2 == 0);
    const double scale = trial % 3 == 0 ? 1e-5 : 1e5, angle = uniform(random, -pi, pi);
    const Point shift = scale * Point{30, -20}, turn = scale * direction(angle);
    const InstantCenter other{center.at_infinity ? turn * center.point : turn * center.point + shift,
                              center.at_infinity};
    const PoseConditions here = pose_conditions(with_instant_center(poses, center));
    const PoseConditions there =
        pose_conditions(with_instant_center(testing::moved(poses, scale, angle, shift), other));
    EXPECT_NEAR(there.frame.scale / (scale * here.frame.scale), 1, 1e-12);
    EXPECT_NEAR(there.condition() / here.condition(), 1, 1e-9);
  }
}

}  // namespace
}  // namespace linkwright::instant_center_test
