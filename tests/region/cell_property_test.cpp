#include "linkwright/region/cell_property.hpp"

#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "support/case_region.hpp"
#include "support/planar_case.hpp"

namespace linkwright::cell_property_test {
namespace {

TEST(CellProperty, IsWhatTheMapSaysOfEachCell) {
  const RegionMap map = testing::region_of(testing::planar_case("landing_gear").poses, 60);
  std::vector<float> values(map.columns());
  const auto expect_values = [&](CellProperty property, const auto& value_of) {
    for (std::size_t row = 0; row < map.rows(); ++row) {
      row_values(map, property, row, values);
      for (std::size_t column = 0; column < map.columns(); ++column)
        ASSERT_EQ(values[column], static_cast<float>(value_of(row, column))) << key(property) << row << " " << column;
    }
  };
  expect_values(CellProperty::min_transmission_angle, [&](std::size_t row, std::size_t column) {
    return degrees(map.min_transmission_angle(map.index(row, column)));
  });
  expect_values(CellProperty::min_transmission_angle_full_turn, [&](std::size_t row, std::size_t column) {
    return degrees(map.min_transmission_angle_full_turn(map.index(row, column)));
  });
  expect_values(CellProperty::link_ratio,
                [&](std::size_t row, std::size_t column) { return map.link_ratios()[map.index(row, column)]; });
  expect_values(CellProperty::longest_link,
                [&](std::size_t row, std::size_t column) { return map.longest_links()[map.index(row, column)]; });
  expect_values(CellProperty::driver_sweep,
                [&](std::size_t row, std::size_t column) { return degrees(map.driver_sweep(row, column)); });
}

TEST(CellProperty, IsNamedAsInFiles) {
  EXPECT_EQ(cell_property_named("longest_link"), CellProperty::longest_link);
  EXPECT_EQ(key(CellProperty::min_transmission_angle), "min_transmission_angle_deg");
  EXPECT_FALSE(cell_property_named("colour"));
  EXPECT_TRUE(larger_is_better(CellProperty::min_transmission_angle));
  EXPECT_FALSE(larger_is_better(CellProperty::link_ratio));
}

}  // namespace
}  // namespace linkwright::cell_property_test
