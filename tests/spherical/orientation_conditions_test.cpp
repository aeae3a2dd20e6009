#include "linkwright/spherical/orientation_conditions.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "algebra/dense.hpp"
#include "linkwright/attitude/rotation_vector.hpp"
#include "support/attitude_case.hpp"
#include "support/central_difference.hpp"
#include "support/spherical_case.hpp"

namespace linkwright::orientation_conditions_test {
namespace {

using testing::random_direction, testing::random_orientations;

CubicForm largest_one(CubicForm form) {
  double largest = 0;
  for (const double c : form.coefficient)
    if (std::abs(c) > std::abs(largest)) largest = c;
  for (double& c : form.coefficient) c /= largest;
  return form;
}

TEST(OrientationConditions, ConeIsThatOfTheCases) {
  for (const auto& c : testing::four_orientation_cases()) {
    if (!c.content["output"]["cubic_W"].contains("coefficients")) continue;
    const CubicForm ours = largest_one(moving_axis_form(orientation_conditions(c.orientations)));
    const auto& theirs = c.content["output"]["cubic_W"]["coefficients"];
    for (std::size_t k = 0; k < 10; ++k)
      EXPECT_NEAR(ours.coefficient[k], theirs[k].get<double>(), c.name == "nasty-small-1e-6-4" ? 1e-9 : 1e-12)
          << c.name << " " << k;
  }
}

TEST(OrientationConditions, ConeOfFiniteTurnsIsTheirDeterminant) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 100; ++i) {
    const auto conditions = orientation_conditions(random_orientations(random, 4));
    const CubicForm closed = largest_one(moving_axis_form(conditions)),
                    expanded =
                        largest_one(determinant_form({conditions.rows[0], conditions.rows[1], conditions.rows[2]}));
    for (std::size_t k = 0; k < 10; ++k) EXPECT_NEAR(closed.coefficient[k], expanded.coefficient[k], 1e-11);
  }
}

// The cone of turns by ε about given axes tends to one cone, which the determinant has lost long before 1e-6.
TEST(OrientationConditions, SmallTurnsKeepTheirCone) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 20; ++i) {
    const std::array axes = {random_direction(random), random_direction(random), random_direction(random)};
    const auto form_of = [&](double turn) {
      std::vector<UnitQuaternion> turns;
      for (std::size_t k = 0; k < 3; ++k)
        turns.push_back(RotationVector::of((1 + 0.5 * static_cast<double>(k)) * turn * axes[k])->quaternion());
      return largest_one(moving_axis_form(conditions_of_turns(turns)));
    };
    const CubicForm limit = form_of(1e-9), small = form_of(1e-6);
    for (std::size_t k = 0; k < 10; ++k) EXPECT_NEAR(small.coefficient[k], limit.coefficient[k], 1e-4);
    EXPECT_GT(small.largest_coefficient(), 0);
  }
}

TEST(OrientationConditions, PolesAreOnTheCone) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 50; ++i) {
    const auto conditions = orientation_conditions(random_orientations(random, 4));
    const CubicForm form = largest_one(moving_axis_form(conditions));
    ASSERT_EQ(conditions.poles.size(), 3u);
    for (const Vector3 pole : conditions.poles) EXPECT_LT(std::abs(form(pole)), 1e-13);
  }
}

