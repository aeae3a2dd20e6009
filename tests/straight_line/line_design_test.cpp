#include "linkwright/straight_line/line_design.hpp"

#include <gtest/gtest.h>
#include <limits>

namespace linkwright {
namespace {

TEST(LineDesign, IsAFourBarASliderOrNothing) {
  const TracingFourBar hoecken{{{0, 0}, {-1, 0}, {2, 0}, {0.5, 2}}, {2, 4}};
  EXPECT_EQ(line_design(hoecken, 1).kind, DesignKind::four_bar);
  TracingFourBar far = hoecken;
  far.bars.output_fixed = {1e8, 0};
  EXPECT_EQ(line_design(far, 1).kind, DesignKind::slider);
  far.bars.output_fixed = {std::numeric_limits<double>::infinity(), 0};
  EXPECT_EQ(line_design(far, 1).kind, DesignKind::slider);
  far.bars.output_fixed = {std::numeric_limits<double>::quiet_NaN(), 0};
  EXPECT_EQ(line_design(far, 1).kind, DesignKind::none);
  TracingFourBar short_link = hoecken;
  short_link.bars.input_moving = {1e-8, 0};
  EXPECT_EQ(line_design(short_link, 1).kind, DesignKind::none);
  TracingFourBar no_arm = hoecken;
  no_arm.point = no_arm.bars.output_moving;
  EXPECT_EQ(line_design(no_arm, 1).kind, DesignKind::none);
}

}  // namespace
}  // namespace linkwright
