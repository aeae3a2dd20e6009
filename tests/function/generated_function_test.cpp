#include "linkwright/function/generated_function.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "planar/function_linkage.hpp"
#include "support/random_four_bar.hpp"

namespace linkwright::generated_function_test {
namespace {

TEST(GeneratedFunction, ACrankReachesEverything) {
  const FourBar bars = testing::four_bar_at({1, 0.3, 0.9, 0.8}, 0.5, Assembly::negative);
  const GeneratedFunction generated = generated_function(bars, {2, 7, {}});
  EXPECT_TRUE(generated.reach().is_full_turn());
  EXPECT_NEAR(*generated.output_at(2, 7), 7, 1e-12);
  EXPECT_NEAR(*generated.output_at(2 + two_pi, 7 - two_pi), 7 - two_pi, 1e-12) << "the turn that was asked for";
  for (double input = -10; input < 10; input += 0.37) EXPECT_TRUE(generated.output_at(input, 0));
}

// Any forward kinematics will do: here a gear of ratio 2 that can be between -1 and 1.
TEST(GeneratedFunction, GoesAsFarAsItsInput) {
  const auto doubled = [](double input_angle) {
    return std::abs(input_angle) <= 1 ? std::optional(2 * input_angle) : std::nullopt;
  };
  const AngleRange range{-1, 1};
  const GeneratedFunction generated(doubled, {0.5, 1}, {&range, 1}, {10, 20, {}});
  EXPECT_NEAR(generated.reach().from, 8.5, 1e-12);
  EXPECT_NEAR(generated.reach().to, 10.5, 1e-12);
  EXPECT_NEAR(*generated.output_at(9, 20), 18, 1e-12);
  EXPECT_NEAR(*generated.output_at(9 + two_pi, 20), 18, 1e-12) << "whole turns do not count";
  EXPECT_FALSE(generated.output_at(10.6, 20));
}

TEST(GeneratedFunction, WithoutARangeReachesNothing) {
  const GeneratedFunction generated([](double) { return std::optional(0.0); }, {}, {}, {3, 0, {}});
  EXPECT_EQ(generated.reach().from, generated.reach().to);
  EXPECT_FALSE(generated.output_at(4, 0));
}

}  // namespace
}  // namespace linkwright::generated_function_test
