#include "linkwright/spherical/spherical_family.hpp"

#include <gtest/gtest.h>
#include <random>

#include "support/spherical_case.hpp"

namespace linkwright::spherical_family_test {
namespace {

std::shared_ptr<const AxisCurve> curve_of(const std::vector<PrescribedOrientation>& orientations) {
  return std::make_shared<const AxisCurve>(orientation_conditions(orientations));
}

TEST(SphericalFamily, PairsAreDrawnFromTheCurve) {
  std::mt19937_64 random(1);
  const auto orientations = testing::random_sweep(random, 4);
  const auto curve = curve_of(orientations);
  const SphericalCurveFamily family(orientations, curve);
  const auto links = family.dyad_pair({0.2, 0.7});
  ASSERT_TRUE(links);
  EXPECT_EQ(links->input, curve->dyad(0.2));
  EXPECT_EQ(links->output, curve->dyad(0.7));
  EXPECT_TRUE(family.is_symmetric());
  EXPECT_EQ(family.axis(Side::input).coordinate_length(), curve->coordinate_length());
}

TEST(SphericalFamily, PointsFillTheirBranches) {
  const std::vector<SphericalDyad> dyads = {{{1, 0, 0}, {0, 1, 0}, 0.5}, {{0, 0, 1}, {0, 1, 0}, 1.5}};
  const SphericalPointFamily family(std::vector<PrescribedOrientation>(3), dyads);
  EXPECT_EQ(family.dyad(0.1)->fixed_axis, (Vector3{1, 0, 0}));
  EXPECT_EQ(family.dyad(1.9)->fixed_axis, (Vector3{0, 0, 1}));
  EXPECT_FALSE(family.dyad(2.0));
  EXPECT_FALSE(family.dyad(-0.1));
  EXPECT_TRUE(family.axis(Side::output).is_discrete());
}

TEST(SphericalFamily, HingesOfAMapAreItsAxes) {
  std::mt19937_64 random(2);
  const auto orientations = testing::random_sweep(random, 4);
  const SphericalCurveFamily family(orientations, curve_of(orientations));
  RegionMap map;
  const auto places = family.samples(Side::input, 20, Spacing::coordinate);
  family.classify(map, places, places, true);
  const MapPivots pivots = family.pivots(map);
  ASSERT_EQ(pivots.rows.size(), 20u);
  EXPECT_EQ(pivots.rows[3].ground, family.dyad(places[3])->fixed_axis);
  EXPECT_EQ(pivots.columns[5].moving, family.dyad(places[5])->moving_axis);
}

TEST(SphericalFamily, BarsHaveShortLinks) {
  std::mt19937_64 random(3);
  const auto orientations = testing::random_orientations(random, 4);
  const SphericalCurveFamily family(orientations, curve_of(orientations));
  for (double at = 0.03; at < 1; at += 0.07) {
    const LinkAngles l = four_bar_of(*family.dyad_pair({at, 1 - at})).angles();
    EXPECT_LE(l.input, 1.5708);
    EXPECT_LE(l.output, 1.5708);
    EXPECT_LE(l.coupler, 1.5708);
  }
}

}  // namespace
}  // namespace linkwright::spherical_family_test
