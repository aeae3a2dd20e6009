#include "linkwright/straight_line/line_measuring.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <iterator>
#include <random>
#include <vector>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/simd.hpp"
#include "linkwright/straight_line/straight_line_task.hpp"
#include "linkwright/straight_line/straight_path.hpp"
#include "straight_line/line_cases.hpp"
#include "straight_line/line_estimate.hpp"
#include "support/draws.hpp"

namespace linkwright {
namespace {

using namespace straight_cases;

TEST(LineMeasuring, TakesAShareOfTheLongestUnlessTold) {
  const TracingFourBar linkage{{{0, 0}, {-1, 0}, {3, 0}, {1, std::sqrt(12.0)}}, {3, std::sqrt(48.0)}};
  EXPECT_NEAR(LineMeasuring{}.deviation_of(linkage), 8e-4, 1e-15);
  EXPECT_EQ((LineMeasuring{0.5, {}, {}}.deviation_of(linkage)), 0.5);
  EXPECT_NEAR((LineMeasuring{1e-300, {}, {}}.deviation_of(linkage)), 8e-13, 1e-25) << "below it is rounding";
  EXPECT_EQ(name(LineMeasure::strip), "strip");
  EXPECT_EQ(name(LineMeasure::tangent), "tangent");
}

std::vector<TracingFourBar> linkages_of(const StraightLineTask& task, int count, unsigned seed,
                                        double longest_to_shortest = 20) {
  std::mt19937 draw(seed);
  std::uniform_real_distribution<double> share(0, 1);
  const auto axes = axes_of(task);
  const auto place = [&](const LineAxis& axis) {
    return line_axis_value(axis, axis.low + share(draw) * (axis.high - axis.low));
  };
  std::vector<TracingFourBar> found;
  while (std::ssize(found) < count) {
    const auto first = place(axes[0]), second = place(axes[1]);
    for (const LineDesign& design : designs_at(task, first, second))
      if (design.kind == DesignKind::four_bar &&
          design.linkage.longest() < longest_to_shortest * design.linkage.bars.lengths().shortest())
        found.push_back(design.linkage);
  }
  return found;
}

struct Sample {
  StraightLineTask task;
  int contact;
};
std::vector<Sample> samples() {
  const LineAtAngle line({1, 2}, 0.4);
  return {{{line, FourPointPivots{{0, 0}, {3, 1}}}, 4},
          {{line, IsoscelesTrapezoid{1}}, 4},
          {{line, FivePoint{1.5, 1}}, 5},
          {{line, SixPoint{1}}, 6},
          {{line, ParallelSideLinks{-0.5, 0.5}}, 5}};
}

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

// Against the exact tracer.
TEST(LineEstimate, IsCloseToTheExactPath) {
  for (const Sample& sample : samples()) {
    const auto linkages = linkages_of(sample.task, testing::draws(400), 3);
    std::vector<LineEstimate> estimates(linkages.size());
    const Point along = sample.task.line.direction;
    estimate_lines(linkages, {along, sample.contact, {}, {}, Simd::automatic}, estimates);
    std::vector<double> stroke, strip, angle;
    for (std::size_t i = 0; i < linkages.size(); ++i) {
      const auto path = StraightPath::of(linkages[i], along);
      if (!path) continue;
      const double deviation = LineMeasuring{}.deviation_of(linkages[i]);
      const UsableLine exact = path->usable(deviation), exact_strip = path->usable_strip(deviation);
      stroke.push_back(std::abs(estimates[i].usable_stroke / exact.length() - 1));
      strip.push_back(std::abs(estimates[i].usable_strip / exact_strip.length() - 1));
      const auto report = path->stroke(exact.from, exact.to);
      ASSERT_TRUE(report);
      angle.push_back(std::abs(std::asin(estimates[i].min_transmission_sine) - report->min_transmission_angle));
    }
    const auto of = name(sample.task.given);
    EXPECT_LT(quantile(stroke, 0.5), 0.0005) << of;
    EXPECT_LT(quantile(stroke, 0.95), 0.01) << of;
    EXPECT_LT(quantile(strip, 0.5), 0.001) << of;
    EXPECT_LT(quantile(strip, 0.95), 0.01) << of;
    EXPECT_LT(quantile(angle, 0.5), 0.002) << of;
    EXPECT_LT(quantile(angle, 0.95), 0.02) << of;
  }
}

// Next to a change point the links swing round within a step of the tracer: such a path is traced exactly.
TEST(LineEstimate, OfLinkagesOfAllProportionsIsSeldomOff) {
  for (const Sample& sample : samples()) {
    const auto linkages = linkages_of(sample.task, testing::draws(2000), 12, 1e4);
    std::vector<LineEstimate> estimates(linkages.size());
    const Point along = sample.task.line.direction;
    estimate_lines(linkages, {along, sample.contact, {}, {}, Simd::automatic}, estimates);
    int off = 0, far = 0, all = 0;
    for (std::size_t i = 0; i < linkages.size(); ++i) {
      const auto path = StraightPath::of(linkages[i], along);
      if (!path) continue;
      const double exact = path->usable(LineMeasuring{}.deviation_of(linkages[i])).length();
      off += std::abs(estimates[i].usable_stroke - exact) > 0.01 * exact;
      far += std::abs(estimates[i].usable_stroke - exact) > 0.1 * exact;
      ++all;
    }
    EXPECT_LT(off, 0.01 * all + 3) << name(sample.task.given);
    EXPECT_LE(far, 0.001 * all + 1) << name(sample.task.given);
  }
}

// Over a stroke that is asked for, and how evenly the point travels with the input.
TEST(LineEstimate, MeasuresTheStrokeAskedFor) {
  const Sample sample = samples().front();
  const auto linkages = linkages_of(sample.task, 300, 8);
  std::vector<LineEstimate> estimates(linkages.size());
  const Point along = sample.task.line.direction;
  for (const double stroke : {0.05, 0.4}) {
    const LineMeasuring measuring{{}, stroke, LineMeasure::strip};
    estimate_lines(linkages, {along, sample.contact, measuring, std::array{-stroke / 2, stroke / 2}, Simd::automatic},
                   estimates);
    int reached = 0, close = 0, even = 0;
    for (std::size_t i = 0; i < linkages.size(); ++i) {
      const auto path = StraightPath::of(linkages[i], along);
      const auto report = path ? path->stroke(-stroke / 2, stroke / 2) : std::nullopt;
      if (!report) continue;
      ++reached;
      close += std::abs(estimates[i].deviation - report->max_deviation) < 0.05 * report->max_deviation;
      const double exact = report->drive ? report->drive->nonuniformity(stroke) : 1e9,
                   ours = estimates[i].velocity_nonuniformity;
      even += report->drive ? std::abs(ours - exact) < 0.05 * exact + 0.01 : !(ours < 5);
    }
    EXPECT_GT(reached, 200);
    EXPECT_GT(close, 0.95 * reached);
    EXPECT_GT(even, 0.9 * reached);
  }
}

TEST(LineEstimate, IsTheSameForEveryInstructionSet) {
  const Sample sample = samples()[2];
  const auto linkages = linkages_of(sample.task, 100, 5);
  std::vector<LineEstimate> one(linkages.size()), other(linkages.size());
  for (const Simd simd : {Simd::baseline, Simd::avx2, Simd::avx512}) {
    if (!is_supported(simd)) continue;
    const auto estimate = [&](Simd with, std::vector<LineEstimate>& to) {
      estimate_lines(linkages, {sample.task.line.direction, 5, {}, {}, with}, to);
    };
    estimate(Simd::scalar, one);
    estimate(simd, other);
    for (std::size_t i = 0; i < one.size(); ++i) {
      EXPECT_EQ(one[i].usable_stroke, other[i].usable_stroke);
      EXPECT_EQ(one[i].usable_strip, other[i].usable_strip);
      EXPECT_EQ(one[i].contact_coefficient, other[i].contact_coefficient);
    }
  }
}

}  // namespace
}  // namespace linkwright
