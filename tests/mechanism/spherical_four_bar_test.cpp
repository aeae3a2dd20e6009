#include "linkwright/mechanism/spherical_four_bar.hpp"

#include <gtest/gtest.h>
#include <random>

#include "linkwright/core/angle.hpp"
#include "support/attitude_case.hpp"

namespace linkwright::spherical_four_bar_test {
namespace {

TEST(SphericalFourBar, LinksAreTheAnglesBetweenItsAxes) {
  const SphericalFourBar bars{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {0, 1, 1}};
  const LinkAngles l = bars.angles();
  EXPECT_NEAR(l.ground, pi / 4, 1e-15);
  EXPECT_NEAR(l.input, pi / 2, 1e-15);
  EXPECT_NEAR(l.coupler, pi / 2, 1e-15);
  EXPECT_NEAR(l.output, pi / 4, 1e-15);
  EXPECT_NEAR(l.sum(), 1.5 * pi, 1e-15);
  EXPECT_EQ(bars.swapped().swapped(), bars);
  EXPECT_EQ(bars.swapped().angles().input, l.output);
}

TEST(SphericalFourBar, SensesAreChosenForShortLinks) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 500; ++i) {
    const SphericalFourBar bars{testing::random_direction(random), testing::random_direction(random),
                                testing::random_direction(random), testing::random_direction(random)};
    const SphericalFourBar chosen = with_short_links(bars);
    const LinkAngles l = chosen.angles(), before = bars.angles();
    for (const double arc : {l.input, l.coupler, l.output}) EXPECT_LE(arc, pi / 2 + 1e-15);
    // The same lines: each angle or its supplement.
    for (std::size_t k = 0; k < 4; ++k)
      EXPECT_NEAR(std::min(l.all()[k], pi - l.all()[k]), std::min(before.all()[k], pi - before.all()[k]), 1e-15);
  }
}

TEST(LinkAngles, AnAngleAndItsSupplementAreTheSameLink) {
  const LinkAngles l{2.9, 0.4, 1.2, 1.9};
  EXPECT_DOUBLE_EQ(l.shortest(), pi - 2.9);
  EXPECT_DOUBLE_EQ(l.longest(), pi - 1.9);
  EXPECT_DOUBLE_EQ((LinkAngles{1, 0.3, 1.5, 1}).shortest(), 0.3);
  EXPECT_DOUBLE_EQ((LinkAngles{1, 0.3, 1.5, 1}).longest(), 1.5);
}

TEST(SphericalDyad, NoneMakesNothing) {
  EXPECT_EQ(no_spherical_dyad(0.3).fixed_axis, Vector3{});
  EXPECT_EQ(no_spherical_dyad(0.3).coordinate, 0.3);
  EXPECT_NEAR((SphericalDyad{{1, 0, 0}, {0, 0, 1}, 0}).angle(), pi / 2, 1e-15);
}

}  // namespace
}  // namespace linkwright::spherical_four_bar_test
