#define LINKWRIGHT_ISA isa_pack_test
#include "core/pack.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace linkwright::isa_pack_test::pack_test {
namespace {

constexpr double ulp = std::numeric_limits<double>::epsilon();

TEST(Pack, SineAndCosineAreThoseOfTheLibrary) {
  double worst = 0;
  for (int i = -200'000; i <= 200'000; ++i) {
    const double angle = i % 2 ? 0.000'71 * i : i * 1.570'796'326'794'896'6 / 4;  // the zeros among them
    const auto [sine, cosine] = sine_cosine<1>(angle);
    worst = std::max(
        {worst, std::abs(sine / std::sin(angle) - (i ? 1 : 0)) * (i ? 1 : 0), std::abs(cosine / std::cos(angle) - 1)});
    const Pack<2>::Real pair = {angle, -angle};
    const auto both = sine_cosine<2>(pair);
    ASSERT_EQ(both.sine[0], sine);
    ASSERT_EQ(both.sine[1], -sine);
    ASSERT_EQ(both.cosine[0], cosine);
    ASSERT_EQ(both.cosine[1], cosine);
  }
  EXPECT_LT(worst, 1.5 * ulp);
  EXPECT_EQ(sine_cosine<1>(0).sine, 0);
  EXPECT_TRUE(std::isnan(sine_cosine<1>(std::numeric_limits<double>::quiet_NaN()).sine));
}

TEST(Pack, CubeRootsAreEstimatedWithinTheirBound) {
  for (double a = 1e-30; a < 1e30; a *= 1.01) {
    EXPECT_NEAR(cube_root_estimate<1>(a) / std::cbrt(a), 1, 0.032);
    EXPECT_EQ(cube_root_estimate<2>(Pack<2>::Real{a, 1})[0], cube_root_estimate<1>(a));
  }
}

TEST(Pack, SignsAreTakenFromTheBit) {
  EXPECT_EQ(with_sign_of<1>(2, -3), -2);
  EXPECT_EQ(with_sign_of<1>(-2, 3), 2);
  EXPECT_EQ(with_sign_of<1>(2, -0.0), -2);
}

}  // namespace
}  // namespace linkwright::isa_pack_test::pack_test
