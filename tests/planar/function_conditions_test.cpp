#include "planar/function_conditions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/linkage_type.hpp"
#include "linkwright/planar/burmester_curve.hpp"
#include "planar/function_couplers.hpp"
#include "planar/function_linkage.hpp"
#include "support/planar_case.hpp"
#include "support/random_function.hpp"
#include "support/random_task.hpp"

namespace linkwright::function_conditions_test {
namespace {

using testing::uniform;

// Great circle to the nearest dyad of the curve, by its own coordinate.
double off_the_curve(const BurmesterCurve& curve, const Dyad& dyad) {
  const auto tau = curve.circle_curve().coordinate_of(dyad.circle);
  if (!tau) return 10;
  const Dyad there = curve.dyad(*tau);
  return std::max(norm(cross(there.circle, dyad.circle)), norm(cross(there.center, dyad.center)));
}

std::vector<AnglePair> pairs_of_case(const testing::PlanarCase& c) {
  const auto& given = c.json["function_generation"];
  std::vector<AnglePair> pairs;
  for (std::size_t j = 0; j < given["phi"].size(); ++j) pairs.push_back({given["phi"][j], given["psi"][j], {}});
  return pairs;
}

TEST(FunctionConditions, PosesAreThoseOfTheWorkedCase) {
  const testing::PlanarCase& c = testing::planar_case("funcgen4_sqrt");
  const FunctionConditions given = function_conditions(pairs_of_case(c));
  ASSERT_EQ(given.poses.size(), c.poses.size());
  for (std::size_t j = 0; j < c.poses.size(); ++j) {
    EXPECT_NEAR(std::abs(given.poses[j].pose.origin - c.poses[j].pose.origin), 0, 1e-14);
    EXPECT_NEAR(given.poses[j].pose.angle, c.poses[j].pose.angle, 1e-14);
  }
  EXPECT_NEAR(given.conditions.frame.scale, c.json["working_frame"]["scale"].get<double>(), 1e-12);
  EXPECT_NEAR(given.conditions.condition(), c.json["condition"].get<double>(), 1e-10);
}

TEST(FunctionConditions, TheCurveOfTheWorkedCaseHoldsItsLinkages) {
  const testing::PlanarCase& c = testing::planar_case("funcgen4_sqrt");
  const FunctionConditions given = function_conditions(pairs_of_case(c));
  const BurmesterCurve curve(given.conditions);
  EXPECT_EQ(curve.kind(), CubicKind::one_branch);
  int compared = 0;
  for (const auto& bars : c.json["function_generators_four_bars"]) {
    const Point a{bars["A"][0], bars["A"][1]}, b{bars["B"][0], bars["B"][1]};
    const WorkingFrame& frame = given.conditions.frame;
    const Dyad dyad{normalized(frame.to_working(Homogeneous::of(b))), normalized(frame.to_working(Homogeneous::of(a))),
                    0};
    EXPECT_LT(curve.residual(dyad), 1e-12);
    EXPECT_LT(off_the_curve(curve, dyad), 1e-9);
    ++compared;
  }
  EXPECT_GE(compared, 8);
}

TEST(FunctionConditions, TheGroundLinkIsOnEveryCurve) {
  std::mt19937_64 random(5);
  double worst = 0, worst_residual = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto& pattern = testing::four_position_patterns()[static_cast<std::size_t>(i) % 8];
    const FunctionConditions given = function_conditions(testing::random_pairs(random, pattern));
    EXPECT_FALSE(function_degeneracy(given));
    const BurmesterCurve curve(given.conditions);
    worst_residual = std::max(worst_residual, curve.residual(given.ground));
    worst = std::max(worst, off_the_curve(curve, given.ground));
  }
  EXPECT_LT(worst_residual, 1e-13);
  EXPECT_LT(worst, 1e-5) << "the coordinate loses half of the digits near a node";
  RecordProperty("worst_residual", std::to_string(worst_residual));
}

TEST(FunctionConditions, EveryCouplerKeepsItsLengthAtAllPairs) {
  std::mt19937_64 random(6);
  std::vector<double> residuals;
  for (int i = 0; i < 2000; ++i) {
    const auto& pattern = testing::four_position_patterns()[static_cast<std::size_t>(i) % 8];
    const auto pairs = testing::random_pairs(random, pattern);
    const FunctionConditions given = function_conditions(pairs);
    const BurmesterCurve curve(given.conditions);
    for (int k = 0; k < 3; ++k) {
      const Dyad dyad = curve.dyad(uniform(random, 0, curve.coordinate_length()));
      EXPECT_LT(curve.residual(dyad), 1e-14);
      const auto bars = function_four_bar({}, given.conditions.frame, dyad);
      if (!bars || linkage_type(bars->lengths()) == LinkageType::degenerate || distance_from_ground(given, dyad) < 0.01)
        continue;
      // Short couplers carry the rounding of long arms.
      residuals.push_back(coupler_residual(*bars, pairs) * bars->lengths().coupler / bars->lengths().longest());
    }
  }
  std::sort(residuals.begin(), residuals.end());
  ASSERT_GT(residuals.size(), 5000u);
  EXPECT_LT(residuals[residuals.size() / 2], 1e-14);
  EXPECT_LT(residuals[residuals.size() * 99 / 100], 1e-11);
  EXPECT_LT(residuals.back(), 1e-9);
  RecordProperty("worst", std::to_string(residuals.back() * 1e12) + "e-12");
  RecordProperty("median", std::to_string(residuals[residuals.size() / 2] * 1e16) + "e-16");
}

// The same derivatives found by driving along the Taylor polynomials of the angles.
TEST(FunctionConditions, DerivativesAreThoseOfTheMotion) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 50; ++i) {
    auto pairs = testing::random_pairs(random, {1, 4});
    const AnglePair& pair = pairs[1];
    const auto at = [&](double t) {
      return function_conditions({pairs[0], testing::pair_after(pair, t)}).poses[1].pose;
    };
    const PrescribedPose pose = function_conditions(pairs).poses[1];
    ASSERT_EQ(pose.derivatives.size(), 3u);
    const double h = 1e-3;
    const auto first = [&](double t) { return (at(t + h).origin - at(t - h).origin) / (2 * h); };
    const auto second = [&](double t) { return (first(t + h) - first(t - h)) / (2 * h); };
    EXPECT_NEAR(std::abs(pose.derivatives[0].origin - first(0)), 0, 1e-4);
    EXPECT_NEAR(std::abs(pose.derivatives[1].origin - second(0)), 0, 1e-3);
    EXPECT_NEAR(std::abs(pose.derivatives[2].origin - (second(h) - second(-h)) / (2 * h)), 0, 1e-2);
    for (std::size_t m = 0; m < 3; ++m)
      EXPECT_EQ(pose.derivatives[m].angle, pair.derivatives[m].input - pair.derivatives[m].output);
  }
}

