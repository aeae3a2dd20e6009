#include "linkwright/core/precondition.hpp"

#include <gtest/gtest.h>

namespace linkwright::precondition_test {
namespace {

TEST(Precondition, ThatHoldsIsNotNoticed) { require(true, "never said"); }

TEST(PreconditionDeathTest, ThatIsBrokenIsSaidAndEndsTheProgram) {
  EXPECT_DEATH(require(false, "four rows are needed"), "broken precondition: four rows are needed");
}

}  // namespace
}  // namespace linkwright::precondition_test
