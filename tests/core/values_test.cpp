#include "linkwright/core/values.hpp"

#include <cstddef>
#include <gtest/gtest.h>

namespace linkwright::values_test {
namespace {

TEST(Values, AreNumbersOfAnyKindAndWords) {
  const std::string_view word = "output";
  const Values values = {{"count", std::size_t{3}}, {"length", 2.5}, {"place", -1}, {"side", word}, {"axis", "x"}};
  EXPECT_EQ(std::get<double>(values[0].value), 3);
  EXPECT_EQ(std::get<double>(values[1].value), 2.5);
  EXPECT_EQ(std::get<double>(values[2].value), -1);
  EXPECT_EQ(std::get<std::string>(values[3].value), "output");
  EXPECT_EQ(std::get<std::string>(values[4].value), "x");
}

}  // namespace
}  // namespace linkwright::values_test