// Positions h, 2h, … apart along a motion tend to its derivatives.
TEST(FunctionConditions, PairsThatRunTogetherTendToTheirDerivatives) {
  const AnglePair from{0.2, -0.4, {{1, 0.7}, {0.3, -1.1}}}, last{1.6, 0.3, {}};
  const auto after = [&](double t) {
    return AnglePair{from.input + t * 1 + t * t / 2 * 0.3, from.output + t * 0.7 - t * t / 2 * 1.1, {}};
  };
  const BurmesterCurve limit(function_conditions({from, last}).conditions);
  std::vector<double> distances;
  for (const double h : {1e-2, 1e-3, 1e-4}) {
    const FunctionConditions given = function_conditions({after(0), after(h), after(2 * h), last});
    const BurmesterCurve near(given.conditions);
    const FunctionConditions at_limit = function_conditions({from, last});
    double worst = 0;
    for (double tau = 0.05; tau < limit.coordinate_length(); tau += 0.1) {
      const Dyad unit = at_limit.conditions.frame.to_user(limit.dyad(tau));
      const WorkingFrame& frame = given.conditions.frame;
      worst = std::max(worst, near.residual({normalized(frame.to_working(unit.center)),
                                             normalized(frame.to_working(unit.circle)), 0}));
    }
    distances.push_back(worst);
  }
  EXPECT_LT(distances[1], 0.2 * distances[0]) << "at least in proportion to h";
  EXPECT_LT(distances[2], 0.2 * distances[1]);
  EXPECT_LT(distances[2], 1e-3);
}

