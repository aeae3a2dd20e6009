#include "linkwright/sweep/sweep_table.hpp"

#include <gtest/gtest.h>

namespace linkwright {
namespace sweep_table_test {
namespace {

SweepColumns columns() {
  return {{{count_column("sample", ""), number_column("x", "mm", "")},
           {flag_column("ok", "")},
           {text_column("word", 4, "")}}};
}

SweepRows rows() {
  SweepRows rows(columns());
  rows.of(SweepTable::samples).put(std::int64_t{7});
  rows.of(SweepTable::samples).put(2.5);
  rows.of(SweepTable::linkages).put(std::uint8_t{1});
  rows.of(SweepTable::failures).put("abüc", 4);
  return rows;
}

TEST(SweepTable, RowsComeBackFromTheirBytes) {
  SweepRows back(columns());
  ASSERT_TRUE(back.from_bytes(rows().to_bytes(), columns()));
  EXPECT_EQ(back, rows());
  EXPECT_EQ(back.of(SweepTable::samples).rows(), 1u);
}

TEST(SweepTable, TextIsCutBetweenCharacters) {
  EXPECT_EQ(rows().of(SweepTable::failures).bytes(0), "abü");
  SweepRows shorter(columns());
  shorter.of(SweepTable::failures).put("abcü", 4);
  EXPECT_EQ(shorter.of(SweepTable::failures).bytes(0), std::string("abc\0", 4));
}

TEST(SweepTable, BytesOfOtherColumnsAreRefused) {
  const std::string bytes = rows().to_bytes();
  SweepRows back(columns());
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_FALSE(back.from_bytes(bytes.substr(0, size), columns())) << size;
  EXPECT_FALSE(back.from_bytes(bytes + "x", columns()));
  EXPECT_FALSE(back.from_bytes(std::string(64, '\xff'), columns()));
}

TEST(SweepTable, RowsGrowByOthers) {
  SweepRows both = rows();
  both.append(rows());
  EXPECT_EQ(both.of(SweepTable::samples).rows(), 2u);
  EXPECT_EQ(both.of(SweepTable::samples).bytes(1).size(), 2 * sizeof(double));
}

}  // namespace
}  // namespace sweep_table_test
}  // namespace linkwright
