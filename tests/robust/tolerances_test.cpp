#include "linkwright/robust/tolerances.hpp"

#include <cmath>
#include <gtest/gtest.h>
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

}  // namespace
}  // namespace linkwright::tolerances_test
