#include "linkwright/mechanism/prescribed_orientation.hpp"

#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"

namespace linkwright::prescribed_orientation_test {
namespace {

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

}  // namespace
}  // namespace linkwright::prescribed_orientation_test
