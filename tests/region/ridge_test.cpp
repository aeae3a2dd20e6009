#include "linkwright/region/ridge.hpp"

#include <gtest/gtest.h>

namespace linkwright::ridge_test {
namespace {

const std::vector<float> values = {1, 5, 3,  //
                                   4, 9, 2};
const std::vector<FailureBits> failures = {0, 0, 0,  //
                                           0, 1, 0};

TEST(Ridges, HoldTheBestOfEachRowAndColumn) {
  const Ridges found = ridges(values, failures, 3, true);
  EXPECT_EQ(found.input.value, (std::vector<float>{5, 4}));
  EXPECT_EQ(found.input.partner, (std::vector<std::uint32_t>{1, 0}));
  EXPECT_EQ(found.output.value, (std::vector<float>{4, 5, 3}));
  EXPECT_EQ(found.output.partner, (std::vector<std::uint32_t>{1, 0, 0}));
}

TEST(Ridges, SmallestWhereSmallerIsBetter) {
  const Ridges found = ridges(values, failures, 3, false);
  EXPECT_EQ(found.input.value, (std::vector<float>{1, 2}));
  EXPECT_EQ(found.output.partner, (std::vector<std::uint32_t>{0, 0, 1}));
}

TEST(Ridges, AreZeroWhereNothingPasses) {
  const Ridges found = ridges(values, std::vector<FailureBits>(6, 4), 3, true);
  EXPECT_EQ(found.input.value, (std::vector<float>{0, 0}));
  EXPECT_TRUE(ridges({}, {}, 0, true).input.value.empty());
}

}  // namespace
}  // namespace linkwright::ridge_test
