#include "attitude/nearest_rotation.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

#include "linkwright/attitude/rotation_vector.hpp"
#include "support/attitude_case.hpp"
#include "support/random_task.hpp"

namespace linkwright::nearest_rotation_test {
namespace {

using testing::random_direction;
using testing::random_rotation;
using testing::ulp;
using testing::ulps_between;
using testing::uniform;

Matrix3x3 noise(std::mt19937_64& random, double size) {
  Matrix3x3 m;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) m(i, j) = uniform(random, -size, size);
  return m;
}

TEST(NearestRotation, OfARotationIsItself) {
  std::mt19937_64 random(1);
  for (int n = 0; n < 1000; ++n) {
    const Rotation rotation(random_rotation(random));
    const NearestRotation nearest = nearest_rotation(rotation.matrix()).value();
    EXPECT_LE(ulps_between(nearest.rotation, rotation), 8);
    EXPECT_LE(nearest.distance, 16 * ulp);
    EXPECT_TRUE(nearest.unique);
  }
}

TEST(NearestRotation, IsThePolarFactorOfAStretchedOne) {
  // A = R S with a symmetric positive S: the factor is R whatever the stretch.
  std::mt19937_64 random(2);
  for (const double scale : {1e-200, 1e-3, 1.0, 1e200})
    for (int n = 0; n < 250; ++n) {
      const Rotation rotation(random_rotation(random)), axes(random_rotation(random));
      const Matrix3x3 stretch{
          {{{uniform(random, 0.5, 2), 0, 0}, {0, uniform(random, 0.5, 2), 0}, {0, 0, uniform(random, 0.5, 2)}}}};
      const Matrix3x3 s = axes.matrix() * stretch * transposed(axes.matrix());
      const NearestRotation nearest = nearest_rotation(scale * (rotation.matrix() * s)).value();
      EXPECT_LE(ulps_between(nearest.rotation, rotation), 32);
      EXPECT_TRUE(nearest.unique);
    }
}

TEST(NearestRotation, NoOtherIsNearer) {
  std::mt19937_64 random(3);
  for (const double size : {1e-6, 1e-2, 1.0, 10.0})
    for (int n = 0; n < 50; ++n) {
      const Matrix3x3 noisy = random_rotation(random).matrix() + noise(random, size);
      const NearestRotation nearest = nearest_rotation(noisy).value();
      EXPECT_NEAR(nearest.distance, frobenius_norm(noisy - nearest.rotation.matrix()), 1e-15);
      for (const double step : {1e-4, 1e-1, 1.0, 3.0})
        for (int k = 0; k < 20; ++k) {
          const Rotation other =
              RotationVector::of(step * random_direction(random)).value().rotation() * nearest.rotation;
          EXPECT_GE(frobenius_norm(noisy - other.matrix()), nearest.distance - 1e-14 * (1 + size));
        }
    }
}

TEST(NearestRotation, DistanceIsThatOfTheNoiseAtMost) {
  std::mt19937_64 random(4);
  for (const double size : {1e-9, 1e-6, 1e-3}) {
    const Matrix3x3 clean = random_rotation(random).matrix(), error = noise(random, size);
    EXPECT_LE(nearest_rotation(clean + error).value().distance, frobenius_norm(error) + 8 * ulp);
  }
}

TEST(NearestRotation, OfAMirrorImageIsOneOfMany) {
  const NearestRotation nearest = nearest_rotation(-1.0 * Matrix3x3::identity()).value();
  EXPECT_FALSE(nearest.unique);
  EXPECT_NEAR(nearest.distance, 2, 1e-15) << "every half-turn is as near";
  EXPECT_FALSE(nearest_rotation({}).value().unique);
  EXPECT_FALSE(nearest_rotation(dyadic_product({1, 2, 3}, {3, 2, 1})).value().unique);
  EXPECT_TRUE(nearest_rotation({{{{3, 0, 0}, {0, 2, 0}, {0, 0, -1}}}}).value().unique);
}

TEST(NearestRotation, RefusesWhatIsNotANumber) {
  Matrix3x3 m = Matrix3x3::identity();
  m(1, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(nearest_rotation(m).errors().front().code, "not_finite");
}

}  // namespace
}  // namespace linkwright::nearest_rotation_test
