#include "linkwright/mechanism/positions.hpp"

#include <gtest/gtest.h>

#include "linkwright/mechanism/pose.hpp"

namespace linkwright::positions_test {
namespace {

using Poses = std::vector<PrescribedPose>;

PrescribedPose with_derivatives(std::size_t count) { return {{}, std::vector<PoseDerivative>(count)}; }

TEST(Positions, PatternRepeatsPForEachDerivative) {
  EXPECT_EQ(pattern(Poses{{}, {}, {}, {}}), "P-P-P-P");
  EXPECT_EQ(pattern(Poses{with_derivatives(1), {}, {}}), "PP-P-P");
  EXPECT_EQ(pattern(Poses{{}, with_derivatives(2)}), "P-PPP");
  EXPECT_EQ(pattern(Poses{with_derivatives(3)}), "PPPP");
  EXPECT_EQ(pattern(Poses{}), "");
}

TEST(Positions, CountWithTheirMultiplicity) {
  EXPECT_EQ(position_count(Poses{}), 0);
  EXPECT_EQ(position_count(Poses{{}, {}, {}, {}}), 4);
  EXPECT_EQ(position_count(Poses{with_derivatives(1), {}, with_derivatives(1)}), 5);
}

}  // namespace
}  // namespace linkwright::positions_test
