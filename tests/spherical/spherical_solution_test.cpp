#include "linkwright/spherical/spherical_solution.hpp"

#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/spherical_defects.hpp"
#include "support/spherical_case.hpp"

namespace linkwright::spherical_solution_test {
namespace {

constexpr bool in_direction = true, verify = true;

SphericalTaskFamily wing() {
  return task_family(SphericalMotionTask{testing::spherical_case("folding-wing-4").orientations, {}});
}

TEST(SphericalSolution, IsCheckedAndDriven) {
  const SphericalTaskFamily given = wing();
  int clean = 0;
  for (double a = 0.02; a < 1; a += 0.05)
    for (double b = 0.01; b < 1; b += 0.05) {
      const auto made = make_spherical_four_bar(given, {a, b}, in_direction, verify);
      ASSERT_TRUE(made);
      EXPECT_LT(made->residual, 1e-13);
      EXPECT_EQ(made->report.type, linkage_type(made->angles));
      EXPECT_EQ(made->swapped.type, swapped(made->report.type));
      EXPECT_EQ(made->input.fixed_axis, made->four_bar.input_fixed);
      EXPECT_LE(made->angles.input, pi / 2 + 1e-12);
      clean += made->report.defects.none();
      EXPECT_TRUE(made->report.min_transmission_angle < 0.01 || !is_unconfirmed(*made)) << a << " " << b;
    }
  EXPECT_GT(clean, 30);
}

TEST(SphericalSolution, TheSameDyadTwiceIsNone) {
  EXPECT_FALSE(make_spherical_four_bar(wing(), {0.3, 0.3}, in_direction, verify));
}

TEST(SphericalSolution, WhatDrivingDoesNotConfirmIsNoAnswer) {
  SphericalSolution found;
  found.report.type = LinkageType::crank_rocker;
  EXPECT_TRUE(is_unconfirmed(found));
  found.verified_by_driving = true;
  EXPECT_FALSE(is_unconfirmed(found));
  found.residual = 1e-3;
  EXPECT_TRUE(is_unconfirmed(found));
}

}  // namespace
}  // namespace linkwright::spherical_solution_test
