#include "drawing/region_scale.hpp"

#include <gtest/gtest.h>

namespace linkwright::region_scale_test {
namespace {

using Samples = std::vector<double>;

const std::vector<CurveBranch> two_branches = {{"odd", 0, 1}, {"oval", 1, 2}};

TEST(RegionScale, HasABlockForEachBranchSeen) {
  const RegionScale scale(two_branches, Samples{0.25, 0.75, 1.25, 1.75}, {}, 104);
  ASSERT_EQ(scale.blocks().size(), 2u);
  EXPECT_EQ(scale.blocks()[0].branch, "odd");
  EXPECT_EQ(scale.blocks()[1].first, 2u);
  EXPECT_DOUBLE_EQ(scale.blocks()[0].to_px, 50);
  EXPECT_DOUBLE_EQ(scale.blocks()[1].from_px, 54);
  EXPECT_DOUBLE_EQ(scale.blocks()[1].to_px, 104);
  EXPECT_EQ(RegionScale(two_branches, Samples{1.2, 1.3}, {}, 100).blocks().size(), 1u);
  EXPECT_TRUE(RegionScale({}, {}, {}, 100).blocks().empty());
}

TEST(RegionScale, FindsTheSampleOfAPixelAndBack) {
  const RegionScale scale(two_branches, Samples{0.25, 0.75, 1.25, 1.75}, {}, 104);
  EXPECT_EQ(scale.sample_at(0), 0);
  EXPECT_EQ(scale.sample_at(49.9), 1);
  EXPECT_EQ(scale.sample_at(52), -1);
  EXPECT_EQ(scale.sample_at(103.9), 3);
  EXPECT_EQ(scale.sample_at(104), -1);
  EXPECT_DOUBLE_EQ(*scale.position(0.25), 12.5);
  EXPECT_DOUBLE_EQ(*scale.position(0.5), 25);
  EXPECT_DOUBLE_EQ(*scale.position(1.75), 91.5);
  EXPECT_DOUBLE_EQ(*scale.position(0), 0);
  EXPECT_DOUBLE_EQ(*scale.position(2), 104);
  EXPECT_FALSE(RegionScale(two_branches, Samples{1.2, 1.3}, {}, 100).position(0.5));
}

TEST(RegionScale, MarksWhereAPivotPassesInfinity) {
  const Samples samples{0.1, 0.3, 0.5, 0.7};
  const Homogeneous circle{1, 0, 0};
  std::vector<Dyad> dyads = {
      {{1, 10, 0}, circle, 0.1}, {{0.1, 10, 0}, circle, 0.3}, {{-0.1, 10, 0}, circle, 0.5}, {{-1, 10, 0}, circle, 0.7}};
  const RegionScale scale({{"odd", 0, 1}}, samples, dyads, 100);
  ASSERT_EQ(scale.crossings_of_infinity().size(), 1u);
  EXPECT_DOUBLE_EQ(scale.crossings_of_infinity()[0], 50);
  for (Dyad& dyad : dyads) dyad.center = {1e-17 * (dyad.coordinate - 0.4), 1, 0};  // a branch at infinity
  EXPECT_TRUE(RegionScale({{"line_at_infinity", 0, 1}}, samples, dyads, 100).crossings_of_infinity().empty());
}

TEST(RegionScale, ABlockOfOneSampleIsOneCell) {
  const RegionScale scale({{"point", 0, 1}, {"point", 1, 2}}, Samples{0.5, 1.5}, {}, 104);
  ASSERT_EQ(scale.blocks().size(), 2u);
  EXPECT_DOUBLE_EQ(*scale.position(0.5), 25);
  EXPECT_DOUBLE_EQ(*scale.position(1.5), 79);
  EXPECT_FALSE(scale.position(2.2));
}

}  // namespace
}  // namespace linkwright::region_scale_test
