#include "linkwright/attitude/rodrigues.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

#include "linkwright/attitude/axis_angle.hpp"
#include "linkwright/core/angle.hpp"
#include "support/attitude_case.hpp"

namespace linkwright::rodrigues_test {
namespace {

using testing::attitude_cases;
using testing::random_direction;
using testing::random_rotation;
using testing::ulp;
using testing::ulps_between;

constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();

TEST(RodriguesVector, IsThatOfTheTable) {
  for (const auto& c : attitude_cases()) {
    const auto g = RodriguesVector::of(c.input);
    ASSERT_EQ(g.has_value(), c.rodrigues.has_value()) << c.name;
    if (!g) continue;
    EXPECT_LE(norm(g->vector() - *c.rodrigues), 4 * ulp * norm(*c.rodrigues)) << c.name;
    EXPECT_LE(ulps_between(g->rotation().matrix(), c.matrix), 6) << c.name;
  }
}

TEST(RodriguesVector, OfAHalfTurnIsNone) {
  EXPECT_FALSE(RodriguesVector::of(*UnitQuaternion::of(0, {1, 2, 3})).has_value());
  EXPECT_FALSE(RodriguesVector::of(*UnitQuaternion::of(1e-320, {1, 2, 3})).has_value()) << "it overflows";
  EXPECT_TRUE(RodriguesVector::of(*UnitQuaternion::of(1e-300, {1, 2, 3})).has_value());
}

TEST(RodriguesVector, OfAnySizeIsARotation) {
  for (const double size : {0.0, 1e-320, 1e-160, 1.0, 1e16, 1e160, 1e308}) {
    const RodriguesVector g = RodriguesVector::of({0, size, 0}).value();
    EXPECT_LE(ulps_between(g.quaternion(), AxisAngle::of({0, 1, 0}, 2 * std::atan(size)).value().quaternion()), 2)
        << size;
  }
}

TEST(RodriguesVector, ComposesByItsOwnLaw) {
  // g″ = (g + g′ + g × g′) / (1 − g·g′) of the turn g′ after g about axes carried along.
  std::mt19937_64 random(1);
  for (int n = 0; n < 1000; ++n) {
    const Vector3 a = 0.4 * random_direction(random), b = 0.4 * random_direction(random);
    const auto product =
        RodriguesVector::of(RodriguesVector::of(a)->quaternion() * RodriguesVector::of(b)->quaternion());
    EXPECT_LE(ulps_between(product.value().vector(), (a + b + cross(a, b)) / (1 - dot(a, b))), 8);
  }
}

TEST(RodriguesVector, RefusesWhatIsNotANumber) {
  EXPECT_EQ(RodriguesVector::of({0, nan, 0}).errors().front().code, "not_finite");
  EXPECT_EQ(RodriguesVector::of({0, 0, -infinity}).errors().front().place, "rodrigues");
}

TEST(ModifiedRodriguesVector, IsThatOfTheTable) {
  for (const auto& c : attitude_cases()) {
    const auto m = ModifiedRodriguesVector::of(c.input);
    EXPECT_LE(norm(m.vector() - c.mrp), 4 * ulp * norm(c.mrp)) << c.name;
    EXPECT_LE(ulps_between(m.rotation().matrix(), c.matrix), 6) << c.name;
  }
}

TEST(ModifiedRodriguesVector, IsWithinTheUnitSphere) {
  std::mt19937_64 random(2);
  for (int n = 0; n < 10'000; ++n)
    EXPECT_LE(norm(ModifiedRodriguesVector::of(random_rotation(random)).vector()), 1 + 2 * ulp);
}

TEST(ModifiedRodriguesVector, ShadowIsTheSameRotation) {
  std::mt19937_64 random(3);
  for (int n = 0; n < 10'000; ++n) {
    const auto m = ModifiedRodriguesVector::of(random_rotation(random));
    const auto shadow = m.shadow().value();
    EXPECT_GE(norm(shadow.vector()), 1 - 2 * ulp);
    EXPECT_LE(ulps_between(shadow.rotation(), m.rotation()), 8);
    EXPECT_LE(ulps_between(shadow.shadow()->vector(), m.vector()), 4);
  }
  EXPECT_FALSE(ModifiedRodriguesVector().shadow().has_value()) << "at infinity";
  EXPECT_FALSE(ModifiedRodriguesVector::of({1e-310, 0, 0})->shadow().has_value());
}

TEST(ModifiedRodriguesVector, OfAnySizeIsARotation) {
  for (const double size : {0.0, 1e-320, 1e-160, 0.3, 1.0, 1.5, 1e16, 1e160, 1e308}) {
    const auto m = ModifiedRodriguesVector::of({0, 0, size}).value();
    EXPECT_LE(ulps_between(m.quaternion(), AxisAngle::of({0, 0, 1}, 4 * std::atan(size)).value().quaternion()), 4)
        << size;
  }
}

TEST(ModifiedRodriguesVector, RefusesWhatIsNotANumber) {
  EXPECT_EQ(ModifiedRodriguesVector::of({infinity, 0, 0}).errors().front().code, "not_finite");
}

}  // namespace
}  // namespace linkwright::rodrigues_test