TEST(FunctionConditions, AnOutputThatTurnsAsTheInputIsAParallelogram) {
  const auto degeneracy_of = [](const std::vector<AnglePair>& pairs) {
    const auto found = function_degeneracy(function_conditions(pairs));
    return found ? found->code : "none";
  };
  EXPECT_EQ(degeneracy_of({{0, 1, {}}, {0.4, 1.4, {}}, {1, 2, {}}, {1.7, 2.7, {}}}), "parallelogram");
  EXPECT_EQ(degeneracy_of({{0, 1, {{1, 1}}}, {0.4, 1.4, {}}, {1, 2, {}}}), "parallelogram");
  EXPECT_EQ(degeneracy_of({{0, 1, {}}, {0.4, 1.4, {}}, {1, 2, {}}, {1.7, 2.7, {}}, {2, 3, {}}}), "parallelogram");
  EXPECT_EQ(degeneracy_of({{0, 0, {}}, {0.4, -0.4, {}}, {1, -1, {}}, {1.7, -1.7, {}}}), "none");
  EXPECT_EQ(degeneracy_of({{0, 0, {}}, {0.4, 0.8, {}}, {1, 2, {}}, {1.7, 3.4, {}}}), "none");
}

TEST(FunctionConditions, TheDatumOfTheAnglesDoesNotMatter) {
  std::mt19937_64 random(8);
  for (int i = 0; i < 100; ++i) {
    const auto pairs = testing::random_pairs(random, {1, 2, 1});
    auto moved = pairs;
    for (AnglePair& pair : moved) {
      pair.input += 2;
      pair.output -= 1;
    }
    const BurmesterCurve curve(function_conditions(pairs).conditions), other(function_conditions(moved).conditions);
    EXPECT_EQ(curve.kind(), other.kind());
    const double tau = uniform(random, 0, curve.coordinate_length());
    EXPECT_LT(other.residual(curve.dyad(tau)), 1e-12);
  }
}

// A rigid motion of the ground pivots takes everything along, a change of scale too, and huge coordinates cost nothing.
TEST(FunctionConditions, TheGroundLinkMayLieAnywhere) {
  std::mt19937_64 random(10);
  for (int i = 0; i < 100; ++i) {
    const auto pairs = testing::random_pairs(random, {2, 1, 1});
    const Point shift{3e6, -2e6}, turn = 250.0 * direction(uniform(random, -3, 3));
    const FunctionConditions unit = function_conditions(pairs), moved = function_conditions(pairs, shift, shift + turn);
    EXPECT_EQ(moved.conditions.frame.origin, shift);
    EXPECT_NEAR(moved.conditions.frame.scale, 250 * unit.conditions.frame.scale, 1e-6);
    EXPECT_NEAR(moved.conditions.condition(), unit.conditions.condition(), 1e-6 * unit.conditions.condition());
    const BurmesterCurve curve(unit.conditions), other(moved.conditions);
    const Dyad dyad = curve.dyad(uniform(random, 0, curve.coordinate_length()));
    const auto turned = [&](Homogeneous p) {
      const Point v = p.vector() * turn / 250.0;
      return Homogeneous{p.w, v.real(), v.imag()};
    };
    EXPECT_LT(other.residual({turned(dyad.center), turned(dyad.circle), 0}), 1e-8);
    EXPECT_LT(distance_from_ground(moved, {turned(unit.ground.center), turned(unit.ground.circle), 0}), 1e-8);
  }
}

