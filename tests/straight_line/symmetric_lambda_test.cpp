#include "straight_line/symmetric_lambda.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "algebra/polynomial_roots.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/straight_line/straight_path.hpp"
#include "support/straight_line_cases.hpp"

namespace linkwright::symmetric_lambda_test {
namespace {

// The point of a λ of crank 1 at a crank angle from the middle of its stroke, by angles: the crank's pin and the point
// are seen from the output's centre at a right angle.
Point point_at(double ground, double link, double angle) {
  const Point pin = -std::polar(1.0, -angle) - Point{ground, 0};
  return ground + Point{0, -1} * pin / std::abs(pin) * std::sqrt(4 * link * link - std::norm(pin));
}

// What its height ranges over, over the stroke.
double range_over_stroke(double ground, double link, double crank_range) {
  double low = 1e9, high = 0;
  constexpr int steps = 4000;
  for (int i = 0; i <= steps; ++i) {
    const double y = point_at(ground, link, crank_range / 2 * i / steps).imag();
    low = std::min(low, y);
    high = std::max(high, y);
  }
  const double stroke = 2 * std::abs(point_at(ground, link, crank_range / 2).real() - ground);
  return (high - low) / stroke;
}

struct Shape {
  double ground, link;  // of crank 1
};

// The λ whose path meets a line where u = |AB0|² is at Chebyshev's nodes over the stroke: 2w³ + S w² − Π = 0 with
// w = d² − r², S and Π sum and product of the three, l² = (S + 2w) / 4.
Shape through_chebyshev_nodes(double crank_range) {
  double w = 0.5;
  Shape shape{};
  for (int turn = 0; turn < 200; ++turn) {
    const double half = (1 - w * w) * std::pow(std::sin(crank_range / 4), 2) / 2, middle = 1 - half;
    const double sum = 3 * middle, product = middle * (middle * middle - 0.75 * half * half);
    const auto roots = sign_changes_within(std::array{-product, 0.0, sum, 2.0}, 0, 1);
    w = roots.at(0);
    shape = {(1 + w) / (1 - w), std::sqrt((sum + 2 * w) / 4) * 2 / (1 - w)};
  }
  return shape;
}

struct Row {
  double degrees;
  double ground, link, stroke, deviation;  // near-minimax: by crank, % of the stroke
  double minimax_ground, minimax_link, minimax_stroke, minimax_deviation;
};
constexpr std::array<Row, 5> table = {{{80, 2.8245, 3.7368, 2.2989, 0.00114, 2.8231, 3.7347, 2.2984, 0.00110},
                                       {120, 2.6245, 3.4370, 3.2379, 0.0100, 2.6180, 3.4271, 3.2339, 0.00925},
                                       {140, 2.5053, 3.2584, 3.6267, 0.0239, 2.4937, 3.2405, 3.6183, 0.0214},
                                       {160, 2.3776, 3.0674, 3.9552, 0.0522, 2.3584, 3.0376, 3.9394, 0.0452},
                                       {180, 2.2447, 2.8691, 4.2203, 0.107, 2.2153, 2.8229, 4.1932, 0.0893}}};

TEST(SymmetricLambda, HasTheKnownProportions) {
  for (const Row& row : table) {
    SCOPED_TRACE(row.degrees);
    const auto lambda = minimax_lambda(radians(row.degrees), 1);
    ASSERT_TRUE(lambda);
    EXPECT_NEAR(lambda->ground / lambda->crank, row.minimax_ground, 1e-4);
    EXPECT_NEAR(lambda->link / lambda->crank, row.minimax_link, 1e-4);
    EXPECT_NEAR(lambda->stroke / lambda->crank, row.minimax_stroke, 1e-4);
    EXPECT_NEAR(200 * lambda->max_deviation / lambda->stroke, row.minimax_deviation, 6e-3 * row.minimax_deviation);
  }
}

TEST(SymmetricLambda, IsBetterThanThatOfChebyshevsNodes) {
  for (const Row& row : table) {
    SCOPED_TRACE(row.degrees);
    const double range = radians(row.degrees);
    const Shape near = through_chebyshev_nodes(range);
    EXPECT_NEAR(near.ground, row.ground, 1e-4);
    EXPECT_NEAR(near.link, row.link, 1e-4);
    EXPECT_NEAR(2 * std::abs(point_at(near.ground, near.link, range / 2).real() - near.ground), row.stroke, 1e-4);
    const double deviation = range_over_stroke(near.ground, near.link, range);
    EXPECT_NEAR(100 * deviation, row.deviation, 6e-3 * row.deviation);
    const auto lambda = minimax_lambda(range, 1);
    EXPECT_LT(2 * lambda->max_deviation, 0.98 * deviation);
  }
}

TEST(SymmetricLambda, IsBetterThanItsNeighbours) {
  for (const double degrees : {30.0, 90.0, 150.0, 210.0, 265.0}) {
    const double range = radians(degrees);
    const auto lambda = minimax_lambda(range, 1);
    const double ground = lambda->ground / lambda->crank, link = lambda->link / lambda->crank;
    const double least = range_over_stroke(ground, link, range);
    EXPECT_NEAR(least, 2 * lambda->max_deviation, 1e-5 * least + 1e-14);
    for (int i = 0; i < 60; ++i)
      for (const double size : {1e-4, 1e-3, 1e-2}) {
        const Point step = size * direction(radians(6.0 * i));
        EXPECT_GT(range_over_stroke(ground + step.real(), link + step.imag(), range), least) << degrees << ' ' << step;
      }
  }
}

TEST(SymmetricLambda, RunsAsItSays) {
  for (const double degrees : {5.0, 40.0, 92.0, 140.0, 180.0, 220.0, 269.0})
    for (const bool mirrored : {false, true}) {
      SCOPED_TRACE(degrees);
      const DirectedLine line{{3, -7}, direction(0.7)};
      const auto lambda = minimax_lambda(radians(degrees), 12);
      const TracingFourBar linkage = lambda_linkage(*lambda, line, mirrored);
      const LinkLengths lengths = linkage.bars.lengths();
      EXPECT_NEAR(lengths.input, lambda->crank, 1e-13 * lambda->link);
      EXPECT_NEAR(lengths.ground, lambda->ground, 1e-13 * lambda->link);
      EXPECT_NEAR(lengths.coupler, lambda->link, 1e-13 * lambda->link);
      EXPECT_NEAR(lengths.output, lambda->link, 1e-13 * lambda->link);
      EXPECT_NEAR(std::abs(linkage.point - linkage.bars.output_moving), lambda->link, 1e-13 * lambda->link);
      EXPECT_EQ(linkage.point, line.point);
      const Point center = line.to_line(linkage.bars.input_fixed);
      EXPECT_LT(center.real(), 0);
      EXPECT_EQ(center.imag() > 0, mirrored);
      EXPECT_NEAR(std::abs(center.imag()), lambda->line_height - lambda->max_deviation, 1e-12 * lambda->link);

      const auto path = StraightPath::of(linkage, line.direction);
      ASSERT_TRUE(path);
      const double half = lambda->stroke / 2 * (1 - 1e-12);
      const auto stroke = path->stroke(-half, half);
      ASSERT_TRUE(stroke);
      const double rounding = 1e-13 * lambda->link;
      EXPECT_NEAR(stroke->max_deviation, 2 * lambda->max_deviation, 1e-9 * lambda->max_deviation + rounding);
      EXPECT_NEAR(stroke->parallel_line_deviation, lambda->max_deviation, 1e-9 * lambda->max_deviation + rounding);
      EXPECT_NEAR(stroke->best_line_deviation, lambda->max_deviation, 1e-9 * lambda->max_deviation + rounding);
      EXPECT_NEAR(stroke->min_transmission_angle, lambda->min_transmission_angle, 1e-9);
      ASSERT_TRUE(stroke->drive);
      EXPECT_NEAR(std::abs(stroke->drive->sweep), lambda->crank_range, 1e-5);
    }
}

TEST(SymmetricLambda, OfASmallRangeIsThatOfSixPoints) {
  const auto lambda = minimax_lambda(1e-4, 1);
  EXPECT_NEAR(lambda->ground / lambda->crank, 3, 1e-8);
  EXPECT_NEAR(lambda->link / lambda->crank, 4, 1e-8);
  EXPECT_GT(lambda->max_deviation, 0);
  int seen = 0;
  for (const auto& known : testing::straight_line_cases()) {
    if (known.name != "lam_134") continue;
    ++seen;
    const double sixth = known.json.at("e_of_s_coefficients").at("6");  // of crank 1
    // Over a stroke 2h, c s⁶ less its best even quartic ranges over c h⁶ / 16: Chebyshev's polynomial of degree three
    // in s².
    const auto small = minimax_lambda(0.1, 1);
    EXPECT_NEAR(small->max_deviation / small->crank, sixth * std::pow(small->stroke / small->crank / 2, 6) / 32,
                0.01 * small->max_deviation / small->crank);
  }
  EXPECT_EQ(seen, 1);
}

// docs/theory/straight_lines.md, the row of Chebyshev's nodes: 80, 120, 140, 160, 180 degrees.
TEST(SymmetricLambda, AtChebyshevsNodesIsAllButTheBest) {
  struct Row {
    double range, ground, link, stroke, percent;
  };
  for (const Row& row : {Row{80, 2.8245, 3.7368, 2.2989, 0.00114}, Row{120, 2.6245, 3.4370, 3.2379, 0.0100},
                         Row{140, 2.5053, 3.2584, 3.6267, 0.0239}, Row{160, 2.3776, 3.0674, 3.9552, 0.0522},
                         Row{180, 2.2447, 2.8691, 4.2203, 0.107}}) {
    const auto near = near_minimax_lambda(radians(row.range), 1), best = minimax_lambda(radians(row.range), 1);
    ASSERT_TRUE(near && best);
    EXPECT_NEAR(near->ground / near->crank, row.ground, 6e-5);
    EXPECT_NEAR(near->link / near->crank, row.link, 6e-5);
    EXPECT_NEAR(near->stroke / near->crank, row.stroke, 6e-5);
    EXPECT_NEAR(200 * near->max_deviation / near->stroke, row.percent, 0.006 * row.percent);
    EXPECT_LT(best->max_deviation, near->max_deviation);
    EXPECT_GT(best->max_deviation, 0.8 * near->max_deviation);
    EXPECT_NEAR(near->line_height, best->line_height, 0.02 * best->line_height);
  }
  EXPECT_FALSE(near_minimax_lambda(0, 1));
}

TEST(SymmetricLambda, IsThereUntilThePointTurnsBack) {
  EXPECT_TRUE(minimax_lambda(longest_lambda_range * (1 - 1e-12), 1));
  for (const double range : {0.0, -1.0, longest_lambda_range, 6.0, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_FALSE(minimax_lambda(range, 1));
  EXPECT_FALSE(minimax_lambda(1, 0));
  EXPECT_FALSE(minimax_lambda(1, std::numeric_limits<double>::infinity()));
  const auto lambda = minimax_lambda(longest_lambda_range - 1e-12, 1);
  const double ground = lambda->ground / lambda->crank, link = lambda->link / lambda->crank;
  const auto s = [&](double angle) { return std::abs(point_at(ground, link, angle).real() - ground); };
  const double end = longest_lambda_range / 2, step = 1e-4;
  EXPECT_NEAR((s(end + step) - s(end - step)) / (2 * step), 0, 1e-7);
  EXPECT_LT(s(end + 0.01), s(end));
  EXPECT_LT(s(end - 0.01), s(end));
}

}  // namespace
}  // namespace linkwright::symmetric_lambda_test
