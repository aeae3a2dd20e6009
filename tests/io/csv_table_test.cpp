#include "linkwright/io/csv_table.hpp"

#include <cstdlib>
#include <gtest/gtest.h>
#include <sstream>

#include "linkwright/core/angle.hpp"

namespace linkwright {
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

TEST(CsvTable, HasAHeaderAnd361Rows) {
  for (const FourBar& bars : {crank_rocker, triple_rocker}) {
    const auto rows = cells_of(motion_table(tabulated_motion(bars, bars.input_circle)));
    ASSERT_EQ(rows.size(), 362u);
    EXPECT_EQ(rows[0].size(), 14u);
    EXPECT_EQ(rows[0][0], "input_angle_deg");
    for (const auto& row : rows) EXPECT_EQ(row.size(), rows[0].size());
  }
}

TEST(CsvTable, NumbersReadBackBitIdentical) {
  const auto motion = tabulated_motion(crank_rocker, {1, 1});
  const auto rows = cells_of(motion_table(motion));
  for (std::size_t i = 0; i < motion.size(); ++i) {
    EXPECT_EQ(std::strtod(rows[i + 1][7].c_str(), nullptr), motion[i].coupler_point.real());
    EXPECT_EQ(std::strtod(rows[i + 1][11].c_str(), nullptr), motion[i].rates->output);
  }
}

TEST(CsvTable, OfACrankHasARowADegree) {
  const auto rows = cells_of(motion_table(tabulated_motion(crank_rocker, {1, 1})));
  const double first = std::strtod(rows[1][0].c_str(), nullptr);
  for (int i = 0; i <= 360; ++i) {
    EXPECT_NEAR(std::strtod(rows[static_cast<std::size_t>(i + 1)][0].c_str(), nullptr), first + i, 1e-9);
  }
}

TEST(CsvTable, RatesAreEmptyAtDeadPoints) {
  const auto rows = cells_of(motion_table(tabulated_motion(triple_rocker, {1, 1})));
  EXPECT_EQ(rows[1][10], "");
  EXPECT_NE(rows[90][10], "");
}

TEST(CsvTable, PivotsKeepTheirDistances) {
  const LinkLengths lengths = triple_rocker.lengths();
  for (const MotionState& state : tabulated_motion(triple_rocker, {1, 1})) {
    EXPECT_NEAR(state.four_bar.lengths().coupler, lengths.coupler, 1e-9);
    EXPECT_NEAR(state.four_bar.lengths().output, lengths.output, 1e-9);
    EXPECT_NEAR(std::abs(state.coupler_point - state.four_bar.input_circle),
                std::abs(Point(1, 1) - triple_rocker.input_circle), 1e-9);
  }
}

TEST(CsvTable, TracesTheMovingFramesOrigin) {
  StoredLinkage linkage;
  linkage.four_bar = crank_rocker;
  EXPECT_EQ(traced_point(linkage), crank_rocker.input_circle);
  linkage.poses.push_back({{{7, 8}, 0}, {}});
  EXPECT_EQ(traced_point(linkage), Point(7, 8));
}

}  // namespace
}  // namespace linkwright
