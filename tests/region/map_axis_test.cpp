#include "linkwright/region/map_axis.hpp"

#include <gtest/gtest.h>

namespace linkwright::map_axis_test {
namespace {

const MapAxis two_branches = {AxisQuantity::curve_coordinate, {{"odd", 0, 1}, {"oval", 1, 2}}};

TEST(MapAxis, IsAsLongAsItsBranches) {
  EXPECT_EQ(two_branches.coordinate_length(), 2);
  EXPECT_EQ(MapAxis{}.coordinate_length(), 0);
}

TEST(MapAxis, KeepsAClimbOnABranch) {
  const AxisStretch stretch = two_branches.stretch_around(1.25);
  EXPECT_EQ(stretch.from, 1);
  EXPECT_EQ(stretch.to, 2);
  EXPECT_TRUE(stretch.closed);
  EXPECT_NEAR(stretch.onto(2.25), 1.25, 1e-15);
  const AxisStretch open = MapAxis{AxisQuantity::side_length, {{"", 0, 1}}}.stretch_around(0.5);
  EXPECT_EQ(open.onto(-3), 0);
  EXPECT_LT(open.onto(3), 1);
}

TEST(MapAxis, RunsRoundWhereItsBranchesClose) {
  EXPECT_NEAR(two_branches.onto(-0.75), 1.25, 1e-15);
  EXPECT_NEAR(two_branches.onto(2.25), 0.25, 1e-15);
  EXPECT_EQ(two_branches.onto(1.75), 1.75);
  const MapAxis open = {AxisQuantity::side_length, {{"", 0, 1}}};
  EXPECT_EQ(open.onto(-3), -3);
  EXPECT_EQ(open.onto(3), 3);
}

TEST(MapAxis, IsDiscreteWhereABranchIsOnePlace) {
  EXPECT_FALSE(two_branches.is_discrete());
  EXPECT_TRUE((MapAxis{AxisQuantity::burmester_point, {}}).is_discrete());
  EXPECT_TRUE((MapAxis{AxisQuantity::nothing, {}}).is_discrete());
}

TEST(MapAxis, IsNamedAsInFiles) {
  EXPECT_EQ(name(AxisQuantity::side_direction), "side_direction");
  EXPECT_EQ(name(AxisQuantity::nothing), "nothing");
  EXPECT_EQ(name(Spacing::coordinate), "coordinate");
  EXPECT_EQ(name(Spacing::arc_length), "arc_length");
}

}  // namespace
}  // namespace linkwright::map_axis_test
