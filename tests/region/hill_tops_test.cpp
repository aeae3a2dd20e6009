#include "linkwright/region/hill_tops.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace linkwright::hill_tops_test {
namespace {

TEST(HillTops, AreThoseThatNoneWithinReachBetters) {
  constexpr std::size_t side = 60;
  std::mt19937_64 random(5);
  std::vector<double> score(side * side);
  for (double& s : score) s = random() % 7 == 0 ? no_score : static_cast<double>(random() % 40);
  const auto group = [](std::size_t row, std::size_t column) { return (row / 20) * 10 + column / 30; };
  for (const std::size_t reach : {1u, 3u}) {
    const auto tops = hill_tops(
        side, side, {reach, score.size()}, [&](std::size_t r, std::size_t c) { return score[r * side + c]; },
        [&](std::size_t r, std::size_t c, std::size_t r2, std::size_t c2) { return group(r, c) == group(r2, c2); });
    std::size_t expected = 0;
    for (std::size_t r = 0; r < side; ++r)
      for (std::size_t c = 0; c < side; ++c) {
        bool top = score[r * side + c] > no_score;
        for (std::size_t r2 = r < reach ? 0 : r - reach; r2 <= std::min(r + reach, side - 1); ++r2)
          for (std::size_t c2 = c < reach ? 0 : c - reach; c2 <= std::min(c + reach, side - 1); ++c2)
            top = top && !((r2 != r || c2 != c) && group(r, c) == group(r2, c2) &&
                           ranks_before({r2, c2, score[r2 * side + c2]}, {r, c, score[r * side + c]}));
        expected += top;
      }
    EXPECT_EQ(tops.size(), expected);
    EXPECT_TRUE(std::is_sorted(tops.begin(), tops.end(), ranks_before));
  }
}

}  // namespace
}  // namespace linkwright::hill_tops_test
