#include "io/region_scale.hpp"

#include <gtest/gtest.h>

namespace linkwright {
namespace {

std::vector<Dyad> samples_at(std::initializer_list<double> coordinates) {
  std::vector<Dyad> samples;
  for (const double tau : coordinates) samples.push_back({{1, 0, 0}, {1, 0, 0}, tau});
  return samples;
}

const std::vector<CurveBranch> two_branches = {{"odd", 0, 1}, {"oval", 1, 2}};

TEST(RegionScale, HasABlockForEachBranchSeen) {
  const RegionScale scale(two_branches, samples_at({0.25, 0.75, 1.25, 1.75}), 104);
  ASSERT_EQ(scale.blocks().size(), 2u);
  EXPECT_EQ(scale.blocks()[0].branch, "odd");
  EXPECT_EQ(scale.blocks()[1].first, 2u);
  EXPECT_DOUBLE_EQ(scale.blocks()[0].to_px, 50);
  EXPECT_DOUBLE_EQ(scale.blocks()[1].from_px, 54);
  EXPECT_DOUBLE_EQ(scale.blocks()[1].to_px, 104);
  EXPECT_EQ(RegionScale(two_branches, samples_at({1.2, 1.3}), 100).blocks().size(), 1u);
  EXPECT_TRUE(RegionScale({}, {}, 100).blocks().empty());
}

TEST(RegionScale, FindsTheSampleOfAPixelAndBack) {
  const RegionScale scale(two_branches, samples_at({0.25, 0.75, 1.25, 1.75}), 104);
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
  EXPECT_FALSE(RegionScale(two_branches, samples_at({1.2, 1.3}), 100).position(0.5));
}

TEST(RegionScale, MarksWhereAPivotPassesInfinity) {
  auto samples = samples_at({0.1, 0.3, 0.5, 0.7});
  samples[0].center = {1, 10, 0};
  samples[1].center = {0.1, 10, 0};
  samples[2].center = {-0.1, 10, 0};
  samples[3].center = {-1, 10, 0};
  const RegionScale scale({{"odd", 0, 1}}, samples, 100);
  ASSERT_EQ(scale.crossings_of_infinity().size(), 1u);
  EXPECT_DOUBLE_EQ(scale.crossings_of_infinity()[0], 50);
  for (Dyad& sample : samples) sample.center = {1e-17 * (sample.coordinate - 0.4), 1, 0};  // a branch at infinity
  EXPECT_TRUE(RegionScale({{"line_at_infinity", 0, 1}}, samples, 100).crossings_of_infinity().empty());
}

}  // namespace
}  // namespace linkwright
