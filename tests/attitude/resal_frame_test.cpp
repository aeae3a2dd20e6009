#include "linkwright/attitude/resal_frame.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "linkwright/core/angle.hpp"
#include "support/attitude_case.hpp"

namespace linkwright::resal_frame_test {
namespace {

using testing::random_rotation;
using testing::ulps_between;

TEST(ResalFrame, IsTheBooksMatrixOfTwoTurns) {
  const double theta = 0.4, alpha = 1.2;
  const double ct = std::cos(theta), st = std::sin(theta), ca = std::cos(alpha), sa = std::sin(alpha);
  const Matrix3x3 printed{{{{ct, -st * ca, st * sa}, {st, ct * ca, -ct * sa}, {0, sa, ca}}}};
  EXPECT_LE(ulps_between(resal_frame(theta, alpha).matrix(), printed), 1);
}

TEST(ResalFrame, SharesTheBodysAxisAndDoesNotSpin) {
  std::mt19937_64 random(1);
  for (int n = 0; n < 1000; ++n) {
    const Rotation body(random_rotation(random));
    const ResalFrame resal = resal_frame(body);
    EXPECT_LE(ulps_between(resal.frame.matrix().column(2), body.matrix().column(2)), 8);
    EXPECT_NEAR(resal.frame.matrix()(2, 0), 0, 1e-15) << "its x axis is the line of nodes";
    EXPECT_LE(ulps_between(resal.frame * Rotation::about_z(resal.spin), body), 8);
  }
}

TEST(ResalFrame, StaysWhileTheBodySpins) {
  const Rotation at_rest = resal_frame(0.5, 1.0);
  for (double spin = -3; spin < 3; spin += 0.25) {
    const ResalFrame resal = resal_frame(at_rest * Rotation::about_z(spin));
    EXPECT_NEAR(resal.spin, spin, 1e-15);
    EXPECT_LE(ulps_between(resal.frame, at_rest), 8);
  }
}

TEST(ResalFrame, CountsAllAsPrecessionAtALock) {
  const ResalFrame resal = resal_frame(Rotation::about_z(0.7));
  EXPECT_EQ(resal.spin, 0);
  EXPECT_LE(ulps_between(resal.frame, Rotation::about_z(0.7)), 2);
}

}  // namespace
}  // namespace linkwright::resal_frame_test
