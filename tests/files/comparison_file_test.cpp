#include "linkwright/files/comparison_file.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "linkwright/core/angle.hpp"
#include "linkwright/drawing/svg_drawing.hpp"
#include "linkwright/files/analysis_file.hpp"
#include "linkwright/mechanism/coupler_curve.hpp"

namespace linkwright::comparison_file_test {
namespace {

StoredLinkage crank_rocker() {
  StoredLinkage linkage =
      *read_linkage(R"({"lengths": {"ground": 4, "input": 1, "coupler": 3, "output": 3}, "point": [1.2, 2.5]})");
  linkage.length_unit = "mm";
  return linkage;
}

// On its path at every 20° of the input.
std::vector<MotionState> steps(const StoredLinkage& linkage) {
  auto states = motion_cycle(linkage.four_bar, *linkage.point, 19);
  states.pop_back();
  return states;
}

TEST(ComparisonFile, TellsPointsThatAreMovedOffThePath) {
  const StoredLinkage linkage = crank_rocker();
  std::vector<Point> points;
  for (const MotionState& state : steps(linkage)) points.push_back(state.coupler_point);
  const auto exact = compare_with_path(linkage, {}, *compared_path(points, true));
  ASSERT_TRUE(exact);
  EXPECT_LT(exact->path.error.max, 1e-9);
  EXPECT_TRUE(exact->drive.no_defects(true));
  points[4] += Point{0.3, 0.4};
  const auto off = compare_with_path(linkage, {}, *compared_path(points, true));
  ASSERT_TRUE(off);
  EXPECT_EQ(off->path.error.max_at, 4);
  EXPECT_LE(off->path.error.max, 0.5);
  EXPECT_GT(off->path.error.max, 0.01);
  EXPECT_EQ(off->path.at.size(), points.size());
}

TEST(ComparisonFile, CountsAnglesOfTheCrankWhereTheyAreGiven) {
  const StoredLinkage linkage = crank_rocker();
  PathTask task;
  double input = 0;
  for (const MotionState& state : steps(linkage)) {
    task.points.push_back({state.coupler_point, input, {}, {}, {}, {}});
    input += radians(20);
  }
  task.closed = true;
  EXPECT_LT(compare_with_path(linkage, {}, *compared_path(task))->path.error.max, 1e-9);
  for (std::size_t j = 3; j < 9; ++j) *task.points[j].input += radians(6);
  const auto late = compare_with_path(linkage, {}, *compared_path(task));
  ASSERT_TRUE(late);
  EXPECT_TRUE(late->path.timed);
  EXPECT_GT(late->path.error.max, 0.02);
  for (PathPoint& point : task.points) point.input.reset();
  EXPECT_LT(compare_with_path(linkage, {}, *compared_path(task))->path.error.max, 1e-9) << "at any time it is there";
}

TEST(ComparisonFile, LeavesOutRepeatedPointsAndKeepsTheirNumbers) {
  const StoredLinkage linkage = crank_rocker();
  std::vector<Point> points;
  for (const MotionState& state : steps(linkage)) points.push_back(state.coupler_point);
  points.insert(points.begin() + 2, points[1]);
  points[10] += Point{0, 0.4};
  const auto compared = compare_with_path(linkage, {}, *compared_path(points, false));
  ASSERT_TRUE(compared);
  EXPECT_EQ(compared->path.at.size(), points.size() - 1);
  EXPECT_EQ(compared->path.error.max_at, 10);
}

TEST(ComparisonFile, TellsWhatCannotBeCompared) {
  StoredLinkage linkage = crank_rocker();
  const auto path = compared_path({{0, 0}, {1, 0}, {1, 1}, {0, 2}}, false);
  ASSERT_TRUE(path);
  EXPECT_TRUE(compare_with_path(linkage, Point{1, 1}, *path));
  linkage.point.reset();
  EXPECT_EQ(compare_with_path(linkage, {}, *path).errors().front().code, "no_coupler_point");
  EXPECT_TRUE(compare_with_path(linkage, Point{1, 1}, *path));
  EXPECT_FALSE(compared_path({{0, 0}, {1, 0}}, false));
  PathTask timed;
  for (int k = 0; k < 4; ++k) timed.points.push_back({{k * 1.0, 0.3 * k * k}, 0.5 * (k % 2), {}, {}, {}, {}});
  EXPECT_FALSE(compared_path(timed)) << "the crank goes to and fro";
}

TEST(ComparisonFile, IsWrittenAsJsonTableAndPicture) {
  const StoredLinkage linkage = crank_rocker();
  LinkageAnalysis analysis = analyze(linkage);
  EXPECT_FALSE(nlohmann::json::parse(write_analysis(analysis)).contains("comparison"));
  analysis.comparison = *compare_with_path(linkage, {}, *compared_path({{0, 2}, {1, 2.5}, {2, 2.4}, {2.5, 2}}, false));
  const auto json = nlohmann::json::parse(write_analysis(analysis)).at("comparison");
  EXPECT_EQ(json.at("at").size(), 4);
  EXPECT_EQ(json.at("error").at("max_at"), analysis.comparison->path.error.max_at + 1);
  EXPECT_FALSE(json.at("closed"));
  const std::string table = comparison_table(*analysis.comparison);
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 5);
  EXPECT_EQ(table.substr(0, table.find('\n')), "point,x,y,path_x,path_y,distance,input_deg");
  EXPECT_NE(draw_comparison(linkage, *analysis.comparison).find("largest, at point"), std::string::npos);
}

}  // namespace
}  // namespace linkwright::comparison_file_test
