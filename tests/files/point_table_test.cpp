#include "linkwright/files/point_table.hpp"

#include <gmock/gmock.h>
#include <string>

namespace linkwright::point_table_test {
namespace {

using ::testing::ElementsAre;

std::vector<Point> points(std::string_view text) {
  const auto read = read_point_table(text);
  EXPECT_TRUE(read) << (read ? "" : read.errors().front().message);
  return read ? *read : std::vector<Point>();
}
std::string code(std::string_view text) {
  const auto read = read_point_table(text);
  return read ? "" : read.errors().front().code + "@" + read.errors().front().place;
}

TEST(PointTable, TakesWhatProgramsWrite) {
  const auto three = ElementsAre(Point(1.5, 2), Point(-3, 4.25), Point(500, -0.25));
  EXPECT_THAT(points("1.5,2\n-3,4.25\n5e2,-.25\n"), three);
  EXPECT_THAT(points("1.5, 2\r\n-3, 4.25\r\n5e2, -.25"), three);
  EXPECT_THAT(points("\xEF\xBB\xBFx;y\n1,5;2\n-3;4,25\n5e2;-0,25\n"), three);
  EXPECT_THAT(points("x\ty\n1,5\t2\n-3\t4.25\n500\t-0.25"), three);
  EXPECT_THAT(points("# of a knee\n\n  1.5   2 \n-3 4,25\n\n500 -0.25\n"), three);
  EXPECT_THAT(points("\"x [mm]\",\"y [mm]\"\n1.5,2\n-3,4.25\n+500,-0.25"), three);
}

TEST(PointTable, TellsLinesThatAreNoPoints) {
  EXPECT_EQ(code("1,5,2,5\n2,5,3,5\n3,5,1,5\n"), "table_decimal_comma@line 1");
  EXPECT_EQ(code("0,0\n1,2,3\n4,5\n"), "table_columns@line 2");
  EXPECT_EQ(code("0,0\n1\n4,5\n"), "table_columns@line 2");
  EXPECT_EQ(code("0,0\n\n1,\n4,5\n"), "table_number@line 3");
  EXPECT_EQ(code("0,0\n1,two\n4,5\n"), "table_number@line 2");
  EXPECT_EQ(code("x,y\nx,y\n4,5\n"), "table_number@line 2") << "one heading is enough";
  EXPECT_EQ(code("0,0\n1,1e99\n4,5\n"), "table_number@line 2");
  EXPECT_EQ(code("0,0\n1,nan\n4,5\n"), "table_number@line 2");
  EXPECT_EQ(code("0,0\n1.2.3;4\n4,5\n"), "table_number@line 2");
  EXPECT_EQ(code("0,0\n1,2"), "table_of_too_few@");
  EXPECT_EQ(code(""), "table_of_too_few@");
  std::string many;
  for (int k = 0; k <= 100'000; ++k) many += "1,2\n";
  EXPECT_EQ(code(many), "table_of_too_much@");
}

std::string pose_code(std::string_view text) {
  const auto read = read_pose_table(text);
  return read ? "" : read.errors().front().code + "@" + read.errors().front().place;
}

TEST(PoseTable, TakesDegreesInTheThirdColumn) {
  for (const char* const text :
       {"x,y,theta_deg\n1.5,2,90\n-3,4.25,-180\n500,-0.25,0\n", "1,5;2;90\n-3;4,25;-180\n5e2;-0,25;0",
        "# knee\n1.5 2 90\n-3 4.25 -180\n500 -0.25 0"}) {
    EXPECT_TRUE(is_pose_table(text));
    const auto read = read_pose_table(text);
    ASSERT_TRUE(read) << read.errors().front().message;
    ASSERT_EQ(read->size(), 3u);
    EXPECT_EQ((*read)[0].origin, Point(1.5, 2));
    EXPECT_DOUBLE_EQ((*read)[0].angle, 1.5707963267948966);
    EXPECT_DOUBLE_EQ((*read)[1].angle, -3.141592653589793);
    EXPECT_EQ((*read)[2].origin, Point(500, -0.25));
  }
}

TEST(PoseTable, IsToldFromATableOfPointsByItsFirstNumbers) {
  EXPECT_TRUE(is_pose_table("0,0,0\n1,2,3\n"));
  EXPECT_FALSE(is_pose_table("0,0\n1,2,3\n"));
  EXPECT_FALSE(is_pose_table("\"x [mm]\",\"y [mm]\"\n0,0\n")) << "blanks in a heading part nothing";
  EXPECT_FALSE(is_pose_table(""));
  EXPECT_FALSE(is_pose_table("x,y,theta_deg\n"));
}

TEST(PoseTable, TellsLinesThatAreNoPoses) {
  EXPECT_EQ(pose_code("0,0,0\n1,2\n4,5,6\n"), "table_columns@line 2");
  EXPECT_EQ(pose_code("0,0,0\n1,2,\n4,5,6\n"), "table_number@line 2");
  EXPECT_EQ(pose_code("0,0,0\n1,2,nan\n4,5,6\n"), "table_number@line 2");
  EXPECT_EQ(pose_code("1,5,2,5,9,5\n"), "table_decimal_comma@line 1");
  EXPECT_EQ(pose_code("0,0,0\n1,2,3\n"), "table_of_too_few@");
}

}  // namespace
}  // namespace linkwright::point_table_test
