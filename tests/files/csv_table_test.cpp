#include "linkwright/files/csv_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>
#include <limits>
#include <map>
#include <sstream>

#include "linkwright/core/angle.hpp"
#include "support/file_support.hpp"

namespace linkwright::csv_table_test {
namespace {

constexpr FourBar crank_rocker{{0, 0}, {0, 2}, {4, 0}, {3, 3.5}};
constexpr FourBar triple_rocker{{0, 0}, {0, 5}, {4, 0}, {2, 6}};

std::vector<std::vector<std::string>> cells_of(const std::string& table) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    rows.emplace_back();
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
    if (line.back() == ',') rows.back().emplace_back();
  }
  return rows;
}

StoredLinkage stored(const FourBar& bars) {
  StoredLinkage linkage;
  linkage.four_bar = bars;
  return linkage;
}

std::map<std::string, std::vector<std::string>> columns_of(const StoredLinkage& linkage) {
  const auto rows = cells_of(motion_table(linkage));
  std::map<std::string, std::vector<std::string>> columns;
  for (std::size_t i = 1; i < rows.size(); ++i)
    for (std::size_t k = 0; k < rows[0].size(); ++k) columns[rows[0][k]].push_back(rows[i].at(k));
  return columns;
}

double number(const std::string& cell) { return std::strtod(cell.c_str(), nullptr); }

TEST(CsvTable, SaysAgainstWhatEachAngleIsMeasured) {
  // As it lies, the ground link points 40 degrees up.
  const Point turn = std::polar(1.0, radians(40));
  const FourBar turned{crank_rocker.input_fixed * turn, crank_rocker.input_moving * turn,
                       crank_rocker.output_fixed * turn, crank_rocker.output_moving * turn};
  auto columns = columns_of(stored(turned));
  EXPECT_EQ(columns.size(), 19u);
  const auto direction_of = [](Point from, Point to) { return degrees(std::arg(to - from)); };
  EXPECT_EQ(columns["driver_turn_from_position_1_deg"].front(), "0");
  EXPECT_NEAR(number(columns["input_angle_from_x_deg"].front()), direction_of(turned.input_fixed, turned.input_moving),
              1e-12);
  EXPECT_NEAR(number(columns["coupler_angle_from_x_deg"].front()),
              direction_of(turned.input_moving, turned.output_moving), 1e-12);
  EXPECT_NEAR(number(columns["output_angle_from_x_deg"].front()),
              direction_of(turned.output_fixed, turned.output_moving), 1e-12);
}

TEST(CsvTable, OfACrankHasARowADegree) {
  auto columns = columns_of(stored(crank_rocker));
  const auto& turns = columns["driver_turn_from_position_1_deg"];
  ASSERT_EQ(turns.size(), 361u);
  for (std::size_t i = 0; i < turns.size(); ++i) EXPECT_NEAR(number(turns[i]), static_cast<double>(i), 1e-9);
}

TEST(CsvTable, NumbersReadBackBitIdentical) {
  const StoredLinkage linkage = stored(crank_rocker);
  const auto cycle = tabulated_cycle(linkage);
  auto columns = columns_of(linkage);
  for (std::size_t i = 0; i < cycle.size(); ++i) {
    EXPECT_EQ(number(columns["body_x"][i]), cycle[i].body.origin.real());
    EXPECT_EQ(number(columns["output_rate"][i]), cycle[i].rates->output);
  }
}

TEST(CsvTable, RatesAreEmptyAtDeadPoints) {
  auto columns = columns_of(stored(triple_rocker));
  const auto& rates = columns["output_rate"];
  EXPECT_EQ(std::count(rates.begin(), rates.end(), ""), 2);
  EXPECT_NE(rates.front(), "");
}

TEST(CsvTable, BeginsAtPositionOneAndHasARowAtEachPosition) {
  StoredLinkage linkage = stored(testing::four_bars(testing::solved_tailgate()).linkages.front().four_bar);
  linkage.poses = testing::motion(testing::tailgate()).poses;
  auto columns = columns_of(linkage);
  std::vector<std::string> met;
  for (std::size_t i = 0; i < columns["position"].size(); ++i) {
    if (columns["position"][i].empty()) continue;
    met.push_back(columns["position"][i]);
    const Pose& pose = linkage.poses[met.size() - 1].pose;
    EXPECT_NEAR(number(columns["body_x"][i]), pose.origin.real(), 1e-6);
    EXPECT_NEAR(number(columns["body_y"][i]), pose.origin.imag(), 1e-6);
    EXPECT_NEAR(number(columns["body_theta_deg"][i]), degrees(pose.angle), 1e-6);
    EXPECT_LT(number(columns["position_error"][i]), 1e-6);
    EXPECT_LT(number(columns["orientation_error_deg"][i]), 1e-6);
  }
  EXPECT_EQ(met, (std::vector<std::string>{"1", "2", "3", "4"}));
  EXPECT_EQ(columns["position"].front(), "1");
}

TEST(CsvTable, OfALinkageWithAPointTellsWhereThatIs) {
  StoredLinkage linkage = stored(crank_rocker);
  linkage.point = Point{2, 5};
  auto columns = columns_of(linkage);
  ASSERT_EQ(columns.size(), 21u);
  EXPECT_EQ(columns["point_x"].front(), "2");
  EXPECT_EQ(columns["point_y"].front(), "5");
  const auto at = [&](const std::string& name, std::size_t row) {
    return Point{number(columns[name + "_x"][row]), number(columns[name + "_y"][row])};
  };
  for (std::size_t row = 0; row < columns["point_x"].size(); ++row) {
    EXPECT_NEAR(std::abs(at("point", row) - at("input_circle", row)), std::abs(*linkage.point - Point(0, 2)), 1e-12);
    EXPECT_NEAR(std::abs(at("point", row) - at("output_circle", row)), std::abs(*linkage.point - Point(3, 3.5)), 1e-12);
  }
}

TEST(CsvTable, TracesItsPointOrTheMovingFramesOrigin) {
  StoredLinkage linkage;
  linkage.four_bar = crank_rocker;
  EXPECT_EQ(traced_point(linkage), crank_rocker.input_moving);
  linkage.poses.push_back({{{7, 8}, 0}, {}});
  EXPECT_EQ(traced_point(linkage), Point(7, 8));
  linkage.point = Point{1, 9};
  EXPECT_EQ(traced_point(linkage), Point(1, 9)) << "the file's own";
}

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

TEST(MotionTable, IsALineARowAndNothingWhereNothingIsDefined) {
  const MotionTable table{{"turn_deg", "rate", "position"}, {0, 0.1, 1, 1.5, undefined, undefined}};
  EXPECT_EQ(table.rows(), 2u);
  EXPECT_EQ(csv_text(table), "turn_deg,rate,position\n0,0.1,1\n1.5,,\n");
}

TEST(MotionTable, WithoutRowsIsItsHeader) {
  EXPECT_EQ(csv_text({{"x", "y"}, {}}), "x,y\n");
  EXPECT_EQ(MotionTable{}.rows(), 0u);
}

}  // namespace
}  // namespace linkwright::csv_table_test
