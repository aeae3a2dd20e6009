#include "linkwright/drawing/linkage_export.hpp"

#include <gtest/gtest.h>

#include "drawing/dxf_drawing.hpp"
#include "linkwright/drawing/svg_drawing.hpp"
#include "linkwright/files/csv_table.hpp"
#include "support/file_support.hpp"

namespace linkwright::linkage_export_test {
namespace {

TEST(LinkageExport, OfAFourBar) {
  StoredLinkage linkage;
  linkage.four_bar = testing::four_bars(testing::solved_tailgate()).linkages.front().four_bar;
  linkage.poses = testing::motion(testing::tailgate()).poses;
  EXPECT_EQ(exported(linkage, "svg"), draw_linkage(linkage));
  EXPECT_EQ(exported(linkage, "dxf"), draw_dxf(linkage));
  EXPECT_EQ(exported(linkage, "csv"), motion_table(linkage));
  EXPECT_EQ(exported(linkage, "json"), write_linkage(linkage));
}

TEST(LinkageExport, TellsLoadsOfAFourBarWithPoses) {
  StoredLinkage linkage;
  linkage.four_bar = testing::four_bars(testing::solved_tailgate()).linkages.front().four_bar;
  Loads loads;
  loads.springs = {{"", 1, {LoadedBody::ground, {100, 100}}, {LoadedBody::body, {0, 50}}, CoilSpring{}}};
  for (const char* format : {"svg", "dxf"}) EXPECT_EQ(exported(linkage, format, loads), exported(linkage, format));
  linkage.poses = testing::motion(testing::tailgate()).poses;
  EXPECT_EQ(exported(linkage, "svg", loads), draw_linkage(linkage, &loads));
  EXPECT_EQ(exported(linkage, "dxf", loads), draw_dxf(linkage, &loads));
  for (const char* format : {"svg", "dxf"}) EXPECT_NE(exported(linkage, format, loads), exported(linkage, format));
  for (const char* format : {"csv", "json"}) EXPECT_EQ(exported(linkage, format, loads), exported(linkage, format));
}

TEST(LinkageExport, OfASixBar) {
  StoredSixBar linkage;
  linkage.row = *six_bar_row({BodyPair{0, 2}, BodyPair{0, 3}});
  linkage.six_bar = SixBar::of({Point{0, 0}, Point{1, 0}, Point{3, 2}}, linkage.row.added, {Point{5, 0}, Point{4, 3}},
                               {Point{6, -4}, Point{8, 3}});
  EXPECT_EQ(exported(linkage, "svg"), draw_linkage(linkage));
  EXPECT_EQ(exported(linkage, "dxf"), draw_dxf(linkage));
  EXPECT_EQ(exported(linkage, "csv"), motion_table(tabulated_motion(linkage.six_bar, framed_poses(linkage))));
  EXPECT_EQ(exported(linkage, "json"), write_linkage(linkage));
}

TEST(LinkageExport, OfASphericalFourBar) {
  StoredSphericalFourBar linkage;
  linkage.four_bar = {{0, 0, 1}, {0, 0.6, 0.8}, {0.8, 0.6, 0}, {1, 0, 0}};
  EXPECT_EQ(exported(linkage, "svg"), draw_linkage(linkage));
  EXPECT_EQ(exported(linkage, "dxf"), "");
  EXPECT_EQ(exported(linkage, "csv"), motion_table(analyze(linkage)));
  EXPECT_EQ(exported(linkage, "json"), write_linkage(linkage));
}

}  // namespace
}  // namespace linkwright::linkage_export_test
