#include "spherical/spherical_couplers.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <random>

#include "linkwright/core/angle.hpp"
#include "linkwright/spherical/spherical_function_task.hpp"
#include "spherical/spherical_function_linkage.hpp"
#include "support/random_function.hpp"
#include "support/random_task.hpp"
#include "support/spherical_function.hpp"

namespace linkwright::spherical_couplers_test {
namespace {

SphericalFourBar bars_of(const SphericalDyad& coupler, double ground_angle) {
  const auto [input, output] = fixed_axes(ground_angle);
  return {input, coupler.fixed_axis, coupler.moving_axis, output};
}

// How far the coupler's angle is from constant: forward kinematics without any conditions.
double worst_change(const SphericalFunctionTask& task, const std::vector<SphericalDyad>& couplers) {
  double worst = 0;
  for (const SphericalDyad& coupler : couplers)
    worst = std::max(worst, coupler_residual(bars_of(coupler, task.ground_angle), task.pairs));
  return worst;
}

std::vector<SphericalDyad> along(const AxisCurve& curve, int count) {
  std::vector<SphericalDyad> found;
  for (const double at : curve.samples(count, Spacing::coordinate)) found.push_back(curve.dyad(at));
  return found;
}

TEST(SphericalCouplers, OfFourPairsKeepTheirAngleAllAlongTheCurve) {
  const SphericalFunctionTask task = testing::spherical_function_case("stapler-function-4");
  const SphericalCouplers couplers = spherical_couplers(task.pairs, task.ground_angle);
  ASSERT_TRUE(couplers.curve);
  EXPECT_LT(worst_change(task, along(*couplers.curve, 400)), 1e-9);
}

TEST(SphericalCouplers, TheGroundLinkLiesOnTheCurve) {
  const SphericalFunctionTask task = testing::spherical_function_case("stapler-function-4");
  const SphericalCouplers couplers = spherical_couplers(task.pairs, task.ground_angle);
  const auto [input, output] = fixed_axes(task.ground_angle);
  const auto at = couplers.curve->coordinate_of(output);
  ASSERT_TRUE(at);
  const SphericalDyad ground = couplers.curve->dyad(*at);
  EXPECT_LT(norm(cross(ground.moving_axis, output)), 1e-9);
  EXPECT_LT(norm(cross(ground.fixed_axis, input)), 1e-9);
}

TEST(SphericalCouplers, OfTheCasesAreAllThatThereAre) {
  for (const auto& [name, count] : {std::pair{"stapler-function-5", 0u}, {"function-five-real-5", 5u}}) {
    const auto c =
        nlohmann::json::parse(std::ifstream(LINKWRIGHT_DATA_DIR "/spherical/" + std::string(name) + ".json"));
    const auto& wanted = c["output"]["linkages"];
    const SphericalFunctionTask task = testing::spherical_function_case(name);
    const SphericalCouplers couplers = spherical_couplers(task.pairs, task.ground_angle);
    EXPECT_EQ(couplers.points.size(), wanted.size()) << name;
    if (count > 0) {
      EXPECT_EQ(couplers.points.size(), count) << name;
    }
    EXPECT_LT(worst_change(task, couplers.points), 1e-9) << name;
    for (const auto& linkage : wanted) {
      const double coupler = linkage["link_angles"][1];
      EXPECT_TRUE(std::any_of(couplers.points.begin(), couplers.points.end(),
                              [&](const SphericalDyad& p) {
                                return std::abs(std::min(p.angle(), pi - p.angle()) - std::min(coupler, pi - coupler)) <
                                       1e-8;
                              }))
          << name << " " << coupler;
    }
  }
}

TEST(SphericalCouplers, OfFivePairsAreOddInNumber) {
  std::mt19937_64 random(5);
  std::array<int, 6> counted{};
  for (int i = 0; i < 300; ++i) {
    SphericalFunctionTask task;
    task.pairs = testing::random_pairs(random, {1, 1, 1, 1, 1});
    task.ground_angle = testing::uniform(random, 0.3, 2.8);
    const SphericalCouplers couplers = spherical_couplers(task.pairs, task.ground_angle);
    ASSERT_LE(couplers.points.size(), 5u);
    ++counted[couplers.points.size()];
    EXPECT_LT(worst_change(task, couplers.points), 1e-7);
  }
  EXPECT_EQ(counted[0] + counted[2] + counted[4], 0);
  EXPECT_GT(counted[1], 100);
  EXPECT_GT(counted[3], 10);
}

TEST(SphericalCouplers, DoNotDependOnTheDatumOfTheDials) {
  SphericalFunctionTask task = testing::spherical_function_case("function-five-real-5");
  const SphericalCouplers here = spherical_couplers(task.pairs, task.ground_angle);
  for (AnglePair& pair : task.pairs) {
    pair.input += 1.234;
    pair.output -= 0.567;
  }
  const SphericalCouplers there = spherical_couplers(task.pairs, task.ground_angle);
  ASSERT_EQ(here.points.size(), there.points.size());
  for (std::size_t i = 0; i < here.points.size(); ++i) {
    EXPECT_LT(norm(cross(here.points[i].fixed_axis, there.points[i].fixed_axis)), 1e-9);
    EXPECT_LT(norm(cross(here.points[i].moving_axis, there.points[i].moving_axis)), 1e-9);
  }
}

// The pair a short while after one with derivatives is met as well, to the order of the derivatives.
TEST(SphericalCouplers, OfMixedPairsKeepTheirAngleToTheOrderGiven) {
  std::mt19937_64 random(6);
  for (const std::vector<int>& multiplicities : testing::four_position_patterns()) {
    SphericalFunctionTask task;
    task.pairs = testing::random_pairs(random, multiplicities);
    task.ground_angle = 1.1;
    const SphericalCouplers couplers = spherical_couplers(task.pairs, task.ground_angle);
    ASSERT_TRUE(couplers.curve) << pattern(task.pairs);
    for (const SphericalDyad& coupler : along(*couplers.curve, 20)) {
      const SphericalFourBar bars = bars_of(coupler, task.ground_angle);
      EXPECT_LT(coupler_residual(bars, task.pairs), 1e-8);
      for (const AnglePair& pair : task.pairs) {
        constexpr double t = 1e-3;
        const double largest = std::abs(coupler_residual(bars, {task.pairs.front(), testing::pair_after(pair, t)}));
        const double rates = 1 + std::abs(pair.input) + std::abs(pair.output);
        if (pair.multiplicity() > 1) {
          EXPECT_LT(largest, 1e4 * rates * std::pow(t, pair.multiplicity())) << pattern(task.pairs);
        }
      }
    }
  }
}

TEST(SphericalCouplers, SmallTurnsLeaveTheirDigits) {
  SphericalFunctionTask task;
  task.ground_angle = 1.2;
  for (const double t : {0.0, 1.0, 2.0, 3.5}) task.pairs.push_back({1e-5 * t, 1e-5 * (0.8 * t + 0.1 * t * t), {}});
  const SphericalCouplers couplers = spherical_couplers(task.pairs, task.ground_angle);
  ASSERT_TRUE(couplers.curve);
  EXPECT_LT(worst_change(task, along(*couplers.curve, 50)), 1e-14);
}

/// Rows that derivatives set say of any coupler what differences of the cosine of its angle say, but for a factor each.
TEST(SphericalCouplers, DerivativeRowsAreDifferencesOfTheCouplersAngle) {
  const AnglePair first{0.3, 0.1, {{1, 0.6}, {0.2, -0.3}}};
  const double ground = radians(70);
  const SphericalCouplers couplers = spherical_couplers({first, {0.9, 0.7, {}}, {1.4, 1.2, {}}}, ground);
  const auto rows = derivative_rows(std::vector<AnglePair>{first, {0.9, 0.7, {}}, {1.4, 1.2, {}}}, couplers.conditions);
  ASSERT_EQ(rows.size(), 2u);
  std::mt19937_64 random(3);
  std::normal_distribution<double> coordinate;
  const auto axis = [&] { return normalized(Vector3{coordinate(random), coordinate(random), coordinate(random)}); };
  const auto [input, output] = fixed_axes(ground);
  std::array<double, 2> factor{};
  for (int i = 0; i < 20; ++i) {
    const Vector3 on_input = axis(), on_output = axis();
    const auto cosine = [&, z = input, u = output](double t) {
      const AnglePair then = testing::pair_after(first, t);
      return dot(UnitQuaternion::about(z, then.input - first.input).apply(on_input),
                 UnitQuaternion::about(u, then.output - first.output).apply(on_output));
    };
    constexpr double h = 1e-3;
    const std::array<double, 2> differences = {(cosine(h) - cosine(-h)) / (2 * h),
                                               (cosine(h) - 2 * cosine(0) + cosine(-h)) / (h * h)};
    for (const std::size_t order : {0u, 1u}) {
      const double of_row = dot(on_input, rows[order] * on_output);
      if (i == 0) factor[order] = differences[order] / of_row;
      EXPECT_NEAR(differences[order], factor[order] * of_row, 1e-5);
    }
  }
}

}  // namespace
}  // namespace linkwright::spherical_couplers_test
