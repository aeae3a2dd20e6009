#include "spherical/spherical_function_family.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/spherical_defects.hpp"
#include "linkwright/spherical/spherical_solution.hpp"
#include "spherical/spherical_function_linkage.hpp"
#include "support/random_function.hpp"
#include "support/spherical_function.hpp"

namespace linkwright::spherical_function_family_test {
namespace {

const SphericalFunctionFamily& family_of(const SphericalTaskFamily& given) {
  return dynamic_cast<const SphericalFunctionFamily&>(*given.family);
}

SphericalFunctionTask squares() { return testing::named_spherical_task("x^2", {0, 1}, 60, 80, 70); }

TEST(SphericalFunctionFamily, EveryCellOfTheMapIsTheVerdictOnItsLinkage) {
  for (const bool with_free : {false, true}) {
    SphericalFunctionTask task = squares();
    if (with_free) task.free = FreeParameter{};
    const SphericalTaskFamily given = task_family(task);
    const SphericalFunctionFamily& family = family_of(given);
    RegionMap map;
    family.classify(map, family.samples(Side::input, 60, Spacing::coordinate),
                    family.samples(Side::output, 9, Spacing::coordinate), true);
    EXPECT_EQ(map.columns(), with_free ? 9u : 1u);
    int clean = 0;
    for (std::size_t row = 0; row < map.rows(); ++row)
      for (std::size_t column = 0; column < map.columns(); ++column) {
        const MapPoint place{map.input_coordinates()[row], map.output_coordinates()[column]};
        const std::size_t cell = map.index(row, column);
        const auto links = family.dyad_pair(place);
        if (!links) {
          EXPECT_EQ(map.types()[cell], static_cast<std::uint8_t>(LinkageType::degenerate));
          continue;
        }
        const SphericalFourBar bars = family.four_bar(*links);
        const DefectReport report = find_defects(bars, family.orientations(place, bars));
        EXPECT_EQ(map.types()[cell], static_cast<std::uint8_t>(report.type));
        EXPECT_EQ(map.defects()[cell] == 0, report.defects.none()) << place.input;
        clean += report.defects.none() ? 1 : 0;
      }
    EXPECT_GT(clean, 3);
  }
}

TEST(SphericalFunctionFamily, ItsFixedAxesAreThoseOfTheTask) {
  const SphericalFunctionTask task = squares();
  const SphericalTaskFamily given = task_family(task);
  const auto [input, output] = fixed_axes(task.ground_angle);
  for (const double tau : family_of(given).samples(Side::input, 20, Spacing::coordinate)) {
    const SphericalFourBar bars = given.family->four_bar(*given.family->dyad_pair({tau, 0.5}));
    EXPECT_EQ(bars.input_fixed, input);
    EXPECT_EQ(bars.output_fixed, output);
    EXPECT_LE(bars.angles().input, pi / 2 + 1e-12);
    EXPECT_LE(bars.angles().output, pi / 2 + 1e-12);
  }
}

TEST(SphericalFunctionFamily, WithoutDefectsTheDriveGivesThePairs) {
  for (const SphericalFunctionTask& task : {squares(), testing::spherical_function_case("stapler-function-4"),
                                            testing::named_spherical_task("log", {1, 2}, 60, -70, 40)}) {
    const SphericalTaskFamily given = task_family(task);
    const SphericalFunctionFamily& family = family_of(given);
    int clean = 0;
    for (const double tau : family.samples(Side::input, 300, Spacing::coordinate)) {
      constexpr bool verify = true;
      const auto made = make_spherical_four_bar(given, {tau, 0.5}, true, verify && clean < 5);
      if (!made || !made->report.defects.none() || made->report.min_transmission_angle < 0.02) continue;
      if (clean++ < 5) {
        EXPECT_TRUE(made->verified_by_driving) << tau;
      }
      const FunctionError error = family.error_of(made->four_bar, {tau, 0.5});
      EXPECT_TRUE(error.reaches_pairs);
      EXPECT_LT(error.precision_error, 1e-9);
      EXPECT_LT(made->residual, 1e-10);
    }
    EXPECT_GT(clean, 5);
  }
}

TEST(SphericalFunctionFamily, FivePairsHaveARowToEachLinkage) {
  const SphericalFunctionTask task = testing::spherical_function_case("function-five-real-5");
  const SphericalTaskFamily given = task_family(task);
  EXPECT_EQ(given.family->axis(Side::input).coordinate_length(), 5);
  EXPECT_TRUE(given.family->axis(Side::input).is_discrete());
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(make_spherical_four_bar(given, {i + 0.5, 0.5}, true, false));
}

// A spherical four-bar with three right angles and the shafts β apart is Hooke's joint: tan ψ = tan θ / cos β.
TEST(SphericalFunctionFamily, TheUniversalJointIsAmongTheGeneratorsOfItsFunction) {
  SphericalFunctionTask task;
  const double shafts = radians(30);
  task.ground_angle = pi - shafts;
  for (const double theta : {-0.6, -0.1, 0.35, 0.8})
    task.pairs.push_back({theta, std::atan(std::tan(theta) / std::cos(shafts)), {}});
  // One sense of the output is the joint, the other is none.
  double nearest = 10;
  for (const double sense : {-1.0, 1.0}) {
    SphericalFunctionTask turned = task;
    for (AnglePair& pair : turned.pairs) pair.output *= sense;
    const SphericalTaskFamily given = task_family(turned);
    ASSERT_TRUE(given.family);
    for (const double tau : given.family->samples(Side::input, 4000, Spacing::coordinate)) {
      const LinkAngles l = given.family->four_bar(*given.family->dyad_pair({tau, 0.5})).angles();
      nearest = std::min(
          nearest, std::max({std::abs(l.input - pi / 2), std::abs(l.coupler - pi / 2), std::abs(l.output - pi / 2)}));
    }
  }
  EXPECT_LT(nearest, 5e-3);
}

TEST(SphericalFunctionFamily, DerivativesAreMetAllAlongTheCurve) {
  std::mt19937_64 random(11);
  for (const auto& multiplicities : testing::four_position_patterns()) {
    SphericalFunctionTask task;
    task.pairs = testing::random_pairs(random, multiplicities);
    task.ground_angle = 1.1;
    const SphericalTaskFamily given = task_family(task);
    const SphericalFunctionFamily& family = family_of(given);
    for (const double tau : family.samples(Side::input, 40, Spacing::coordinate)) {
      const auto residual = family.rate_residual({tau, 0.5});
      ASSERT_EQ(residual.has_value(), multiplicities.size() < 4);
      EXPECT_LT(residual.value_or(0), 1e-9);
    }
  }
}

}  // namespace
}  // namespace linkwright::spherical_function_family_test
