#include "linkwright/function/angle_pair.hpp"

#include <gtest/gtest.h>

namespace linkwright::angle_pair_test {
namespace {

TEST(AnglePair, CountsItsDerivativesAsPositions) {
  const std::vector<AnglePair> pairs = {{0, 0, {}}, {1, 2, {{1, 2}, {0, 1}}}, {2, 3, {{1, 1}}}};
  EXPECT_EQ(position_count(pairs), 6);
  EXPECT_EQ(pattern(pairs), "P-PPP-PP");
  EXPECT_NE(pairs[0], pairs[2]);
}

}  // namespace
}  // namespace linkwright::angle_pair_test
