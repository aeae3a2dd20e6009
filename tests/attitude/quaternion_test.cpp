#include "linkwright/attitude/quaternion.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

#include "support/attitude_case.hpp"

namespace linkwright::quaternion_test {
namespace {

using testing::attitude_cases;
using testing::random_direction;
using testing::random_rotation;
using testing::ulp;
using testing::ulps_between;

UnitQuaternion make(double w, Vector3 v) { return UnitQuaternion::of(w, v).value(); }

TEST(UnitQuaternion, IsThatOfTheTable) {
  for (const auto& c : attitude_cases()) {
    const UnitQuaternion q = c.input.canonical();
    EXPECT_LE(ulps_between(q.w(), c.w), 2) << c.name;
    EXPECT_LE(ulps_between(q.v(), c.v), 2) << c.name;
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(q.v()[i], c.v[i], 3 * ulp * std::abs(c.v[i])) << c.name;
    EXPECT_LE(ulps_between(q.matrix(), c.matrix), 4) << c.name;
  }
}

TEST(UnitQuaternion, OfTheMatricesOfTheTable) {
  for (const auto& c : attitude_cases()) {
    const UnitQuaternion q = UnitQuaternion::of_matrix(c.matrix);
    EXPECT_LE(ulps_between(q, c.input), 4) << c.name;
    EXPECT_GE(q.w(), 0) << c.name;
  }
}

TEST(UnitQuaternion, TakesAnyLengthAndRefusesNone) {
  for (const double scale : {1.0, -1.0, 1e-300, 5e-324, 1e154, 1e308}) {
    const UnitQuaternion q = make(scale, {0, scale, 0});
    EXPECT_NEAR(std::abs(q.w()), std::sqrt(0.5), 2 * ulp) << scale;
    EXPECT_LE(ulps_between(q, make(1, {0, 1, 0})), 2) << scale;
  }
  EXPECT_EQ(UnitQuaternion::of(0, {}).errors().front().code, "zero_quaternion");
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(UnitQuaternion::of(nan, {1, 0, 0}).errors().front().code, "not_finite");
  EXPECT_EQ(UnitQuaternion::of(1, {1, -infinity, 0}).errors().front().code, "not_finite");
}

/// What a file carries reads back as what it was.
TEST(UnitQuaternion, OfUnitComponentsHasJustThem) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> component;
  for (int i = 0; i < 1000; ++i) {
    const UnitQuaternion q = make(component(random), {component(random), component(random), component(random)});
    const UnitQuaternion again = make(q.w(), q.v());
    EXPECT_EQ(again.w(), q.w());
    EXPECT_EQ(again.v(), q.v());
  }
}

TEST(UnitQuaternion, AndItsOppositeAreEqual) {
  EXPECT_EQ(make(1, {2, 3, 4}), make(-1, {-2, -3, -4}));
  EXPECT_EQ(-make(1, {2, 3, 4}), make(1, {2, 3, 4}));
  EXPECT_LT((-make(1, {2, 3, 4})).w(), 0);
  EXPECT_FALSE(make(1, {2, 3, 4}) == make(1, {-2, -3, -4}));
}

TEST(UnitQuaternion, CanonicalHasItsFirstComponentPositive) {
  EXPECT_GT(make(-1, {2, 3, 4}).canonical().w(), 0);
  EXPECT_GT(make(0, {-2, 3, 4}).canonical().v().x, 0);
  EXPECT_GT(make(0, {0, -3, 4}).canonical().v().y, 0);
  EXPECT_GT(make(0, {0, 0, -4}).canonical().v().z, 0);
}

TEST(UnitQuaternion, ProductIsHamiltons) {
  const UnitQuaternion i = make(0, {1, 0, 0}), j = make(0, {0, 1, 0}), k = make(0, {0, 0, 1});
  const auto same = [](const UnitQuaternion& a, const UnitQuaternion& b) { return a.w() == b.w() && a.v() == b.v(); };
  EXPECT_TRUE(same(i * j, k));
  EXPECT_TRUE(same(j * k, i));
  EXPECT_TRUE(same(k * i, j));
  EXPECT_TRUE(same(i * i, make(-1, {})));
}

TEST(UnitQuaternion, ProductStaysUnitThroughAMillionFactors) {
  std::mt19937_64 random(1);
  UnitQuaternion product;
  for (int n = 0; n < 1'000'000; ++n) product = product * random_rotation(random);
  EXPECT_NEAR(product.w() * product.w() + dot(product.v(), product.v()), 1, 2 * ulp);
}

TEST(UnitQuaternion, AppliesAsItsMatrixDoes) {
  std::mt19937_64 random(2);
  for (int n = 0; n < 10'000; ++n) {
    const UnitQuaternion q = random_rotation(random);
    const Vector3 r = random_direction(random);
    EXPECT_LE(ulps_between(q.apply(r), q.matrix() * r), 6);
  }
}

TEST(UnitQuaternion, MatrixMinusIdentityIsRelativelyExact) {
  // A − E = sin θ [p]× + (1 − cos θ)[p]×²; about z by θ: ∓sin θ off the diagonal, −2 sin² θ/2 on it.
  for (double angle = 1; angle > 1e-150; angle *= 1e-7) {
    const Matrix3x3 d = make(std::cos(angle / 2), {0, 0, std::sin(angle / 2)}).matrix_minus_identity();
    const double half = std::sin(angle / 2);
    EXPECT_NEAR(d(1, 0), std::sin(angle), 4 * ulp * angle);
    EXPECT_NEAR(d(0, 0), -2 * half * half, 4 * ulp * angle * angle);
    EXPECT_EQ(d(2, 2), 0);
  }
}

TEST(UnitQuaternion, AngleBetweenIsExactNearNothing) {
  const UnitQuaternion a = make(1, {2, 3, 4});
  for (const double angle : {1e-8, 0.1, 3.0}) {
    const UnitQuaternion turn = make(std::cos(angle / 2), {0, std::sin(angle / 2), 0});
    EXPECT_NEAR(angle_between(a, a * turn), angle, 4 * ulp);
    EXPECT_NEAR(angle_between(a, make(-1, {-2, -3, -4}) * turn), angle, 4 * ulp) << "q and −q";
  }
}

TEST(UnitQuaternion, AboutAnAxisIsThatOfItsComponents) {
  const Vector3 p{2.0 / 3, -1.0 / 3, 2.0 / 3};
  for (const double angle : {0.0, 1e-12, 0.3, 3.0, -2.0, 7.0}) {
    const auto q = UnitQuaternion::of(std::cos(angle / 2), std::sin(angle / 2) * p);
    EXPECT_LE(angle_between(UnitQuaternion::about(p, angle), q.value()), 2 * ulp) << angle;
  }
  EXPECT_DEATH(static_cast<void>(UnitQuaternion::about(p, std::nan(""))), "an angle is a number");
}

const UnitQuaternion quarter = UnitQuaternion::about({0, 0, 1}, 1.5);

TEST(GivenOrientation, IsTheRotationInWhateverForm) {
  const GivenOrientation given(quarter, R"("axis": [0,0,1], "angle_deg": 90)");
  EXPECT_EQ(given, GivenOrientation(quarter));
  EXPECT_EQ(given.apply({1, 0, 0}), quarter.apply({1, 0, 0}));
  EXPECT_FALSE(given == GivenOrientation());
}

TEST(GivenOrientation, AnotherRotationForgetsTheForm) {
  GivenOrientation given(quarter, R"("quaternion": [1,0,0,1])");
  given = quarter.inverse();
  EXPECT_EQ(given, quarter.inverse());
  EXPECT_TRUE(given.form().empty());
}

}  // namespace
}  // namespace linkwright::quaternion_test
