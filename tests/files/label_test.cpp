#include "linkwright/files/label.hpp"

#include <gtest/gtest.h>
#include <set>

namespace linkwright::label_test {
namespace {

TEST(Label, EveryTypeHasItsOwn) {
  std::set<std::string_view> labels, short_labels;
  for (std::size_t i = 0; i < linkage_type_names.size(); ++i) {
    labels.insert(label(static_cast<LinkageType>(i)));
    short_labels.insert(short_label(static_cast<LinkageType>(i)));
    EXPECT_LE(short_label(static_cast<LinkageType>(i)).size(), 22u);
  }
  EXPECT_EQ(labels.size(), linkage_type_names.size());
  EXPECT_EQ(short_labels.size(), linkage_type_names.size());
}

TEST(Label, FollowsTheEnumerators) {
  EXPECT_EQ(label(LinkageType::triple_rocker_coupler), "Triple rocker, coupler longest");
  EXPECT_EQ(label(DriveSense::cw), "clockwise");
  EXPECT_EQ(label(CubicKind::every_point), "every point");
  EXPECT_EQ(label(CubicKind::line_and_circle), "a line and a circle");
  EXPECT_EQ(label(ChangePointKind::rhombus), "rhombus");
  EXPECT_EQ(label(ChangePointKind::none), "");
  EXPECT_EQ(label(CubicConeKind::two_components), "a cubic cone of two components");
  EXPECT_EQ(label(CubicConeKind::every_axis), "every axis");
  EXPECT_EQ(label(SixBarTopology::watt_1), "Watt I");
  EXPECT_EQ(label(SixBarTopology::stephenson_3), "Stephenson III");
}

TEST(Label, OfAnUnknownBranchIsItsName) {
  EXPECT_EQ(branch_label("odd"), "branch through infinity");
  EXPECT_EQ(branch_label("sheet_2_opposite"), "sheet 2, opposite");
  EXPECT_EQ(branch_label("alpha_plus_90"), "α₀ + 90°");
  EXPECT_EQ(branch_label("something"), "something");
  EXPECT_EQ(cone_branch_label("odd"), "odd branch");
  EXPECT_EQ(cone_branch_label("great_circle"), "plane");
  EXPECT_EQ(cone_branch_label("something"), "something");
}

}  // namespace
}  // namespace linkwright::label_test
