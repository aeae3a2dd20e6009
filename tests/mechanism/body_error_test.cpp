#include "linkwright/mechanism/body_error.hpp"

#include <gtest/gtest.h>

namespace linkwright::body_error_test {
namespace {

TEST(BodyError, IsADistanceAndAnAngleModuloWholeTurns) {
  const Pose wanted{{1, 2}, 0.5};
  EXPECT_EQ(body_error(wanted, wanted), (BodyError{0, 0}));
  const BodyError off = body_error({{4, 6}, 0.5 - two_pi - 0.25}, wanted);
  EXPECT_DOUBLE_EQ(off.distance, 5);
  EXPECT_NEAR(off.angle, 0.25, 1e-14);
  EXPECT_NEAR(body_error({{1, 2}, 0.5 + pi}, wanted).angle, pi, 1e-14);
}

}  // namespace
}  // namespace linkwright::body_error_test