// The derivatives of a body that turns on a curve in attitude are the limits of finite turns.
TEST(OrientationConditions, DerivativesAreThoseOfTheMatrix) {
  const auto attitude = [](double t) {
    return UnitQuaternion::about(normalized(Vector3{1, 2, -1}), 0.3 + 0.9 * t + 0.2 * t * t) *
           UnitQuaternion::about(normalized(Vector3{0.3, -1, 0.7}), 0.5 * t - 0.4 * t * t * t);
  };
  const auto rate = [&](double t) {
    const auto matrix = [&](double at) { return attitude(at).matrix(); };
    return axial_vector(testing::first_difference(matrix, t, 1e-3) * transposed(attitude(t).matrix()));
  };
  const Vector3 omega = rate(0), alpha = testing::first_difference(rate, 0, 1e-2),
                jerk = testing::second_difference(rate, 0, 2e-2);
  const std::vector<PrescribedOrientation> asked = {{attitude(-0.5), {}}, {attitude(0), {omega, alpha, jerk}}};
  const auto conditions = orientation_conditions(asked);
  ASSERT_EQ(conditions.rows.size(), 4u);
  EXPECT_FALSE(conditions.are_finite);
  const auto from_first = [&](double t) { return (attitude(t) * attitude(-0.5).inverse()).matrix(); };
  const auto slope = [&](double t) { return testing::first_difference(from_first, t, 1e-2); };
  const std::array<Matrix3x3, 3> expected = {slope(0), testing::second_difference(from_first, 0, 2e-2),
                                             testing::second_difference(slope, 0, 3e-2)};
  for (std::size_t m = 0; m < 3; ++m) {
    const Matrix3x3 wanted = (1 / frobenius_norm(expected[m])) * expected[m];
    EXPECT_LT(frobenius_norm(conditions.rows[m + 1] - wanted), 1e-6) << m;
  }
}

TEST(OrientationConditions, PartnerMeetsAllThree) {
  std::mt19937_64 random(4);
  for (int i = 0; i < 50; ++i) {
    const auto conditions = orientation_conditions(random_orientations(random, 4));
    const CubicCone cone(moving_axis_form(conditions), conditions.poles);
    const Vector3 moving = cone.axis(0.37);
    EXPECT_LT(residual_of(fixed_axis_of(moving, conditions), moving, conditions.rows), 1e-13);
  }
}

TEST(OrientationConditions, DegenerateTasksAreNamed) {
  const auto code = [](const std::string& name) {
    const auto c = testing::spherical_case(name);
    const auto notice = orientation_degeneracy(c.orientations, orientation_conditions(c.orientations));
    return notice ? notice->code : "none";
  };
  EXPECT_EQ(code("nasty-one-axis-4"), "common_axis");
  EXPECT_EQ(code("nasty-repeated-orientation-4"), "repeated_orientation");
  EXPECT_EQ(code("nasty-half-turns-4"), "none");
  EXPECT_EQ(code("nasty-coplanar-axes-4"), "none");
  EXPECT_EQ(code("nasty-small-1e-6-4"), "none");
}

TEST(OrientationConditions, DependentOnesHaveNoCondition) {
  const auto one_axis = testing::spherical_case("nasty-one-axis-4");
  EXPECT_GT(orientation_conditions(one_axis.orientations).condition(), 1e14);
  const auto wing = testing::spherical_case("folding-wing-4");
  EXPECT_LT(orientation_conditions(wing.orientations).condition(), 100);
}

TEST(OrientationConditions, SingularValuesAreThoseOfTheRowsSideBySide) {
  std::mt19937_64 random(4);
  for (const int count : {2, 3, 4, 5})
    for (const double largest_turn : {3.0, 1e-3, 1e-6}) {
      const auto conditions = orientation_conditions(testing::random_orientations(random, count, largest_turn));
      std::vector<std::array<double, 9>> rows(conditions.rows.size());
      for (std::size_t k = 0; k < rows.size(); ++k)
        for (std::size_t i = 0; i < 9; ++i) rows[k][i] = conditions.rows[k](i / 3, i % 3);
      ASSERT_EQ(conditions.singular.size(), static_cast<std::size_t>(count - 1));
      const std::vector<double> expected = row_space(rows).values;
      for (std::size_t k = 0; k < rows.size(); ++k) EXPECT_NEAR(conditions.singular[k], expected[k], 1e-14);
    }
}

}  // namespace
}  // namespace linkwright::orientation_conditions_test
