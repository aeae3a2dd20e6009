#include <gtest/gtest.h>

#include "linkwright/synthesis/solve.hpp"

namespace linkwright::problem_test {
namespace {

TEST(Problem, AsksForAnyLinkageWithoutDefectsUnlessItSaysMore) {
  const Problem problem;
  EXPECT_TRUE(problem.requirements.no_defects);
  EXPECT_TRUE(problem.requirements.types.empty());
  EXPECT_EQ(problem.options.objective, Objective::min_transmission_angle);
  EXPECT_TRUE(mistakes_in(problem.options).empty());
  EXPECT_TRUE(mistakes_in(problem.requirements).empty());
}

}  // namespace
}  // namespace linkwright::problem_test
