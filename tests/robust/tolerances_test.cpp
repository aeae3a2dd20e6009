#include "linkwright/robust/tolerances.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <set>

namespace linkwright::tolerances_test {
namespace {

constexpr std::array distributions = {ToleranceDistribution::normal, ToleranceDistribution::truncated_normal,
                                      ToleranceDistribution::uniform};

TEST(Tolerances, NameTheirDistributions) {
  for (const auto distribution : distributions)
    EXPECT_EQ(tolerance_distribution_named(name(distribution)), distribution);
  EXPECT_FALSE(tolerance_distribution_named("gaussian"));
}

TEST(Tolerances, HaveTheDeviationsOfTheirDensities) {
  // By the second moment of the density over ± T = ± 1, σ = 1/3, by Simpson's rule.
  const auto moment = [](int power) {
    constexpr int n = 2000;
    double sum = 0;
    for (int k = 0; k <= n; ++k) {
      const double x = -1 + 2.0 * k / n;
      sum += (k == 0 || k == n ? 1 : k % 2 ? 4 : 2) * std::pow(x, power) * std::exp(-4.5 * x * x);
    }
    return sum;
  };
  EXPECT_NEAR(standard_deviation(ToleranceDistribution::truncated_normal), std::sqrt(moment(2) / moment(0)), 1e-12);
  EXPECT_DOUBLE_EQ(standard_deviation(ToleranceDistribution::normal), 1.0 / 3);
  EXPECT_DOUBLE_EQ(standard_deviation(ToleranceDistribution::uniform), std::sqrt(1.0 / 3));
}

TEST(Tolerances, GiveEachParameterItsOwn) {
  Tolerances t{.length = {1, 2, 3, 4, 5}, .clearance = 10, .driver = 6, .link_angle = 7};
  EXPECT_EQ(planar_half_tolerances(t), (PlanarValues{1, 2, 3, 4, 4, 4, 4, 5, 5, 6}));
  EXPECT_EQ(planar_reach(t), (PlanarValues{21, 22, 23, 4, 4, 4, 4, 5, 5, 6}));
  EXPECT_EQ(spherical_half_tolerances(t), (SphericalValues{7, 7, 7, 7, 6}));
  const PlanarValues variances = planar_variances(t);
  EXPECT_DOUBLE_EQ(variances[1], 4.0 / 9 + 50);
  EXPECT_DOUBLE_EQ(variances[3], 16.0 / 9);
  EXPECT_DOUBLE_EQ(variances[9], 4);
  t.distribution = ToleranceDistribution::uniform;
  EXPECT_DOUBLE_EQ(planar_variances(t)[1], 4.0 / 3 + 50);
  EXPECT_DOUBLE_EQ(spherical_variances(t)[4], 12);
}

TEST(Tolerances, NameTheirParameters) {
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < planar_parameters; ++i) names.insert(name(static_cast<PlanarParameter>(i)));
  EXPECT_EQ(names.size(), planar_parameters);
  EXPECT_EQ(name(PlanarParameter::driver), name(SphericalParameter::driver));
  EXPECT_EQ(name(PlanarParameter::point_across), "point_across");
  EXPECT_EQ(name(SphericalParameter::ground), "ground");
}

// The places of the mistakes.
std::vector<std::string> places_of(const Tolerances& tolerances) {
  std::vector<std::string> places;
  for (const Error& error : mistakes_in(tolerances)) places.push_back(error.place);
  return places;
}
using Places = std::vector<std::string>;

TEST(Tolerances, MayBeAnyThatCanBeMade) {
  EXPECT_EQ(places_of({.length = {.output = 1e-9}}), Places{});
  EXPECT_EQ(places_of({.clearance = 0.1}), Places{});
  EXPECT_EQ(places_of({.driver = 1.5}), Places{});
  EXPECT_EQ(places_of({.link_angle = 1e-6}), Places{});
  for (const int samples : {1000, 10'000'000}) {
    Tolerances t{.length = LengthTolerances::all(1)};
    t.turning_length = 0;
    t.limit = {ToleranceLimit::Kind::angle, 3.14};
    t.cost_exponent = 0.1;
    t.samples = samples;
    t.seed = samples == 1000 ? 0 : largest_seed;
    EXPECT_EQ(places_of(t), Places{});
  }
}

TEST(Tolerances, AreMistakenWhereTheyAreNoLengthsOrAngles) {
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {-0.1, nan, infinity}) {
    EXPECT_EQ(places_of({.length = LengthTolerances::all(bad)}), Places{"tolerances.length"});
    EXPECT_EQ(places_of({.length = {bad, 1, bad, 1, bad}}),
              (Places{"tolerances.length.input", "tolerances.length.output", "tolerances.length.point"}));
    EXPECT_EQ(places_of({.length = {1, bad, 1, bad, 1}}),
              (Places{"tolerances.length.coupler", "tolerances.length.ground_pivots"}));
    EXPECT_EQ(places_of({.clearance = bad}), Places{"tolerances.clearance"});
    EXPECT_EQ(places_of({.driver = bad}), Places{"tolerances.driver_deg"});
    EXPECT_EQ(places_of({.link_angle = bad}), Places{"tolerances.link_angle_deg"});
    Tolerances t{.length = LengthTolerances::all(1)};
    t.turning_length = bad;
    EXPECT_EQ(places_of(t), Places{"tolerances.turning_length"});
  }
  EXPECT_EQ(places_of({.driver = 1.6}), Places{"tolerances.driver_deg"});
  EXPECT_EQ(places_of({}), Places{"tolerances"});
}

