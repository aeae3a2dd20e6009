#include "synthesis/listed_linkages.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

#include "support/solved.hpp"
#include "support/tailgate.hpp"

namespace linkwright::listed_linkages_test {
namespace {

using testing::solved, testing::tailgate_requirements, testing::tailgate_task;

/// The best of the tailgate's, with links no longer than this.
MotionAnswer tailgates(int best, double max_length) {
  Requirements wanted = tailgate_requirements();
  wanted.max_length = max_length;
  SynthesisOptions options;
  options.region_samples = 80;
  options.best = best;
  return solved(tailgate_task(), wanted, options);
}

double worth(const FourBarSolution& linkage) { return linkage.report.min_transmission_angle; }

bool is_among(const FourBarSolution& linkage, const std::vector<FourBarSolution>& list) {
  return std::any_of(list.begin(), list.end(), [&](const FourBarSolution& other) {
    return other.input.coordinate == linkage.input.coordinate && other.output.coordinate == linkage.output.coordinate;
  });
}

TEST(MergedLists, HaveTheBestOfBothOnceBestFirst) {
  const MotionAnswer wide = tailgates(2, 450), narrow = tailgates(4, 300);
  ASSERT_EQ(wide.linkages.size(), 2U);
  ASSERT_EQ(narrow.linkages.size(), 4U);
  Answer merged = tailgates(2, 450);
  std::get<MotionAnswer>(merged).options.best = 6;
  merge_list(merged, tailgates(4, 300));
  const auto& linkages = std::get<MotionAnswer>(merged).linkages;
  EXPECT_LE(linkages.size(), 6U);
  EXPECT_GT(linkages.size(), 2U);
  EXPECT_EQ(worth(linkages.front()), std::max(worth(wide.linkages.front()), worth(narrow.linkages.front())));
  EXPECT_TRUE(std::is_sorted(linkages.begin(), linkages.end(),
                             [](const auto& a, const auto& b) { return worth(a) > worth(b) + 1e-9; }));
  for (const FourBarSolution& linkage : linkages)
    EXPECT_TRUE(is_among(linkage, wide.linkages) || is_among(linkage, narrow.linkages));
  for (const FourBarSolution& linkage : wide.linkages)
    EXPECT_TRUE(worth(linkage) <= worth(linkages.back()) || is_among(linkage, linkages));
}

TEST(MergedLists, OfOneListTwiceAreThatList) {
  const MotionAnswer once = tailgates(5, 450);
  Answer twice = tailgates(5, 450);
  merge_list(twice, tailgates(5, 450));
  const auto& linkages = std::get<MotionAnswer>(twice).linkages;
  ASSERT_EQ(linkages.size(), once.linkages.size());
  for (std::size_t i = 0; i < linkages.size(); ++i) {
    EXPECT_EQ(linkages[i].input.coordinate, once.linkages[i].input.coordinate);
    EXPECT_EQ(linkages[i].output.coordinate, once.linkages[i].output.coordinate);
  }
}

}  // namespace
}  // namespace linkwright::listed_linkages_test
