#include "linkwright/attitude/rotation.hpp"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <random>

#include "linkwright/attitude/axis_angle.hpp"
#include "linkwright/core/angle.hpp"
#include "support/attitude_case.hpp"

namespace linkwright::rotation_test {
namespace {

using testing::attitude_cases;
using ::testing::HasSubstr;
using testing::random_direction;
using testing::random_rotation;
using testing::ulps_between;

constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();

const Error& only_error(const Result<Rotation>& result) {
  EXPECT_EQ(result.errors().size(), 1U);
  return result.errors().front();
}

TEST(Rotation, IsTheIdentityToBeginWith) { EXPECT_EQ(Rotation().apply({1, 2, 3}), (Vector3{1, 2, 3})); }

TEST(Rotation, ColumnsAreTheAxesOfTheNewFrameInTheOld) {
  // Frame j: its x axis along y of i, its y axis against x of i.
  const Rotation c_ij = Rotation::about_z(pi / 2);
  EXPECT_LE(ulps_between(c_ij.apply({1, 0, 0}), {0, 1, 0}), 1);
  EXPECT_LE(ulps_between(c_ij.matrix().column(1), {-1, 0, 0}), 1);
  EXPECT_LE(ulps_between(c_ij.apply_inverse({0, 1, 0}), {1, 0, 0}), 1);
}

TEST(Rotation, AboutTheAxesAsTheBookPrintsThem) {
  const double t = 0.3, c = std::cos(t), s = std::sin(t);
  EXPECT_EQ(Rotation::about_z(t).matrix(), (Matrix3x3{{{{c, -s, 0}, {s, c, 0}, {0, 0, 1}}}}));
  EXPECT_EQ(Rotation::about_x(t).matrix(), (Matrix3x3{{{{1, 0, 0}, {0, c, -s}, {0, s, c}}}}));
  EXPECT_EQ(Rotation::about_y(t).matrix(), (Matrix3x3{{{{c, 0, s}, {0, 1, 0}, {-s, 0, c}}}}));
  for (const Axis axis : {Axis::x, Axis::y, Axis::z})
    EXPECT_LE(ulps_between(Rotation::about(axis, t), Rotation::about_axis(5 * unit_vector(axis), t).value()), 2);
}

TEST(Rotation, ProductsChain) {
  std::mt19937_64 random(1);
  for (int n = 0; n < 10'000; ++n) {
    const UnitQuaternion q_ij = random_rotation(random), q_jk = random_rotation(random);
    const Rotation c_ij(q_ij), c_jk(q_jk);
    const Vector3 r_k = random_direction(random);
    EXPECT_LE(ulps_between((c_ij * c_jk).apply(r_k), c_ij.apply(c_jk.apply(r_k))), 4);
    EXPECT_LE(ulps_between(c_ij * c_jk, Rotation(q_ij * q_jk)), 6);
    EXPECT_EQ(c_ij.inverse().apply(r_k), c_ij.apply_inverse(r_k));
  }
}

TEST(Rotation, OfTwoTriadsIsTheCosineOfEachPairOfAxes) {
  std::mt19937_64 random(2);
  for (int n = 0; n < 1000; ++n) {
    const Rotation c_0i(random_rotation(random)), c_0j(random_rotation(random));
    const Triad i{c_0i.matrix().column(0), c_0i.matrix().column(1), c_0i.matrix().column(2)};
    const Triad j{c_0j.matrix().column(0), c_0j.matrix().column(1), c_0j.matrix().column(2)};
    const Rotation c_ij = Rotation::from_triads(i, j).value();
    EXPECT_LE(ulps_between(c_ij, c_0i.inverse() * c_0j), 2);
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; b < 3; ++b) EXPECT_LE(ulps_between(c_ij.matrix()(a, b), dot(i[a], j[b])), 4);
  }
}

TEST(Rotation, OfTriadsNamesTheTriadThatIsNone) {
  const Triad right{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, left{{{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}},
      flat{{{1, 0, 0}, {0, 1, 0}, {1, 1, 0}}};
  EXPECT_EQ(only_error(Rotation::from_triads(left, right)).place, "axes_of_i");
  EXPECT_EQ(only_error(Rotation::from_triads(left, right)).code, "reflection");
  EXPECT_EQ(only_error(Rotation::from_triads(right, flat)).place, "axes_of_j");
  EXPECT_EQ(Rotation::from_triads(left, flat).errors().size(), 2U);
}

TEST(Rotation, TakesTheMatricesOfTheTableAsTheyAre) {
  for (const auto& c : attitude_cases())
    EXPECT_EQ(Rotation::from_matrix(c.matrix).value().matrix(), c.matrix) << c.name;
}

TEST(Rotation, TakesAMatrixOfFewDigitsToTheNearestRotation) {
  const Matrix3x3 printed{{{{0.866025, -0.5, 0}, {0.5, 0.866025, 0}, {0, 0, 1}}}};
  const Rotation rotation = Rotation::from_matrix(printed).value();
  EXPECT_LE(orthogonality_error(rotation.matrix()), 4 * testing::ulp);
  EXPECT_LE(frobenius_norm(rotation.matrix() - printed), 1e-6);
}

TEST(Rotation, RefusesWhatIsNotOrthogonalAndOffersTheNearest) {
  const Error error = only_error(Rotation::from_matrix({{{{1, 0, 0}, {0, 1, 0.1}, {0, 0, 1}}}}));
  EXPECT_EQ(error.code, "not_orthogonal");
  EXPECT_THAT(error.message, HasSubstr("by 0.142"));
  EXPECT_THAT(error.message, HasSubstr("nearest rotation, 0.0707 away, is [[1, 0, 0], [0, 0.998752339, 0.0499376169]"));
  EXPECT_THAT(error.message, ::testing::Not(HasSubstr("negative")));
  EXPECT_EQ(only_error(Rotation::from_matrix({})).code, "not_orthogonal") << "the null matrix";
  EXPECT_THAT(only_error(Rotation::from_matrix({})).message, HasSubstr("; a nearest rotation, 1.73 away"));
  EXPECT_THAT(only_error(Rotation::from_matrix({{{{1, 0, 0}, {0, 1, 0}, {0, 0, -2}}}})).message,
              HasSubstr("by 3, and its determinant is negative"));
  EXPECT_EQ(only_error(Rotation::from_matrix(2 * Matrix3x3::identity())).code, "not_orthogonal");
  EXPECT_EQ(only_error(Rotation::from_matrix(1e200 * Matrix3x3::identity())).code, "not_orthogonal");
}

TEST(Rotation, RefusesAReflectionAndOffersTheNearest) {
  const Error error = only_error(Rotation::from_matrix({{{{0, 1, 0}, {1, 0, 0}, {0, 0, 1}}}}));
  EXPECT_EQ(error.code, "reflection");
  EXPECT_THAT(error.message, HasSubstr("left-handed"));
  EXPECT_THAT(error.message, HasSubstr("2 away"));
}

TEST(Rotation, RefusesWhatIsNotANumber) {
  for (const double bad : {nan, infinity, -infinity})
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        Matrix3x3 m = Matrix3x3::identity();
        m(i, j) = bad;
        EXPECT_EQ(only_error(Rotation::from_matrix(m)).code, "not_finite");
      }
}

TEST(Rotation, AboutNoAxisIsRefused) {
  EXPECT_EQ(only_error(Rotation::about_axis({}, 1)).code, "zero_axis");
  EXPECT_EQ(only_error(Rotation::about_axis({nan, 0, 0}, 1)).code, "not_finite");
  EXPECT_EQ(only_error(Rotation::about_axis({1, 0, 0}, infinity)).code, "not_finite");
  EXPECT_TRUE(Rotation::about_axis({5e-324, 0, 0}, 1).ok());
}

TEST(Rotation, RenormalizedUndoesTheRoundingOfLongProducts) {
  std::mt19937_64 random(3);
  Rotation product;
  for (int n = 0; n < 100'000; ++n) product = product * Rotation(random_rotation(random));
  EXPECT_GT(orthogonality_error(product.matrix()), 10 * testing::ulp);
  EXPECT_LE(orthogonality_error(product.renormalized().matrix()), 8 * testing::ulp);
  EXPECT_LE(frobenius_norm(product.renormalized().matrix() - product.matrix()), orthogonality_error(product.matrix()));
}

TEST(Rotation, AngleBetweenTwoAttitudes) {
  std::mt19937_64 random(4);
  const Rotation a(random_rotation(random));
  for (const double angle : {0.0, 1e-6, 1.0, pi})
    EXPECT_NEAR(angle_between(a, a * Rotation::about_y(angle)), angle, 8 * testing::ulp);
}

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
}  // namespace linkwright::rotation_test
