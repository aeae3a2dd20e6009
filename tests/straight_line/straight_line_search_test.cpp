#include "linkwright/straight_line/straight_line_search.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/position.hpp"
#include "support/draws.hpp"

namespace linkwright {
namespace {

Requirements requirements(double max_length) {
  Requirements wanted;
  wanted.max_length = max_length;
  return wanted;
}

StraightLineSearchResult found(const straight_cases::Search& wanted, const Requirements& asked = requirements(1000),
                               const StraightLineSearchOptions& options = {}) {
  return search_straight_lines({{10, 20}, direction(0.3)}, wanted, asked, options);
}

// Largest distance from the line of the point over the stroke, by assembling the links at many input angles: shares
// nothing with the series that the path is made of.
double farthest_off(const StraightLineSolution& of, const DirectedLine& line, double half) {
  const LinkLengths lengths = of.linkage.bars.lengths();
  const Point arm = (of.linkage.point - of.linkage.bars.input_moving) /
                    (of.linkage.bars.output_moving - of.linkage.bars.input_moving);
  double farthest = 0, reached_low = 0, reached_high = 0;
  const auto path = StraightPath::of(of.linkage, of.task.line.direction);
  for (const auto& state : path->states(4001)) {
    const auto now =
        assemble(lengths, configuration_of(state.linkage.bars).input_angle, assembly_of(state.linkage.bars));
    if (!now) continue;
    const FourBar bars = placed(of.linkage.bars, *now);
    const Point at = line.to_line(bars.input_moving + arm * (bars.output_moving - bars.input_moving));
    if (std::abs(at.real()) > half) continue;
    farthest = std::max(farthest, std::abs(at.imag()));
    reached_low = std::min(reached_low, at.real());
    reached_high = std::max(reached_high, at.real());
  }
  EXPECT_LT(reached_low, -0.99 * half);
  EXPECT_GT(reached_high, 0.99 * half);
  return farthest;
}

TEST(StraightLineSearch, FindsLinkagesThatRunStraightWhereTheyAreWanted) {
  const DirectedLine line{{10, 20}, direction(0.3)};
  constexpr std::array deviations = {0.05, 0.005, 1.0};
  for (int i = 0; i < testing::draws(3); ++i) {
    const double deviation = deviations[static_cast<std::size_t>(i)];
    const auto result = found({100, deviation});
    ASSERT_EQ(result.linkages.size(), 10u);
    double before = 0;
    for (const StraightLineSolution& one : result.linkages) {
      ASSERT_TRUE(one.stroke);
      EXPECT_GE(one.usable_strip.length(), 100);
      EXPECT_LE(one.stroke->parallel_line_deviation, deviation * (1 + 1e-9));
      EXPECT_LE(farthest_off(one, line, 50), deviation * (1 + 1e-4));
      EXPECT_TRUE(one.verified_by_driving);
      EXPECT_GE(one.contact.points, promised_contact(one.task.given));
      EXPECT_GE(one.linkage.longest(), before * (1 - 1e-12));
      before = one.linkage.longest();
      // The place on the map of its case is where the same linkage is.
      const StraightLineFamily family(one.task, {deviation, 100, LineMeasure::strip});
      const auto point = family.point_of(one.place);
      ASSERT_TRUE(point);
      const LineDesign design = family.design(*point);
      ASSERT_EQ(design.kind, DesignKind::four_bar);
      EXPECT_LT(std::abs(design.linkage.bars.output_moving - one.linkage.bars.output_moving), 1e-9 * before);
    }
  }
}

struct Classical {
  std::string name;
  TracingFourBar linkage;
  double from = 0, to = 0;  // s
};

// A four-bar by its lengths with the input at an angle, its point at shares of the coupler along it and to its left.
TracingFourBar laid(const LinkLengths& lengths, double input_angle, Assembly assembly, Point share) {
  const FourBar frame{0, lengths.input, lengths.ground, lengths.ground + lengths.output};
  const FourBar bars = placed(frame, *assemble(lengths, input_angle, assembly));
  return {bars, bars.input_moving + share * (bars.output_moving - bars.input_moving)};
}

// Scaled to their stroke and measured by the best line, none is smaller than what is found.
TEST(StraightLineSearch, IsAtLeastAsGoodAsTheClassics) {
  const double root = std::sqrt(3.0);
  const TracingFourBar watt{{{-2, 0.5}, {0, 0.5}, {2, -0.5}, {0, -0.5}}, 0};
  const TracingFourBar evans{{{0, 3.6}, {0, 3.75}, {0, 3}, {-1.2, 3}}, 0};
  const std::vector<Classical> classics = {
      {"Chebyshev 4:5:2:5", {{{-2, 0}, {1, 4}, {2, 0}, {-1, 4}}, {0, 4}}, -1.9999, 1.9999},
      {"Hoecken 1:2:2.5", laid({2, 1, 2.5, 2.5}, pi, Assembly::negative, 2), -1.9999, 1.9999},
      {"lambda 1:3:4:4", {{0, -1, 3, {1, std::sqrt(12.0)}}, {3, std::sqrt(48.0)}}, -1.35, 1.35},
      {"Roberts", {{{-1, 0}, {-0.5, -root / 2}, {1, 0}, {0.5, -root / 2}}, {0, 0}}, -0.5, 0.5},
      {"Watt", watt, -0.5, 0.5},
      {"Evans", evans, -0.4, 0.4}};
  for (int i = 0; i < testing::draws(6); ++i) {
    const Classical& classic = classics[static_cast<std::size_t>(i)];
    const Point along = classic.name == "Watt" ? Point{0, 1} : Point{1, 0};
    const auto path = StraightPath::of(classic.linkage, along);
    ASSERT_TRUE(path) << classic.name;
    const auto report = path->stroke(std::max(classic.from, path->from()), std::min(classic.to, path->to()));
    ASSERT_TRUE(report) << classic.name;
    const double length = report->to - report->from, stroke = 100;
    Requirements wanted = requirements(3000);
    wanted.min_transmission_angle = report->min_transmission_angle;
    const auto result = found({stroke, report->best_line_deviation / length * stroke}, wanted);
    ASSERT_FALSE(result.linkages.empty()) << classic.name;
    const double theirs = classic.linkage.longest() / length * stroke;
    EXPECT_LE(result.linkages.front().linkage.longest(), theirs) << classic.name;
    EXPECT_GE(result.linkages.front().stroke->min_transmission_angle, report->min_transmission_angle * (1 - 1e-9));
  }
}

TEST(StraightLineSearch, KeepsTheRequirements) {
  Requirements wanted = requirements(400);
  wanted.ground_pivots_within = Box{-150, 60, -160, 10};
  wanted.min_transmission_angle = radians(25);
  wanted.types = {LinkageType::crank_rocker, LinkageType::rocker_crank, LinkageType::double_rocker};
  const auto result = found({100, 0.1}, wanted);
  EXPECT_GT(result.linkages.size(), 1u);
  for (const StraightLineSolution& one : result.linkages) {
    EXPECT_TRUE(wanted.ground_pivots_within->contains(one.linkage.bars.input_fixed));
    EXPECT_TRUE(wanted.ground_pivots_within->contains(one.linkage.bars.output_fixed));
    EXPECT_GE(one.stroke->min_transmission_angle, radians(25));
    EXPECT_LE(one.linkage.longest(), 400);
    EXPECT_NE(std::find(wanted.types.begin(), wanted.types.end(), one.type), wanted.types.end());
  }
  wanted.max_length = 60;
  EXPECT_TRUE(found({100, 0.001}, wanted).linkages.empty());
}

// Of each shape the smallest has the deviation that is asked for: all are as straight, and the list is no other.
TEST(StraightLineSearch, RanksByTheDeviationAsByTheStroke) {
  StraightLineSearchOptions by_stroke, by_deviation;
  by_stroke.effort = by_deviation.effort = 0.1;
  by_deviation.objective = Objective::deviation;
  const auto a = found({100, 0.05}, requirements(1000), by_stroke),
             b = found({100, 0.05}, requirements(1000), by_deviation);
  ASSERT_FALSE(a.linkages.empty());
  ASSERT_EQ(a.linkages.size(), b.linkages.size());
  for (std::size_t i = 0; i < a.linkages.size(); ++i)
    EXPECT_EQ(a.linkages[i].linkage.bars.input_moving, b.linkages[i].linkage.bars.input_moving);
}

// Its strip is the stroke but for rounding.
TEST(StraightLineSearch, KeepsLimitsThatAreWhatItLooksFor) {
  Requirements wanted = requirements(1000);
  wanted.min_stroke = 100;
  wanted.max_deviation = 0.05;
  StraightLineSearchOptions options;
  options.effort = 0.1;
  const auto free = found({100, 0.05}, requirements(1000), options), limited = found({100, 0.05}, wanted, options);
  EXPECT_EQ(free.linkages.size(), limited.linkages.size());
  wanted.max_deviation = 0.049;
  EXPECT_TRUE(found({100, 0.05}, wanted, options).linkages.empty());
}

TEST(StraightLineSearch, IsTheSameForAnyNumberOfThreadsAndEndsWhenItIsTold) {
  StraightLineSearchOptions one, two;
  one.threads = 1;
  two.threads = 2;
  one.effort = two.effort = 0.1;
  const auto a = found({100, 0.05}, requirements(1000), one), b = found({100, 0.05}, requirements(1000), two);
  ASSERT_EQ(a.linkages.size(), b.linkages.size());
  for (std::size_t i = 0; i < a.linkages.size(); ++i)
    EXPECT_EQ(a.linkages[i].linkage.bars.input_moving, b.linkages[i].linkage.bars.input_moving);
  const std::atomic<bool> cancelled = true;
  const auto none =
      search_straight_lines({}, {100, 0.05}, requirements(1000), {}, {.report = {}, .cancelled = &cancelled});
  EXPECT_TRUE(none.interrupted);
  EXPECT_EQ(none.drawn, 0);
}

}  // namespace
}  // namespace linkwright
