#include "linkwright/mechanism/dyad.hpp"

#include <gtest/gtest.h>

namespace linkwright::dyad_test {
namespace {

TEST(Dyad, IsASideLinkOrASliderByWhichPivotIsAtInfinity) {
  const Dyad grounded_link{Homogeneous::of({0, 0}), Homogeneous::of({1, 2}), 0.25};
  const Dyad on_a_fixed_line{Homogeneous::at_infinity({0, 1}), Homogeneous::of({1, 2}), 0.5};
  const Dyad with_a_moving_guide{Homogeneous::of({0, 0}), Homogeneous::at_infinity({1, 0}), 0.75};
  EXPECT_TRUE(finite_point(grounded_link.center) && finite_point(grounded_link.circle));
  EXPECT_FALSE(finite_point(on_a_fixed_line.center));
  EXPECT_TRUE(finite_point(on_a_fixed_line.circle));
  EXPECT_FALSE(finite_point(with_a_moving_guide.circle));
}

}  // namespace
}  // namespace linkwright::dyad_test