// Reading the function backwards is driving the same linkages from the other side.
TEST(FunctionConditions, TheInverseFunctionHasTheSameLinkages) {
  std::mt19937_64 random(9);
  for (int i = 0; i < 100; ++i) {
    const auto pairs = testing::random_pairs(random, {1, 1, 2});
    auto inverse = pairs;
    for (AnglePair& pair : inverse) {
      std::swap(pair.input, pair.output);
      for (AngleDerivative& d : pair.derivatives) std::swap(d.input, d.output);
    }
    const FunctionConditions given = function_conditions(pairs), back = function_conditions(inverse);
    const BurmesterCurve curve(given.conditions), back_curve(back.conditions);
    const Dyad dyad = given.conditions.frame.to_user(curve.dyad(uniform(random, 0, curve.coordinate_length())));
    // Half a turn about the middle of the ground link exchanges the pivots.
    const auto turned = [&](Homogeneous p) {
      return normalized(back.conditions.frame.to_working(Homogeneous{p.w, p.w - p.x, -p.y}));
    };
    EXPECT_LT(back_curve.residual({turned(dyad.circle), turned(dyad.center), 0}), 1e-11);
  }
}

/// f = (|B − A|² − const)/2 of a coupler seen while the pairs run on, at a time t past the first.
double length_change(const Dyad& coupler, const WorkingFrame& frame, const AnglePair& pair, double t) {
  const Point b = *finite_point(frame.to_user(coupler.center)), a = *finite_point(frame.to_user(coupler.circle));
  const AngleDerivative first = pair.derivatives[0], second = pair.derivatives[1];
  const Point turned_a = direction(t * first.input + t * t / 2 * second.input) * a;
  const Point turned_b = 1.0 + direction(t * first.output + t * t / 2 * second.output) * (b - 1.0);
  return std::norm(turned_b - turned_a) / 2;
}

/// Rows of one pair's two derivatives, orthonormal: what they say of a coupler, f′ and f″ say with other factors.
TEST(FunctionConditions, DerivativeRowsAreDifferencesOfTheCouplersLength) {
  const AnglePair first{0.3, 0.1, {{1, 0.6}, {0.2, -0.3}}};
  const FunctionConditions given = function_conditions({first, {0.9, 0.7, {}}});
  const auto rows = given.derivative_rows();
  ASSERT_EQ(rows.size(), 2u);
  std::mt19937_64 random(5);
  const auto values = [&] {
    const WorkingFrame& frame = given.conditions.frame;
    const Dyad coupler{Homogeneous::of({uniform(random, -2, 2), uniform(random, -2, 2)}),
                       Homogeneous::of({uniform(random, -2, 2), uniform(random, -2, 2)}), 0};
    constexpr double h = 1e-3;
    const double before = length_change(coupler, frame, first, -h), here = length_change(coupler, frame, first, 0),
                 after = length_change(coupler, frame, first, h);
    return std::array{(after - before) / (2 * h), (after - 2 * here + before) / (h * h),
                      dot(coupler.circle, rows[0] * coupler.center), dot(coupler.circle, rows[1] * coupler.center)};
  };
  // f′ and f″ as sums of the rows, from two couplers; then of others.
  const auto one = values(), other = values();
  const double area = one[2] * other[3] - one[3] * other[2];
  for (int i = 0; i < 20; ++i) {
    const auto third = values();
    for (const std::size_t order : {0u, 1u}) {
      const double p = (one[order] * other[3] - other[order] * one[3]) / area,
                   q = (one[2] * other[order] - other[2] * one[order]) / area;
      EXPECT_NEAR(p * third[2] + q * third[3], third[order], 1e-4 * (1 + std::abs(third[order])));
    }
  }
}

}  // namespace
}  // namespace linkwright::function_conditions_test