// Squares of what is larger would be infinite.
TEST(Tolerances, AreNoLargerThanOtherNumbersOfATask) {
  const auto code = [](const auto& change) {
    Tolerances tolerances;
    tolerances.driver = 0.01;
    change(tolerances);
    const auto found = mistakes_in(tolerances);
    return found.size() == 1 ? found.front().code + " " + found.front().place : std::string();
  };
  EXPECT_EQ(code([](auto& t) { t.length = LengthTolerances::all(1e200); }), "number_range tolerances.length");
  EXPECT_EQ(code([](auto& t) { t.length.point = 2e9; }), "number_range tolerances.length.point");
  EXPECT_EQ(code([](auto& t) { t.clearance = 2e9; }), "number_range tolerances.clearance");
}

TEST(Tolerances, AreMistakenInLimitCostSamplesAndSeed) {
  using Kind = ToleranceLimit::Kind;
  const auto with = [](const auto& change) {
    Tolerances t{.length = LengthTolerances::all(1)};
    change(t);
    return places_of(t);
  };
  for (const double bad : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(with([&](auto& t) { t.limit = {Kind::position, bad}; }), Places{"tolerances.limit.position"});
    EXPECT_EQ(with([&](auto& t) { t.limit = {Kind::angle, bad}; }), Places{"tolerances.limit.angle_deg"});
    EXPECT_EQ(with([&](auto& t) { t.limit = {Kind::deviation, bad}; }), Places{"tolerances.limit.deviation"});
    EXPECT_EQ(with([&](auto& t) { t.cost_exponent = bad; }), Places{"tolerances.cost.exponent"});
  }
  EXPECT_EQ(with([](auto& t) { t.limit = {Kind::angle, 3.2}; }), Places{"tolerances.limit.angle_deg"});
  EXPECT_EQ(with([](auto& t) { t.samples = 999; }), Places{"tolerances.samples"});
  EXPECT_EQ(with([](auto& t) { t.samples = 10'000'001; }), Places{"tolerances.samples"});
  EXPECT_EQ(with([](auto& t) { t.seed = largest_seed + 1; }), Places{"tolerances.seed"});
}

}  // namespace
}  // namespace linkwright::tolerances_test
