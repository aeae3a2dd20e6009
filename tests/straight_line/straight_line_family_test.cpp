#include "linkwright/straight_line/straight_line_family.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/region/requirement_filter.hpp"
#include "linkwright/straight_line/straight_path.hpp"

namespace linkwright {
namespace {

using namespace straight_cases;

const LineAtAngle line({1.5, 2}, radians(20));
const StraightLineTask by_pivots{line, FourPointPivots{{0, 0}, {3, 0}}};

RegionMap map_of(const StraightLineFamily& family, int samples) {
  RegionMap map;
  family.classify(map, family.samples(Side::input, samples, Spacing::coordinate),
                  family.samples(Side::output, samples, Spacing::coordinate), true);
  return map;
}

TEST(StraightLineFamily, HasABranchToEachLayerOverTheSameNumbers) {
  const StraightLineFamily family(by_pivots, {});
  EXPECT_EQ(family.layers(), 2);
  EXPECT_EQ(family.layer_name(1), "alpha_plus_90");
  EXPECT_EQ(family.axis(Side::input).branches.size(), 2u);
  EXPECT_EQ(family.axis(Side::output).branches.size(), 1u);
  EXPECT_EQ(family.samples(Side::input, 10, Spacing::coordinate).size(), 20u);
  EXPECT_EQ(family.samples(Side::output, 10, Spacing::coordinate).size(), 10u);
  for (const int layer : {0, 1})
    for (const double u : {0.0, 60.0, 179.5, 180.0}) {
      const auto point = family.point_of({layer, {u, 120}});
      ASSERT_TRUE(point);
      const MapNumbers back = family.place_of(*point);
      EXPECT_EQ(back.layer, layer);
      EXPECT_NEAR(back.at[0], u, 1e-9);
      EXPECT_NEAR(back.at[1], 120, 1e-9);
    }
  EXPECT_FALSE(family.point_of({2, {60, 120}}));
  EXPECT_FALSE(family.point_of({0, {181, 120}}));
  const auto one = family.design(*family.point_of({0, {60, 120}})),
             other = family.design(*family.point_of({1, {60, 120}}));
  ASSERT_EQ(one.kind, DesignKind::four_bar);
  EXPECT_NEAR(std::abs(one.linkage.bars.input_moving - Point(1.350145, 2.33852)), 0, 1e-5);
  EXPECT_NEAR(std::abs(other.linkage.bars.input_moving - Point(0.453814, 0.786028)), 0, 1e-5);
}

TEST(StraightLineFamily, TakesItsRangesFromTheWindow) {
  const StraightLineTask task{line, IsoscelesTrapezoid{2}};
  const StraightLineFamily usual(task, {}), wider(task, {}, MapWindow{{-20, 30}, {-1, 1}});
  EXPECT_EQ(usual.range(Side::input), (std::array{-8.0, 8.0}));
  EXPECT_EQ(wider.range(Side::input), (std::array{-20.0, 30.0}));
  EXPECT_DOUBLE_EQ(wider.axis_value(Side::input, 0.5), 5);
  EXPECT_DOUBLE_EQ(wider.axis_value(Side::output, 0.25), -0.5);
  EXPECT_TRUE(wider.point_of({0, {25, 0.5}}));
  EXPECT_FALSE(usual.point_of({0, {25, 0.5}}));
}

TEST(StraightLineFamily, FillsItsMapWithWhatStandsThere) {
  const StraightLineFamily family(by_pivots, {});
  const RegionMap map = map_of(family, 40);
  EXPECT_EQ(map.rows(), 80u);
  int whole = 0, sliders = 0;
  for (std::size_t row = 0; row < map.rows(); ++row)
    for (std::size_t column = 0; column < map.columns(); ++column) {
      const std::size_t cell = map.index(row, column);
      const LineDesign there = family.design({map.input_coordinates()[row], map.output_coordinates()[column]});
      EXPECT_EQ(map.values(measures::valid)[cell], there.kind == DesignKind::four_bar ? 1.0F
                                                   : there.kind == DesignKind::slider ? 2.0F
                                                                                      : 0.0F);
      sliders += there.kind == DesignKind::slider;
      if (there.kind != DesignKind::four_bar) {
        EXPECT_EQ(map.type(cell), LinkageType::degenerate);
        continue;
      }
      ++whole;
      EXPECT_EQ(map.type(cell), linkage_type(there.linkage.bars.lengths()));
      EXPECT_NEAR(map.values(measures::longest_link)[cell], there.linkage.longest(), 1e-5 * there.linkage.longest());
      EXPECT_GE(map.values(measures::usable_strip)[cell], map.values(measures::usable_stroke)[cell]);
    }
  EXPECT_GT(whole, 3000);
  EXPECT_EQ(map.counts().pairs - map.counts().types[static_cast<std::size_t>(LinkageType::degenerate)], whole);
  const auto told = map.reported_measures();
  EXPECT_EQ(std::find(told.begin(), told.end(), measures::driver_sweep), told.end());
}

TEST(StraightLineFamily, IsFilteredByStrokeAndDeviation) {
  const StraightLineFamily family(by_pivots, {0.001, 0.8, LineMeasure::tangent});
  const RegionMap map = map_of(family, 40);
  Requirements wanted;
  wanted.max_length = 100;
  const auto meeting = [&] { return filter_of(family, map, wanted).census().meeting; };
  const auto all = meeting();
  wanted.min_stroke = 1;
  const auto long_ones = meeting();
  EXPECT_LT(long_ones, all);
  EXPECT_GT(long_ones, 0);
  wanted.min_stroke = 0;
  wanted.max_deviation = 0.0005;
  const auto straight_ones = meeting();
  EXPECT_LT(straight_ones, all);
  EXPECT_GT(straight_ones, 0);
  wanted.ground_pivots_within = Box{-1, 1, -1, 1};  // the output's is at (3, 0)
  EXPECT_EQ(meeting(), 0);
}

double apart(const TracingFourBar& a, const TracingFourBar& b) {
  return std::max(
      {std::abs(a.bars.input_fixed - b.bars.input_fixed), std::abs(a.bars.input_moving - b.bars.input_moving),
       std::abs(a.bars.output_fixed - b.bars.output_fixed), std::abs(a.bars.output_moving - b.bars.output_moving)});
}
TracingFourBar at(const StraightLineTask& task, double first, double second, int layer = 0) {
  const StraightLineFamily family(task, {});
  const LineDesign design = family.design(family.point_of({layer, {first, second}}).value());
  EXPECT_EQ(design.kind, DesignKind::four_bar);
  return design.linkage;
}

// 9.2 holds 10.1, and runs into its own special cases.
TEST(StraightLineFamily, RunsFromOneCaseIntoAnother) {
  const double tc = std::tan(radians(57)), ta = std::tan(radians(-30)), tb = std::tan(radians(40));
  const double td = -(ta + tb + 2 * tc) / (1 + ta * tb), mu = -ta * tb * td;
  const double diameter = 1 / std::sin(radians(57)), n = 1 / diameter / (tc + mu);
  const TracingFourBar five = at({line, FivePoint{1, radians(57)}}, -30, 40),
                       four = at({line, FourPointCubic{1, radians(57), 1 / n}}, -30, 40);
  EXPECT_LT(apart(five, four), 1e-12);

  // 10.3 is 9.5 with one length of the output link.
  const TracingFourBar on_frame = at({line, FivePointSideLinkOnFrame{1}}, 55, -20);
  const Point arm = on_frame.bars.output_moving - on_frame.bars.output_fixed;
  const Point tangent = -line.left() * std::conj(direction(radians(55)));
  EXPECT_NEAR(std::abs(cross(arm, tangent)), 0, 1e-12 * std::abs(arm));
  EXPECT_LT(apart(on_frame, at({line, PoleAtFixedPivot{1, dot(arm, tangent)}}, 55, -20)), 1e-10);

  // n and the cotangent of the point's ray vanish together, both links are symmetric: 9.4.
  const StraightLineTask trapezoid{line, IsoscelesTrapezoid{1}};
  const TracingFourBar symmetric = at(trapezoid, 1, 2);
  const double ray = 1e-7;  // off the pole normal
  const Point pole = line.point + (2.0 - 1.0) * -line.left();
  const auto ray_of = [&](Point fixed) {
    const Point t = -line.left() * std::conj(direction(pi / 2 - ray));
    double turn = degrees(std::atan2(cross(t, fixed - pole), dot(t, fixed - pole)));
    while (turn > 90) turn -= 180;
    while (turn <= -90) turn += 180;
    return turn;
  };
  const Point moving = symmetric.bars.input_moving - pole, t = -line.left() * std::conj(direction(pi / 2 - ray));
  const double m = cross(t, moving) / std::norm(moving), cubic_n = 1 / ((-1 - m) * std::tan(ray));
  const TracingFourBar general = at({line, FourPointCubic{-1, pi / 2 - ray, cubic_n}},
                                    ray_of(symmetric.bars.input_fixed), ray_of(symmetric.bars.output_fixed));
  EXPECT_LT(std::min(apart(symmetric, general), apart(symmetric, general.swapped())), 1e-5);
}

}  // namespace
}  // namespace linkwright
