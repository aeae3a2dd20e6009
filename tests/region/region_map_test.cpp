#include "linkwright/region/region_map.hpp"

#include <atomic>
#include <cstdint>
#include <gtest/gtest.h>
#include <new>

#include "linkwright/core/angle.hpp"
#include "support/draws.hpp"

// A kind of linkage that has no geometry: what a map does for any kind.
namespace linkwright::region_map_test {
namespace {

constexpr std::array<Measure, 2> kept = {measures::min_transmission_angle,
                                         Measure{"reach", Measure::Stored::as_it_is, true}};
const std::vector<double> rows = {0.25, 0.75}, columns = {0.25, 0.5, 0.75};

MapCell cell_at(std::size_t row, std::size_t column) {
  if (row == 1 && column == 2) return {};
  Defects defects;
  if (column == 1) defects.bits = 2;
  return {LinkageType::crank_rocker, defects, {1.0F, static_cast<float>(10 * row + column)}};
}

RegionMap judged(const RegionOptions& options = {}, const Progress& progress = {}) {
  RegionMap map;
  map.evaluate_cells(rows, columns, kept, {DriverTravel::cw, 1.0F}, cell_at, options, progress);
  return map;
}

TEST(RegionMap, KeepsVerdictAndMeasuresOfEachCell) {
  const RegionMap map = judged();
  ASSERT_EQ(map.rows(), 2u);
  ASSERT_EQ(map.columns(), 3u);
  EXPECT_EQ(map.type(map.index(0, 0)), LinkageType::crank_rocker);
  EXPECT_EQ(map.type(map.index(1, 2)), LinkageType::degenerate);
  EXPECT_EQ(map.defects(map.index(1, 1)).bits, 2);
  EXPECT_EQ(map.values(kept[1])[map.index(1, 1)], 11.0F);
  EXPECT_NEAR(map.min_transmission_angle(map.index(0, 0)), pi / 2, 1e-7);
  EXPECT_TRUE(map.values(measures::link_ratio).empty());
  EXPECT_EQ(map.reported_measures().back(), measures::driver_sweep);
}

TEST(RegionMap, TurnsTheDriverAsItsRowsSay) {
  const RegionMap map = judged();
  EXPECT_EQ(map.drive_sense(0, 0), DriveSense::cw);
  EXPECT_NEAR(map.driver_sweep(0, 0), two_pi - 1, 1e-6);
  EXPECT_EQ(map.drive_sense(0, 1), DriveSense::none);  // a defect
  EXPECT_EQ(map.driver_sweep(1, 2), 0);                // degenerate
}

TEST(RegionMap, CountsItsCellsWithoutTheDiagonal) {
  RegionMap map = judged();
  EXPECT_EQ(map.counts().pairs, 6);
  EXPECT_EQ(map.counts().defect_free, 3);
  map.set_diagonal({RegionMap::no_diagonal, 2});
  EXPECT_TRUE(map.is_diagonal(1, 2));
  EXPECT_FALSE(map.is_diagonal(0, 0));
  EXPECT_EQ(map.counts().pairs, 5);
  EXPECT_EQ(map.counts().types[static_cast<std::size_t>(LinkageType::degenerate)], 0);
}

TEST(RegionMap, RowsLeftOutAreDegenerate) {
  std::atomic<bool> stop{true};
  Progress progress;
  progress.cancelled = &stop;
  const RegionMap map = judged({.threads = 1}, progress);
  for (const std::uint8_t type : map.types()) EXPECT_EQ(type, static_cast<std::uint8_t>(LinkageType::degenerate));
  EXPECT_EQ(map.threads(), 1);
}

#ifndef LINKWRIGHT_SANITIZED  // sanitizers end the program where there is no memory
// More cells than there is memory: the last map is gone, and none takes its place.
TEST(RegionMap, IsEmptyWhereTheCellsDoNotFit) {
  RegionMap map = judged();
  const std::vector<double> many(std::size_t{1} << 24, 0.5);
  EXPECT_THROW(map.evaluate_cells(many, many, kept, {}, cell_at), std::bad_alloc);
  EXPECT_EQ(map.rows() * map.columns(), 0u);
}
#endif

TEST(Column, KeepsItsMemoryWhereTheSizeStays) {
  Column<float> column;
  EXPECT_TRUE(column.view().empty());
  column.resize(1000);
  column.data()[999] = 7;
  const float* const before = column.data();
  column.resize(1000);
  EXPECT_EQ(column.data(), before);
  EXPECT_EQ(column[999], 7);
  column.resize(10);
  EXPECT_EQ(column.view().size(), 10u);
}

TEST(Column, IsAlignedToTheCachesLines) {
  for (const std::size_t size : {1u, 100u, 5'000'000u}) {
    Column<std::uint8_t> column;
    column.resize(size);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(column.data()) % 64, 0u);
  }
}

}  // namespace
}  // namespace linkwright::region_map_test
