#include "linkwright/core/result.hpp"

#include <cstddef>
#include <gtest/gtest.h>
#include <memory>
#include <string>
#include <vector>

namespace linkwright::result_test {
namespace {

Result<int> half(int number) {
  if (number % 2 != 0) return Error{"odd", "number", "the number is odd: give an even one", {{"number", number}}};
  return number / 2;
}

TEST(Result, HoldsAValue) {
  const Result<int> result = half(6);
  EXPECT_TRUE(result.ok());
  EXPECT_TRUE(result);
  EXPECT_EQ(*result, 3);
  EXPECT_EQ(result.value(), 3);
}

TEST(Result, HoldsTheMistakeWithItsPlaceAndTheWayOut) {
  const Result<int> result = half(7);
  ASSERT_FALSE(result);
  ASSERT_EQ(result.errors().size(), 1u);
  EXPECT_EQ(result.errors()[0].code, "odd");
  EXPECT_EQ(result.errors()[0].place, "number");
  EXPECT_EQ(std::get<double>(result.errors()[0].values.at(0).value), 7);
}

TEST(Result, HoldsAllMistakes) {
  const Result<int> result = std::vector<Error>{{"first", "", ""}, {"second", "", ""}};
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.errors().size(), 2u);
  EXPECT_EQ(result.errors()[1].code, "second");
}

TEST(Result, GivesUpAValueThatCannotBeCopied) {
  Result<std::unique_ptr<int>> result = std::make_unique<int>(5);
  const std::unique_ptr<int> value = std::move(result).value();
  EXPECT_EQ(*value, 5);
}

TEST(Result, LetsItsValueBeChanged) {
  Result<std::string> result = std::string("crank");
  result->append("_rocker");
  EXPECT_EQ(*result, "crank_rocker");
}

TEST(ResultDeathTest, AsksOfTheCallerToLookFirst) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_DEATH({ [[maybe_unused]] const auto& errors = half(6).errors(); }, "a result with a value has no errors");
  EXPECT_DEATH({ [[maybe_unused]] const int value = half(7).value(); }, "the value of a result is asked for");
  EXPECT_DEATH({ const Result<int> none = std::vector<Error>{}; }, "a result without a value says why");
}

TEST(Notice, HoldsNumbersAndWordsByName) {
  const Notice notice{"order_defect", "Order defect.", {{"order", "1-3-2-4"}, {"count", 4.0}}};
  EXPECT_EQ(std::get<std::string>(notice.values[0].value), "1-3-2-4");
  EXPECT_EQ(std::get<double>(notice.values[1].value), 4.0);
}

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
}  // namespace linkwright::result_test
