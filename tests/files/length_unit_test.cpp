#include "linkwright/files/length_unit.hpp"

#include <gtest/gtest.h>

namespace linkwright::length_unit_test {
namespace {

TEST(LengthUnit, IsKnownByName) {
  EXPECT_EQ(millimetres("mm"), 1);
  EXPECT_EQ(millimetres("m"), 1000);
  EXPECT_EQ(millimetres(" IN "), 25.4);
  EXPECT_EQ(millimetres("µm"), 1e-3);
  EXPECT_FALSE(millimetres("furlong"));
  EXPECT_FALSE(millimetres(""));
}

}  // namespace
}  // namespace linkwright::length_unit_test
