#include "linkwright/function/free_parameter.hpp"

#include <gtest/gtest.h>

namespace linkwright::free_parameter_test {
namespace {

TEST(FreeParameter, IsSpacedOverItsRange) {
  const FreeParameter scale;
  EXPECT_DOUBLE_EQ(scale.at(0), 0.5);
  EXPECT_DOUBLE_EQ(scale.at(0.5), 1) << "by its logarithm";
  EXPECT_DOUBLE_EQ(scale.at(1), 2);
  const FreeParameter output{FreeParameter::Kind::pair_output, {-1, 3}};
  EXPECT_DOUBLE_EQ(output.at(0.25), 0);
  for (const FreeParameter& free : {scale, output})
    for (const double t : {0.0, 0.3, 1.0}) EXPECT_NEAR(free.place_of(free.at(t)), t, 1e-15);
}

}  // namespace
}  // namespace linkwright::free_parameter_test
