#include <gtest/gtest.h>

#include "linkwright/analyses/tolerance_study.hpp"
#include "linkwright/files/result_file.hpp"
#include "linkwright/synthesis/solve.hpp"
#include "support/file_support.hpp"

namespace linkwright::listed_study_test {
namespace {

std::string result_of(const char* example) {
  const Problem problem = testing::example(example, 60);
  return write_result(problem, *solve(problem), false);
}

TEST(ListedStudy, OfTwiceTheToleranceIsTwiceTheError) {
  const std::string result = result_of("tailgate.json");
  const auto fine = listed_study(result, 2, {0.1, 1000, 7}), coarse = listed_study(result, 2, {0.2, 1000, 7});
  ASSERT_TRUE(fine.ok()) << fine.errors().front().message;
  ASSERT_TRUE(coarse.ok()) << coarse.errors().front().message;
  EXPECT_NEAR(coarse->study.report.error, 2 * fine->study.report.error, 1e-12 * coarse->study.report.error);
  EXPECT_EQ(fine->study.tolerances.seed, 7u);
  EXPECT_EQ(fine->study.title, "Tailgate hinge, linkage 2");
  EXPECT_EQ(fine->place, 0u);
}

TEST(ListedStudy, RefusesAProblemWithoutTolerances) {
  const auto refused = listed_study(result_of("tailgate.json"), 1);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.errors().front().code, "no_tolerances");
}

TEST(ListedStudy, RefusesALinkageThatIsNotListed) {
  EXPECT_FALSE(listed_study(result_of("tailgate_as_made.json"), 99).ok());
}

}  // namespace
}  // namespace linkwright::listed_study_test
