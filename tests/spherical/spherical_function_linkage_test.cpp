#include "spherical/spherical_function_linkage.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/spherical_position.hpp"
#include "linkwright/spherical/spherical_function_task.hpp"
#include "spherical/spherical_couplers.hpp"
#include "support/random_function.hpp"
#include "support/random_task.hpp"
#include "support/spherical_function.hpp"

namespace linkwright::spherical_function_linkage_test {
namespace {

SphericalFourBar linkage_at(const SphericalFunctionTask& task, double tau) {
  const SphericalDyad coupler = *spherical_couplers(task.pairs, task.ground_angle).coupler(tau);
  const auto [input, output] = fixed_axes(task.ground_angle);
  return with_short_side_links({input, coupler.fixed_axis, coupler.moving_axis, output});
}

TEST(SphericalFunctionLinkage, KeepsItsFixedAxesAndShortensItsSideLinks) {
  const SphericalFourBar bars = with_short_side_links({{0, 0, 1}, {0, 0.6, -0.8}, {0.6, -0.8, 0}, {0, 1, 0}});
  EXPECT_EQ(bars.input_fixed, (Vector3{0, 0, 1}));
  EXPECT_EQ(bars.output_fixed, (Vector3{0, 1, 0}));
  EXPECT_EQ(bars.input_moving, (Vector3{0, -0.6, 0.8}));
  EXPECT_EQ(bars.output_moving, (Vector3{-0.6, 0.8, 0}));
}

TEST(SphericalFunctionLinkage, TheCouplerCarriesBothMovingAxes) {
  const SphericalFunctionTask task = testing::spherical_function_case("stapler-function-4");
  const SphericalFourBar bars = linkage_at(task, 0.37);
  const auto orientations = coupler_orientations(bars, task.pairs);
  ASSERT_EQ(orientations.size(), task.pairs.size());
  for (std::size_t j = 0; j < task.pairs.size(); ++j) {
    const auto turned = [&](Vector3 fixed, Vector3 moving, double angle) {
      return UnitQuaternion::about(fixed, angle).apply(moving);
    };
    const UnitQuaternion turn = orientations[j].orientation;
    const Vector3 a = turned(bars.input_fixed, bars.input_moving, task.pairs[j].input - task.pairs[0].input);
    const Vector3 b = turned(bars.output_fixed, bars.output_moving, task.pairs[j].output - task.pairs[0].output);
    EXPECT_LT(norm(turn.apply(bars.input_moving) - a), 1e-12);
    EXPECT_LT(norm(turn.apply(bars.output_moving) - b), 1e-10);
  }
}

// The next orientation by Taylor's formula of the derivatives is where the pair a short while after puts the coupler.
TEST(SphericalFunctionLinkage, RatesOfTheCouplerFollowFromThoseOfThePairs) {
  std::mt19937_64 random(1);
  SphericalFunctionTask task;
  task.pairs = testing::random_pairs(random, {4});
  task.ground_angle = 1.3;
  const SphericalFourBar bars = linkage_at(task, 0.4);
  const auto rates = coupler_orientations(bars, task.pairs).front().derivatives;
  ASSERT_EQ(rates.size(), 3u);
  constexpr double t = 1e-4;
  const auto turn_at = [&](double at) {
    return coupler_orientations(bars, {task.pairs.front(), testing::pair_after(task.pairs.front(), at)})[1].orientation;
  };
  const UnitQuaternion after = turn_at(t), before = turn_at(-t);
  // q(±t) ≈ 1 ± ω t/2 + …: the odd part is ω t/2 to third order.
  const Vector3 by_difference = (1 / (2 * t)) * (2 * after.canonical().v() - 2 * before.canonical().v());
  EXPECT_LT(norm(by_difference - rates[0]), 1e-5 * (1 + norm(rates[2]) + norm(rates[0])));
  const Vector3 second = (1 / (t * t)) * (2 * after.canonical().v() + 2 * before.canonical().v());
  EXPECT_LT(norm(second - rates[1]), 1e-3 * (1 + norm(rates[1])));
}

TEST(SphericalFunctionLinkage, ForwardKinematicsGivesThePairsBack) {
  for (const std::string name : {"stapler-function-5", "function-five-real-5"}) {
    const SphericalFunctionTask task = testing::spherical_function_case(name);
    const auto couplers = spherical_couplers(task.pairs, task.ground_angle);
    for (const SphericalDyad& coupler : couplers.points) {
      const SphericalFourBar bars = linkage_at(task, coupler.coordinate);
      EXPECT_LT(coupler_residual(bars, task.pairs), 1e-9);
      for (const AnglePair& pair : task.pairs) {
        // On one of the two assemblies it is the pair's output: both are told by the linkage's own forward kinematics.
        const SphericalConfiguration start = configuration_of(bars);
        double nearest = 10;
        for (const Assembly assembly : {Assembly::negative, Assembly::positive}) {
          const auto there = assemble(bars.angles(), start.input_angle + pair.input - task.pairs[0].input, assembly);
          if (!there) continue;
          const double output = there->output_angle - start.output_angle + task.pairs[0].output;
          nearest = std::min(nearest, std::abs(wrap_signed(output - pair.output)));
        }
        EXPECT_LT(nearest, 1e-9) << name;
      }
    }
  }
}

TEST(SphericalFunctionLinkage, StandsAtTheFirstPairAndTurnsAboutItsAxes) {
  const SphericalFunctionTask task = testing::spherical_function_case("stapler-function-4");
  const SphericalFourBar bars = linkage_at(task, 0.37);
  const GeneratedFunction generated = generated_function(bars, task.pairs[0]);
  EXPECT_NEAR(*generated.output_at(task.pairs[0].input, 0), task.pairs[0].output, 1e-12);
  // The slope is the velocity ratio.
  const auto ratio = velocity_ratio(bars);
  ASSERT_TRUE(ratio);
  constexpr double t = 1e-6;
  const auto after = generated.output_at(task.pairs[0].input + t, 0),
             before = generated.output_at(task.pairs[0].input - t, 0);
  ASSERT_TRUE(after && before);
  EXPECT_NEAR((*after - *before) / (2 * t), *ratio, 1e-6 * (1 + std::abs(*ratio)));
}

}  // namespace
}  // namespace linkwright::spherical_function_linkage_test
