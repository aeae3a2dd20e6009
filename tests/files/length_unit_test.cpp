#include "linkwright/files/length_unit.hpp"

#include <gtest/gtest.h>
#include <utility>

namespace linkwright::length_unit_test {
namespace {

TEST(LengthUnit, IsKnownByName) {
  EXPECT_EQ(millimetres("mm"), 1);
  EXPECT_EQ(millimetres("m"), 1000);
  EXPECT_EQ(millimetres(" IN "), 25.4);
  EXPECT_EQ(millimetres("µm"), 1e-3);
  for (const char* name : {"furlong", "", " ", "ms", "mm cm", "."}) EXPECT_FALSE(millimetres(name)) << name;
}

TEST(LengthUnit, IsKnownHoweverItIsSpelled) {
  const std::pair<const char*, LengthUnit> spellings[] = {
      {"inch", {25.4, 1}},   {"Inches", {25.4, 1}},  {"in.", {25.4, 1}},      {"\"", {25.4, 1}},
      {"英寸", {25.4, 1}},   {"feet", {304.8, 2}},   {"foot", {304.8, 2}},    {"'", {304.8, 2}},
      {"MM", {1, 4}},        {"millimeter", {1, 4}}, {"millimetres", {1, 4}}, {"毫米", {1, 4}},
      {"metre", {1000, 6}},  {"meters", {1000, 6}},  {"Centimetre", {10, 5}}, {"yards", {914.4, 10}},
      {"thou", {0.0254, 9}}, {"km", {1e6, 7}}};
  for (const auto& [name, unit] : spellings) {
    const auto found = length_unit(name);
    ASSERT_TRUE(found) << name;
    EXPECT_EQ(found->mm, unit.mm) << name;
    EXPECT_EQ(found->insunits, unit.insunits) << name;
  }
}

TEST(LengthUnit, IsSaidAfterIn) {
  EXPECT_EQ(spoken_unit("in"), "inches");
  EXPECT_EQ(spoken_unit("mm"), "mm");
}

TEST(LengthUnit, IsAskedForWhereItIsNotKnown) {
  EXPECT_EQ(unit_warning("inches", "x"), "");
  EXPECT_EQ(unit_warning("furlong", "the drawing has none"),
            "the unit of length \"furlong\" is not known, so that the drawing has none");
  EXPECT_EQ(unit_warning("", "x"), "no unit of length is given, so that x");
}

TEST(LengthUnit, IsKnownByItsNumberInDrawings) {
  EXPECT_EQ(length_unit(1)->mm, 25.4);
  EXPECT_EQ(length_unit(13)->mm, 1e-3);
  for (const int number : {0, 11, 12, 15, -1}) EXPECT_FALSE(length_unit(number)) << number;
}

}  // namespace
}  // namespace linkwright::length_unit_test
