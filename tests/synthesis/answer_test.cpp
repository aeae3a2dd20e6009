#include "linkwright/synthesis/answer.hpp"

#include <gtest/gtest.h>

#include "support/file_support.hpp"
#include "support/tailgate.hpp"

namespace linkwright::answer_test {
namespace {

TEST(Answer, IsOfTheKindOfItsTask) {
  EXPECT_TRUE(std::holds_alternative<MotionAnswer>(testing::solved_tailgate()));
  EXPECT_TRUE(std::holds_alternative<FunctionAnswer>(testing::function().answer));
}

TEST(Answer, ItsFindingsAreTheSameWhateverTheKind) {
  for (const Answer* answer : {&testing::solved_tailgate(), &testing::function().answer}) {
    const FourBarAnswer& four_bars = testing::four_bars(*answer);
    EXPECT_EQ(&findings(*answer), &four_bars);
    EXPECT_EQ(linkage_count(*answer), four_bars.linkages.size());
    EXPECT_EQ(four_bars.pattern, four_bars.given.pattern);
    EXPECT_EQ(four_bars.family(), four_bars.given.family.get());
  }
}

TEST(Answer, PointsOfLinkagesLieOnTheMap) {
  const FourBarAnswer& answer = testing::four_bars(testing::solved_tailgate());
  for (const FourBarSolution& found : answer.linkages) {
    const auto links = answer.family()->dyad_pair(answer.point_of(found));
    ASSERT_TRUE(links.has_value());
    EXPECT_LT(std::abs(four_bar_of(*links)->lengths().ground * answer.characteristic_length / found.lengths.ground - 1),
              1e-9);
  }
}

TEST(Answer, StatusHasAName) {
  EXPECT_EQ(name(SolutionStatus::solved), "solved");
  EXPECT_EQ(name(SolutionStatus::degenerate), "degenerate");
}

}  // namespace
}  // namespace linkwright::answer_test
