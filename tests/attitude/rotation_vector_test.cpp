#include "linkwright/attitude/rotation_vector.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

#include "linkwright/core/angle.hpp"
#include "support/attitude_case.hpp"

namespace linkwright::rotation_vector_test {
namespace {

using testing::attitude_cases;
using testing::random_direction;
using testing::ulp;
using testing::ulps_between;

RotationVector make(Vector3 phi) { return RotationVector::of(phi).value(); }

TEST(RotationVector, IsThatOfTheTable) {
  for (const auto& c : attitude_cases()) {
    const Vector3 phi = c.angle * c.axis.value_or(Vector3{});
    EXPECT_LE(norm(RotationVector::of(c.input).vector() - phi), 4 * ulp * norm(phi)) << c.name;
    EXPECT_LE(ulps_between(make(phi).rotation().matrix(), c.matrix), 6) << c.name;
  }
}

TEST(RotationVector, LogarithmUndoesTheExponentialRelatively) {
  std::mt19937_64 random(1);
  for (double size = 3.14; size > 1e-320; size *= 0.7) {
    const Vector3 phi = size * random_direction(random);
    const Vector3 found = RotationVector::of(make(phi).quaternion()).vector();
    EXPECT_LE(norm(found - phi), 6 * ulp * size + 2e-323) << size;
    EXPECT_LE(norm(RotationVector::of(make(phi).rotation()).vector() - phi), 8 * ulp * size + 2e-323) << size;
  }
}

TEST(RotationVector, SeriesAndFunctionMeet) {
  // Both sides of the size where one takes over from the other.
  for (double size = 0.5e-4; size < 4e-4; size *= 1.001) {
    const UnitQuaternion q = make({0, 0, size}).quaternion();
    EXPECT_NEAR(q.v().z, std::sin(size / 2), 2 * ulp * size);
    EXPECT_NEAR(RotationVector::of(q).vector().z, size, 4 * ulp * size);
  }
}

TEST(RotationVector, IsTheExponentialSeriesOfItsSkewMatrix) {
  std::mt19937_64 random(2);
  for (const double size : {0.1, 1.0, 3.0}) {
    const Vector3 phi = size * random_direction(random);
    Matrix3x3 sum = Matrix3x3::identity(), term = sum;
    for (int n = 1; n < 40; ++n) sum = sum + (term = 1.0 / n * (term * skew_matrix(phi)));
    EXPECT_LE(ulps_between(make(phi).rotation().matrix(), sum), 32);
  }
}

TEST(RotationVector, SmallOnesAddUpToTheSecondOrder) {
  const Vector3 a{1, 2, 3}, b{-2, 1, 4};
  for (const double size : {1e-2, 1e-4, 1e-6}) {
    const Vector3 product = RotationVector::of(make(size * a).quaternion() * make(size * b).quaternion()).vector();
    EXPECT_LE(norm(product - size * (a + b)), 8 * size * size);
    EXPECT_LE(norm(product - size * (a + b) - size * size / 2 * cross(a, b)), 40 * size * size * size)
        << "Baker, Campbell, Hausdorff";
  }
}

TEST(RotationVector, MayRunThroughManyTurns) {
  EXPECT_NEAR(RotationVector::of(make({0, 2 * two_pi + 0.5, 0}).rotation()).vector().y, 0.5, 32 * ulp);
  EXPECT_NEAR(RotationVector::of(make({0, pi + 0.5, 0}).rotation()).vector().y, 0.5 - pi, 8 * ulp);
}

TEST(RotationVector, RefusesWhatIsNotANumber) {
  for (const double bad : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    EXPECT_EQ(RotationVector::of({0, bad, 0}).errors().front().code, "not_finite");
  EXPECT_EQ(RotationVector::of({1.7e308, 1.7e308, 0}).errors().front().code, "not_finite") << "its length overflows";
  EXPECT_TRUE(RotationVector::of({1.7e308, 0, 0}).ok());
}

}  // namespace
}  // namespace linkwright::rotation_vector_test
