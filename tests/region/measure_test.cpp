#include "linkwright/region/measure.hpp"

#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "support/case_region.hpp"
#include "support/planar_case.hpp"

namespace linkwright::measure_test {
namespace {

TEST(Measure, IsWhatTheMapSaysOfEachCell) {
  const RegionMap map = testing::region_of(testing::planar_case("landing_gear").poses, 60);
  std::vector<float> values(map.columns());
  const auto expect_values = [&](const Measure& measure, const auto& value_of) {
    for (std::size_t row = 0; row < map.rows(); ++row) {
      row_values(map, measure, row, values);
      for (std::size_t column = 0; column < map.columns(); ++column)
        ASSERT_EQ(values[column], static_cast<float>(value_of(row, column))) << measure.key << row << " " << column;
    }
  };
  expect_values(measures::min_transmission_angle, [&](std::size_t row, std::size_t column) {
    return degrees(map.min_transmission_angle(map.index(row, column)));
  });
  expect_values(measures::min_transmission_angle_full_turn, [&](std::size_t row, std::size_t column) {
    return degrees(angle_of_versine(
        static_cast<double>(map.values(measures::min_transmission_angle_full_turn)[map.index(row, column)])));
  });
  expect_values(measures::link_ratio, [&](std::size_t row, std::size_t column) {
    return map.values(measures::link_ratio)[map.index(row, column)];
  });
  expect_values(measures::longest_link, [&](std::size_t row, std::size_t column) {
    return map.values(measures::longest_link)[map.index(row, column)];
  });
  expect_values(measures::driver_sweep,
                [&](std::size_t row, std::size_t column) { return degrees(map.driver_sweep(row, column)); });
}

TEST(Measure, IsKnownByItsKey) {
  EXPECT_EQ(measures::link_ratio, Measure{"link_ratio"});
  EXPECT_NE(measures::link_ratio, measures::longest_link);
  const RegionMap map = testing::region_of(testing::planar_case("landing_gear").poses, 8);
  EXPECT_TRUE(map.values(Measure{"colour"}).empty());
}

TEST(AngleOfVersine, IsPreciseAtBothEnds) {
  EXPECT_NEAR(angle_of_versine(1 - std::cos(1e-4)), 1e-4, 1e-10);
  EXPECT_NEAR(angle_of_versine(1), pi / 2, 1e-15);
  EXPECT_EQ(angle_of_versine(0), 0);
}

}  // namespace
}  // namespace linkwright::measure_test
