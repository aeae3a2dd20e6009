#include "linkwright/region/map_columns.hpp"

#include <cstdint>
#include <gtest/gtest.h>

namespace linkwright::map_columns_test {
namespace {

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
}  // namespace linkwright::map_columns_test
