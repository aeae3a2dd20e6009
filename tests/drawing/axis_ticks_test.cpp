#include "drawing/axis_ticks.hpp"

#include <gtest/gtest.h>

#include "linkwright/straight_line/straight_line_family.hpp"
#include "support/file_support.hpp"

namespace linkwright::axis_ticks_test {
namespace {

using Ticks = std::vector<double>;

TEST(AxisTicks, AreRoundAndFarEnoughApart) {
  EXPECT_EQ(even_ticks(0, 10, 100, 20, false), (Ticks{0, 2, 4, 6, 8, 10}));
  EXPECT_EQ(even_ticks(-0.13, 0.08, 200, 24, false).size(), 4u) << "by 0.05";
  EXPECT_EQ(even_ticks(0, 360, 220, 27, true), (Ticks{0, 45, 90, 135, 180, 225, 270, 315, 360}));
  EXPECT_EQ(even_ticks(0, 8, 100, 20, true), (Ticks{0, 2, 4, 6, 8})) << "small angles as numbers";
  EXPECT_TRUE(even_ticks(1, 1, 100, 20, false).empty());
}

TEST(AxisTicks, AreFewWhereverTheAxisLies) {
  // Beyond 2^53 adding 1 changes nothing; the axis of a dial far from 0 has its ticks all the same.
  EXPECT_TRUE(even_ticks(1e18, 1e18 + 1024, 444, 27, false).empty());
  EXPECT_TRUE(even_ticks(-1e18, -1e18 + 1024, 444, 27, true).empty());
  EXPECT_EQ(even_ticks(1e8, 1e8 + 60, 200, 48, true), (Ticks{1e8 + 5, 1e8 + 20, 1e8 + 35, 1e8 + 50}));
  EXPECT_LT(even_ticks(0, 360, 1e15, 27, true).size(), 5000u) << "steps far below a pixel";
  EXPECT_LT(even_ticks(-1e300, 1e300, 444, 27, false).size(), 20u);
}

RegionScale scale_of(const LinkageFamily& family, Side side, int count) {
  return {family.axis(side).branches, family.samples(side, count, Spacing::coordinate), {}, 444};
}

TEST(AxisTicks, StandWhereTheirValuesAreRead) {
  const FourBarFamily& family = *testing::four_bars(testing::three_positions().answer).given.family;
  const RegionScale scale = scale_of(family, Side::output, 400);
  const std::vector<AxisTick> ticks = axis_ticks(scale, family, Side::output);
  ASSERT_GT(ticks.size(), 6u);
  for (const AxisTick& tick : ticks) {
    const int sample = scale.sample_at(tick.px);
    ASSERT_GE(sample, 0);
    const double value = family.axis_value(Side::output, scale.coordinates()[static_cast<std::size_t>(sample)]);
    EXPECT_NEAR(value, std::stod(tick.text), 3) << tick.text;
  }
  for (std::size_t i = 0; i + 1 < ticks.size(); ++i) EXPECT_GT(ticks[i + 1].px - ticks[i].px, 20);
}

TEST(AxisTicks, KeepApartAcrossSheets) {
  const Answer answer = testing::answer_of(testing::example("footrest.json", 60));
  const FourBarFamily& family = *testing::four_bars(answer).given.family;
  for (const Side side : {Side::input, Side::output}) {
    const RegionScale scale = scale_of(family, side, 400);
    const std::vector<AxisTick> ticks = axis_ticks(scale, family, side);
    for (std::size_t i = 0; i + 1 < ticks.size(); ++i)
      EXPECT_GT(ticks[i + 1].px - ticks[i].px, 26) << ticks[i].text << ' ' << ticks[i + 1].text;
  }
}

TEST(AxisTicks, OfCurvesAndOfFewSideLinksAreNone) {
  const FourBarFamily& curve = *testing::four_bars(testing::solved_tailgate()).given.family;
  EXPECT_TRUE(axis_ticks(scale_of(curve, Side::input, 100), curve, Side::input).empty());
  const FourBarFamily& points = *testing::four_bars(testing::five_positions().answer).given.family;
  EXPECT_TRUE(axis_ticks(scale_of(points, Side::input, 100), points, Side::input).empty());
}

TEST(AxisTicks, OfLengthsOfStraightLinesAreEvenBelowZeroToo) {
  const StraightLineFamily family({LineAtAngle{{0, 0}, 0}, straight_cases::ParallelSideLinks{-40, 40}}, {},
                                  MapWindow{{60, 400}, {-400, -60}});
  for (const auto& [side, last] : {std::pair(Side::input, "350"), std::pair(Side::output, "-100")}) {
    const auto ticks = axis_ticks(scale_of(family, side, 100), family, side);
    ASSERT_GE(ticks.size(), 4U);
    EXPECT_EQ(ticks.back().text, last);
    const double step = ticks[1].px - ticks[0].px;
    for (std::size_t i = 0; i + 1 < ticks.size(); ++i) EXPECT_NEAR(ticks[i + 1].px - ticks[i].px, step, 0.5);
  }
}

TEST(AxisTicks, OfAFactorAreSpacedByItsLogarithm) {
  const Problem problem = testing::problem_from(R"({"linkwright": 1, "options": {"region_samples": 8, "best": 0},
    "task": {"kind": "function", "mechanism": "four_bar", "pairs": [{"input_deg": 0, "output_deg": 0},
    {"input_deg": 30, "output_deg": 10}, {"input_deg": 50, "output_deg": 30}, {"input_deg": 70, "output_deg": 70}],
    "free": {"number": "output_scale", "range": [0.1, 10]}}})");
  const Answer answer = testing::answer_of(problem);
  const FourBarFamily& family = *testing::four_bars(answer).given.family;
  const auto ticks = axis_ticks(scale_of(family, Side::output, 100), family, Side::output);
  const auto one = std::find_if(ticks.begin(), ticks.end(), [](const AxisTick& tick) { return tick.text == "1"; });
  ASSERT_NE(one, ticks.end());
  EXPECT_NEAR(one->px, 222, 1);
}

}  // namespace
}  // namespace linkwright::axis_ticks_test
