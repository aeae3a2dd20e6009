#include "linkwright/straight_line/line_shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "linkwright/straight_line/straight_line_search.hpp"
#include "straight_line/line_cases.hpp"
#include "straight_line/line_estimate.hpp"
#include "straight_line/placed_shape.hpp"
#include "support/draws.hpp"

namespace linkwright {
namespace {

LineShape drawn_shape(ShapeKind kind, std::mt19937& random) {
  std::uniform_real_distribution<double> share(0, 1);
  LineShape shape{kind, {}, static_cast<unsigned>(random() % 8)};
  for (std::size_t k = 0; k < number_count(kind); ++k) shape.numbers[k] = share(random);
  return shape;
}

TEST(LineShape, HasItsLinkagesOnItsLineWhereverItIsMovedAndHoweverLarge) {
  std::mt19937 random(3);
  const DirectedLine line{{7, -2}, std::polar(1.0, 0.8)};
  constexpr double scale = 3.5;
  for (std::size_t kind = 0; kind < shape_kind_count; ++kind)
    for (int i = 0; i < testing::draws(40); ++i) {
      const PlacedShape unit = placed(drawn_shape(static_cast<ShapeKind>(kind), random)),
                        there = moved(unit, scale, line, {0, 0});
      const LineDesigns before = designs_of_shape(unit), after = designs_of_shape(there);
      for (std::size_t layer = 0; layer < before.size(); ++layer) {
        if (before[layer].kind != DesignKind::four_bar) continue;
        ASSERT_EQ(after[layer].kind, DesignKind::four_bar);
        const TracingFourBar &one = before[layer].linkage, &other = after[layer].linkage;
        const double size = scale * one.longest();
        EXPECT_LT(std::abs(line.to_fixed(scale * one.point) - other.point), 1e-7 * size);
        EXPECT_LT(std::abs(line.to_fixed(scale * one.bars.output_moving) - other.bars.output_moving), 1e-7 * size);
      }
    }
}

TEST(LineShape, OfTheAtlasAreOfTheirKindAndHaveLinkages) {
  std::size_t count = 0;
  for (std::size_t k = 0; k < shape_kind_count; ++k) {
    const auto kind = static_cast<ShapeKind>(k);
    for (const auto& [shape, layer] : line_atlas(kind)) {
      EXPECT_EQ(shape.kind, kind);
      for (const double number : shape.numbers) EXPECT_TRUE(number >= 0 && number <= 1);
      EXPECT_EQ(designs_of_shape(placed(shape))[static_cast<std::size_t>(layer)].kind, DesignKind::four_bar);
      ++count;
    }
  }
  EXPECT_GT(count, 100u);
}

// Lengths as shares of the ground link.
TEST(LineShape, OfTheClassicsHaveThePublishedProportions) {
  const auto shares = [](const LineShape& shape) {
    const LineDesign design = designs_of_shape(placed(shape)).front();
    EXPECT_EQ(design.kind, DesignKind::four_bar);
    const LinkLengths lengths = design.linkage.bars.lengths();
    const auto share = [&](double length) { return length / lengths.ground; };
    return std::array{share(lengths.input), share(lengths.coupler), share(lengths.output),
                      share(std::abs(design.linkage.point - design.linkage.bars.input_moving)),
                      share(std::abs(design.linkage.point - design.linkage.bars.output_moving))};
  };
  const auto expect = [&](const LineShape& shape, const std::array<double, 5>& published) {
    for (const double number : shape.numbers) EXPECT_TRUE(number >= 0 && number <= 1);
    const auto ours = shares(shape);
    for (std::size_t i = 0; i < ours.size(); ++i) EXPECT_NEAR(ours[i], published[i], 1e-9) << i;
  };
  const auto tangent = line_classics(ShapeKind::two_tangencies);
  ASSERT_EQ(tangent.size(), 2u);
  expect(tangent[0], {0.5, 1.25, 1.25, 2.5, 1.25});   // Hoecken
  expect(tangent[1], {1.25, 0.5, 1.25, 0.25, 0.25});  // Chebyshev
  const double watts = std::hypot(4.0, 1.0);          // arms of 2 to either side of a coupler of 1
  expect(line_classics(ShapeKind::parallel_side_links).front(),
         {2 / watts, 1 / watts, 2 / watts, 0.5 / watts, 0.5 / watts});
  const auto roberts = shares(line_classics(ShapeKind::isosceles_trapezoid).front());
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(roberts[i], 0.5, 1e-9);
  for (const LineShape& evans : line_classics(ShapeKind::ball_point_on_frame)) {
    const TracingFourBar linkage = designs_of_shape(placed(evans)).front().linkage;
    const Point frame = linkage.bars.output_fixed - linkage.bars.input_fixed;
    EXPECT_NEAR(dot(frame, linkage.bars.output_moving - linkage.bars.output_fixed), 0, 1e-12);
    EXPECT_NEAR(cross(frame, linkage.point - linkage.bars.output_fixed), 0, 1e-12);
  }
}

TEST(LineShape, OfALinkageThatIsFoundHasItOnItsMap) {
  Requirements wanted;
  wanted.max_length = 1000;
  const DirectedLine line{{10, 20}, std::polar(1.0, 0.3)};
  const auto found = search_straight_lines(line, {100, 0.05}, wanted, {Objective::stroke, 6, 1, 0.01, 0});
  ASSERT_FALSE(found.linkages.empty());
  for (const StraightLineSolution& one : found.linkages) {
    ASSERT_TRUE(one.shape);
    const LineDesign design = designs_of_shape(placed(*one.shape))[static_cast<std::size_t>(one.place.layer)];
    ASSERT_EQ(design.kind, DesignKind::four_bar);
    const LinkLengths unit = design.linkage.bars.lengths();
    const double scale = one.linkage.longest() / design.linkage.longest();
    EXPECT_NEAR(one.lengths.ground, scale * unit.ground, 1e-7 * one.linkage.longest());
    EXPECT_NEAR(one.lengths.coupler, scale * unit.coupler, 1e-7 * one.linkage.longest());
  }
}

}  // namespace
}  // namespace linkwright
