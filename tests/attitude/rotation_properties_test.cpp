#include "linkwright/attitude/rotation_properties.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

#include "linkwright/attitude/axis_angle.hpp"
#include "linkwright/core/angle.hpp"
#include "support/attitude_case.hpp"

namespace linkwright::rotation_properties_test {
namespace {

using testing::attitude_cases;
using testing::random_direction;
using testing::random_rotation;
using testing::ulp;
using testing::ulps_between;

TEST(RotationProperties, HoldForEveryRotation) {
  std::mt19937_64 random(1);
  for (int n = 0; n < 100'000; ++n) {
    const Matrix3x3 a = random_rotation(random).matrix();
    ASSERT_LE(orthogonality_error(a), 10 * ulp);
    ASSERT_LE(orthogonality_error(transposed(a)), 10 * ulp);
    ASSERT_LE(cofactor_error(a), 10 * ulp);
    ASSERT_NEAR(determinant(a), 1, 8 * ulp);
    ASSERT_TRUE(is_rotation(a));
  }
}

TEST(RotationProperties, FailForWhatIsNone) {
  const Matrix3x3 reflection{{{{0, 1, 0}, {1, 0, 0}, {0, 0, 1}}}};
  EXPECT_EQ(orthogonality_error(reflection), 0);
  EXPECT_DOUBLE_EQ(cofactor_error(reflection), 2 * std::sqrt(3)) << "each element is minus its cofactor";
  EXPECT_FALSE(is_rotation(reflection));
  EXPECT_EQ(cofactor_error({}), 0) << "the null matrix has the property, too";
  EXPECT_FALSE(is_rotation({}));
  Matrix3x3 off = Matrix3x3::identity();
  off(0, 1) = 1e-3;
  EXPECT_NEAR(orthogonality_error(off), std::sqrt(2) * 1e-3, 1e-9);
  EXPECT_FALSE(is_rotation(off));
  EXPECT_TRUE(is_rotation(off, 1e-2));
  off(2, 2) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(is_rotation(off, 1e-2));
}

TEST(RotationProperties, TraceIsOfTheAngle) {
  for (const auto& c : attitude_cases()) EXPECT_NEAR(cosine_by_trace(c.matrix), std::cos(c.angle), 2 * ulp) << c.name;
}

TEST(RotationProperties, AntisymmetricPartIsOfTheAxis) {
  for (const auto& c : attitude_cases()) {
    if (!c.axis) continue;
    EXPECT_LE(ulps_between(axial_vector(c.matrix), std::sin(c.angle) * *c.axis), 3) << c.name;
  }
}

TEST(RotationProperties, EigenvectorOfOneIsTheAxisOfTheTable) {
  for (const auto& c : attitude_cases()) {
    const EigenvalueOne one = eigenvalue_one(Rotation::from_matrix(c.matrix).value());
    EXPECT_LE(one.residual, 4 * ulp) << c.name;
    EXPECT_NEAR(one.determinant, 0, 8 * ulp) << c.name;
    EXPECT_EQ(one.axis_defined, c.axis.has_value()) << c.name;
    if (!c.axis) continue;
    // Nearer to a half-turn than the matrix can tell, the sign of the axis is the canonical one.
    const double sign = c.w < ulp && dot(one.axis, *c.axis) < 0 ? -1 : 1;
    EXPECT_LE(ulps_between(sign * one.axis, *c.axis), 8) << c.name;
  }
}

TEST(RotationProperties, EigenvectorIsTheAxisForEveryAngle) {
  // By another way than AxisAngle, so each checks the other.
  std::mt19937_64 random(2);
  for (double exponent = 0; exponent < 100; exponent += 0.25)
    for (const double angle : {std::pow(10, -exponent), pi - std::pow(10, -exponent)}) {
      const Vector3 axis = random_direction(random);
      const Rotation rotation = AxisAngle::of(axis, angle).value().rotation();
      const Vector3 found = eigenvalue_one(rotation).axis;
      const double sign = angle > 3.14 && dot(axis, found) < 0 ? -1 : 1;  // within rounding of a half-turn
      EXPECT_LE(ulps_between(found, sign * axis), 8) << angle;
    }
}

TEST(RotationProperties, IdentityHasNoAxis) {
  const EigenvalueOne one = eigenvalue_one({});
  EXPECT_FALSE(one.axis_defined);
  EXPECT_EQ(one.axis, (Vector3{0, 0, 1}));
  EXPECT_EQ(one.residual, 0);
}

}  // namespace
}  // namespace linkwright::rotation_properties_test
