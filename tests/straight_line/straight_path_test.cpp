#include "linkwright/straight_line/straight_path.hpp"

#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "support/straight_line_cases.hpp"

namespace linkwright::straight_path_test {
namespace {

TEST(StraightPath, IsThatOfTheCases) {
  int usable_ones = 0, strokes = 0, driven = 0;
  for (const auto& known : testing::straight_line_cases()) {
    SCOPED_TRACE(known.name);
    if (!known.json.contains("usable")) continue;
    ++usable_ones;
    const auto& usable = known.json.at("usable");
    const auto path = StraightPath::of({known.four_bar, known.point}, known.direction);
    ASSERT_TRUE(path);
    const double size = known.four_bar.lengths().longest();
    const UsableLine line = path->usable(usable.at("delta"));
    EXPECT_NEAR(line.from, usable.at("s_minus"), 1e-7 * size);
    EXPECT_NEAR(line.to, usable.at("s_plus"), 1e-7 * size);
    EXPECT_EQ(name(line.begin), usable.at("end_minus") == "dev" ? "deviation" : usable.at("end_minus"));
    EXPECT_EQ(name(line.end), usable.at("end_plus") == "dev" ? "deviation" : usable.at("end_plus"));
    const auto& strip = known.json.at("usable_strip");
    const UsableLine widest = path->usable_strip(strip.at("two_delta").get<double>() / 2);
    // The case's strips are sampled, and not always the longest.
    EXPECT_GT(widest.length(), 0.995 * strip.at("length").get<double>());
    EXPECT_LT(widest.length(), 1.03 * strip.at("length").get<double>());
    if (!known.json.contains("stroke") || known.json.at("stroke").is_null()) continue;
    const auto& stroke = known.json.at("stroke");
    if (!stroke.contains("S")) continue;
    ++strokes;
    const double half = stroke.at("S").get<double>() / 2;
    const auto report = path->stroke(-half, half);
    ASSERT_TRUE(report);
    EXPECT_NEAR(report->max_deviation, stroke.at("dev"), 1e-8 * size);
    EXPECT_NEAR(report->parallel_line_deviation, stroke.at("width").get<double>() / 2, 1e-8 * size);
    EXPECT_NEAR(report->best_line_deviation, stroke.at("best_line_width").get<double>() / 2, 1e-8 * size);
    EXPECT_NEAR(degrees(report->min_transmission_angle), stroke.at("min_transmission_deg"), 1e-6);
    ASSERT_EQ(report->drive.has_value(), !stroke.at("vel_nonuniformity").is_null());
    if (!report->drive) continue;
    ++driven;
    const double a = std::abs(stroke.at("vel_min").get<double>()), b = std::abs(stroke.at("vel_max").get<double>());
    EXPECT_NEAR(std::abs(degrees(report->drive->sweep)), stroke.at("drive_range_deg"), 1e-6);
    EXPECT_NEAR(report->drive->slowest, std::min(a, b), 1e-6 * b);
    EXPECT_NEAR(report->drive->fastest, std::max(a, b), 1e-6 * b);
  }
  EXPECT_GT(usable_ones, 15);
  EXPECT_GT(strokes, 5);
  EXPECT_GT(driven, 5);
}

// Watt's linkage: e(s) = s⁵ / 32 + …
const TracingFourBar watt{{{-2, -0.5}, {0, -0.5}, {2, 0.5}, {0, 0.5}}, 0};
constexpr Point up{0, 1};
// λ 1 : 3 : 4 : 4, its crank pointing away from the rocker: the input passes no dead point, the output does.
const TracingFourBar lambda{{{0, 0}, {-1, 0}, {3, 0}, {1, std::sqrt(12.0)}}, {3, std::sqrt(48.0)}};

TEST(StraightPath, IsThatOfALinkageThatKeepsItsLinks) {
  for (const auto& [linkage, along] : {std::pair(watt, up), std::pair(lambda, Point{1, 0})}) {
    const auto path = StraightPath::of(linkage, along);
    ASSERT_TRUE(path);
    EXPECT_EQ(path->begin(), PathEnd::turn);
    EXPECT_EQ(path->end(), PathEnd::turn);
    const LinkLengths lengths = linkage.bars.lengths();
    const double arm = std::abs(linkage.point - linkage.bars.input_moving);
    for (const StraightPath::State& state : path->states(101)) {
      const LinkLengths there = state.linkage.bars.lengths();
      EXPECT_NEAR(there.input, lengths.input, 1e-12);
      EXPECT_NEAR(there.coupler, lengths.coupler, 1e-11);
      EXPECT_NEAR(there.output, lengths.output, 1e-12);
      EXPECT_NEAR(std::abs(state.linkage.point - state.linkage.bars.input_moving), arm, 1e-12);
      EXPECT_NEAR(dot(along, state.linkage.point - linkage.point), state.s, 1e-11);
      EXPECT_NEAR(cross(along, state.linkage.point - linkage.point), state.e, 1e-11);
    }
  }
}

TEST(StraightPath, StripsHoldTheirStretchAndNoMore) {
  for (const auto& [linkage, along] : {std::pair(watt, up), std::pair(lambda, Point{1, 0})})
    for (const double deviation : {1e-5, 1e-3, 0.02}) {
      const auto path = StraightPath::of(linkage, along);
      const UsableLine strip = path->usable_strip(deviation);
      EXPECT_GE(strip.length(), path->usable(deviation).length() * (1 - 1e-9));
      const auto over = path->stroke(strip.from, strip.to);
      ASSERT_TRUE(over);
      EXPECT_NEAR(over->parallel_line_deviation, deviation, 1e-7 * deviation);
      EXPECT_LE(over->best_line_deviation, deviation * (1 + 1e-9));
    }
}

TEST(StraightPath, EndsWhereItsLimitsSay) {
  const auto path = StraightPath::of(watt, up, {1e-3, -0.3, 2});
  ASSERT_TRUE(path);
  EXPECT_EQ(path->begin(), PathEnd::travel);
  EXPECT_NEAR(path->from(), -0.3, 1e-13);
  EXPECT_EQ(path->end(), PathEnd::deviation);
  EXPECT_NEAR(path->states(2).back().e, 1e-3, 1e-13);
  EXPECT_FALSE(path->stroke(-0.4, 0.1));
  EXPECT_FALSE(path->stroke(0.1, 0.1));
}

TEST(StraightPath, DeviatesAsItsSeriesSays) {
  const auto path = StraightPath::of(watt, up, {1, -0.05, 0.05});
  const auto report = path->stroke(-0.05, 0.05);
  ASSERT_TRUE(report);
  const double fifth = std::pow(0.05, 5) / 32;
  EXPECT_NEAR(report->max_deviation, fifth + std::pow(0.05, 7) / 128, 1e-14);
  // The line k s nearest to s⁵ up to 1: 1 − k = 4/5 k (k/5)^¼, k = 0.6734.
  EXPECT_NEAR(report->best_line_deviation, 0.3266 * fifth, 1e-3 * fifth);
}

// A stroke of the λ linkage over its whole crank range: the minimum transmission angle as published.
TEST(StraightPath, LambdaRunsAsTheTableSays) {
  const auto path = StraightPath::of(lambda, {1, 0});
  const auto report = path->stroke(-1.35, 1.35);
  ASSERT_TRUE(report && report->drive);
  EXPECT_NEAR(report->max_deviation, 0.00087382, 5e-8);
  EXPECT_NEAR(degrees(report->min_transmission_angle), 56.1, 0.05);
  EXPECT_NEAR(std::abs(degrees(report->drive->sweep)), 92, 0.5);
}

TEST(StraightPath, ThereIsNoneOfAPointThatAllButRests) {
  const FourBar bars{
      {0, 0}, {3.7502345521529015, 9.052354397052609}, {-2.5, 4.5}, {1.1949251112630135, 9.154820081494467}};
  EXPECT_FALSE(StraightPath::of({bars, {6.628524572562647, 16}}, {1, 0})) << "the pole is 2e-7 away";
  EXPECT_TRUE(StraightPath::of({bars, {6.6, 16.5}}, {1, 0}));
}

TEST(StraightPath, ThereIsNoneAcrossThePathOrOfLinksInOneLine) {
  EXPECT_FALSE(StraightPath::of(watt, {1, 0}));
  EXPECT_FALSE(StraightPath::of({{{0, 0}, {1, 0}, {4, 0}, {3, 0}}, {2, 1}}, {1, 0}));
}

}  // namespace
}  // namespace linkwright::straight_path_test
