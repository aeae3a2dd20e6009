#include "linkwright/algebra/directed_line.hpp"

#include <gtest/gtest.h>

namespace linkwright {
namespace {

TEST(DirectedLine, MeasuresAlongAndToTheLeft) {
  const DirectedLine line{{3, -1}, {0.6, 0.8}};
  const Point here = line.point + 2.0 * line.direction + 5.0 * line.left();
  EXPECT_NEAR(std::abs(line.to_line(here) - Point(2, 5)), 0, 1e-14);
  EXPECT_NEAR(std::abs(line.to_fixed({2, 5}) - here), 0, 1e-14);
  EXPECT_NEAR(std::abs(line.left() - Point(-0.8, 0.6)), 0, 1e-15);
}

}  // namespace
}  // namespace linkwright
