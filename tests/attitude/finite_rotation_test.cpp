#include "attitude/finite_rotation.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "linkwright/attitude/rotation.hpp"
#include "linkwright/core/angle.hpp"
#include "support/attitude_case.hpp"
#include "support/random_task.hpp"

namespace linkwright::finite_rotation_test {
namespace {

using testing::attitude_cases;
using testing::random_direction;
using testing::ulp;
using testing::ulps_between;
using testing::uniform;

FiniteRotation tensor(Vector3 axis, double angle) { return FiniteRotation(AxisAngle::of(axis, angle).value()); }

TEST(FiniteRotation, IsTheMatrixOfTheTable) {
  for (const auto& c : attitude_cases()) {
    if (!c.axis) continue;
    EXPECT_LE(ulps_between(tensor(*c.axis, c.angle).matrix(), c.matrix), 4) << c.name;
  }
}

TEST(FiniteRotation, IsOneTensorInFourForms) {
  std::mt19937_64 random(1);
  for (int n = 0; n < 10'000; ++n) {
    const FiniteRotation a = tensor(random_direction(random), uniform(random, -7, 7));
    const Vector3 a0 = random_direction(random);
    EXPECT_LE(ulps_between(a.apply(a0), a.matrix() * a0), 4);
    EXPECT_LE(ulps_between(a.apply(a0), dot(a.dyadic(), a0)), 4);
    EXPECT_LE(ulps_between(a.dyadic().matrix(), a.matrix()), 3);
    EXPECT_LE(ulps_between(a.matrix(), a.turn().rotation().matrix()), 6);
    EXPECT_LE(ulps_between(Matrix3x3::identity() + a.matrix_minus_identity(), a.matrix()), 6);
  }
}

TEST(FiniteRotation, TurnsAboutACone) {
  // The angle with the axis stays, the angle about the axis grows by θ.
  const Vector3 p{0, 0, 1}, a0{1, 0, 2};
  const Vector3 a = tensor(p, 0.7).apply(a0);
  EXPECT_DOUBLE_EQ(a.z, a0.z);
  EXPECT_DOUBLE_EQ(std::atan2(a.y, a.x), 0.7);
  EXPECT_DOUBLE_EQ(norm(a), norm(a0));
}

TEST(FiniteRotation, HasTheAxisInBothFrames) {
  std::mt19937_64 random(2);
  for (int n = 0; n < 1000; ++n) {
    const FiniteRotation a = tensor(random_direction(random), uniform(random, -7, 7));
    EXPECT_LE(ulps_between(a.apply(a.turn().axis()), a.turn().axis()), 4);
    EXPECT_LE(ulps_between(a.turn().axis() * a.matrix(), a.turn().axis()), 4);
    EXPECT_LE(orthogonality_error(a.matrix()), 12 * ulp);
  }
}

TEST(FiniteRotation, InverseIsTheConjugate) {
  const FiniteRotation a = tensor({1, -2, 3}, 2);
  EXPECT_LE(ulps_between(a.inverse().matrix(), transposed(a.matrix())), 1);
  EXPECT_LE(ulps_between(a.inverse().dyadic().matrix(), a.dyadic().conjugate().matrix()), 1);
}

TEST(FiniteRotation, MinusIdentityKeepsItsDigitsForSmallTurns) {
  // To the second order A − E = θ [p]× + ½ θ² [p]×².
  std::mt19937_64 random(3);
  for (double angle = 1e-9; angle > 1e-150; angle *= 1e-3) {
    const Vector3 p = random_direction(random);
    const Matrix3x3 exact = angle * skew_matrix(p) + angle * angle / 2 * (skew_matrix(p) * skew_matrix(p));
    const Matrix3x3 difference = tensor(p, angle).matrix_minus_identity();
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        EXPECT_NEAR(difference(i, j), exact(i, j), 1e-15 * angle * (i == j ? angle : 1)) << angle;
  }
}

TEST(FiniteRotation, SecondOrderKeepsItsDigitsInTheMatrix) {
  // Off the diagonal, with p in the plane of x and y, (1 − cos θ) p₁ p₂ stands alone.
  const double angle = 1e-7, half = std::sin(angle / 2);
  const FiniteRotation a = tensor({1, 1, 0}, angle);
  EXPECT_NEAR(a.matrix()(0, 1), half * half, 4 * ulp * half * half);
  EXPECT_NEAR(a.dyadic().matrix()(0, 1), half * half, 4 * ulp * half * half);
}

}  // namespace
}  // namespace linkwright::finite_rotation_test
