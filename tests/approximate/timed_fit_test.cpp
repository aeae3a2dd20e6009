#include "linkwright/approximate/timed_fit.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/coupler_curve.hpp"
#include "support/curve_case.hpp"
#include "support/random_four_bar.hpp"

namespace linkwright::timed_fit_test {
namespace {

constexpr CurveFitOptions quick = {.effort = FitEffort::quick};

CurveTiming equal_turns(std::size_t count, double step, double first = 0) {
  CurveTiming timing;
  for (std::size_t k = 0; k < count; ++k) timing.input.push_back(first + step * static_cast<double>(k));
  return timing;
}
CurveTiming all_round(std::size_t count) { return equal_turns(count, two_pi / static_cast<double>(count)); }

double input_angle(const TracingFourBar& linkage) {
  return std::arg(linkage.bars.input_moving - linkage.bars.input_fixed);
}

// The sum of squares by turning the input with the tree's own motion from the first point on: it shares nothing with
// the fit but where the linkage lies there.
double driven_sum_of_squares(const TracingFourBar& linkage, const CurveTarget& target, const CurveTiming& timing,
                             double sense) {
  double sum = std::norm(linkage.point - target.points[0]);
  for (std::size_t j = 1; j < target.points.size(); ++j) {
    const double sweep = sense * (timing.input[j] - timing.input[0]);
    const auto states = motion_sweep(linkage.bars, linkage.point, sweep, 2 + static_cast<int>(60 * std::abs(sweep)));
    sum += std::norm(states.back().coupler_point - target.points[j]);
  }
  return sum;
}

// That of the better sense.
double driven_sum_of_squares(const TracingFourBar& linkage, const CurveTarget& target, const CurveTiming& timing) {
  return std::min(driven_sum_of_squares(linkage, target, timing, 1),
                  driven_sum_of_squares(linkage, target, timing, -1));
}

TEST(TimedFit, FitsThePublishedTargetAsWellAsIsKnown) {
  const testing::CurveCase c = testing::curve_case("kk18t");
  const CurveFits found = fit_timed_curve(c.target, all_round(18));
  ASSERT_GE(found.fits.size(), 2u) << "more than one path is near";
  const CurveFit& best = found.fits.front();
  EXPECT_LE(best.error.sum_of_squares, 1.0001 * c.best);
  EXPECT_TRUE(best.drive.no_defects(true) && best.within_limits);
  ASSERT_EQ(best.realisation_count, 2);
  for (std::size_t k = 0; k < 2; ++k)
    EXPECT_NEAR(driven_sum_of_squares(best.realisations[k], c.target, all_round(18)), best.error.sum_of_squares, 1e-9);
}

TEST(TimedFit, FindsExactPathsAgain) {
  for (std::uint64_t seed = 1001; seed <= 1040; ++seed) {
    const bool closed = seed % 2 == 0;
    const std::size_t count = 6 + seed % 30;
    const double sweep = 1.5 + 0.05 * static_cast<double>(seed % 30);
    const TracingFourBar linkage = testing::drawn_linkage(seed, true);
    const CurveTarget target = testing::traced_target(linkage, closed, static_cast<int>(count), sweep);
    const CurveTiming timing =
        closed ? all_round(count) : equal_turns(count, sweep / static_cast<double>(count - 1), -0.3);
    const CurveFits found = fit_timed_curve(target, timing, {.max_length = 100, .min_length = 1e-4});
    ASSERT_FALSE(found.fits.empty()) << seed;
    EXPECT_LT(found.fits.front().error.rms_over_diagonal, 1e-12) << seed;
    EXPECT_LT(std::sqrt(driven_sum_of_squares(found.fits.front().linkage(), target, timing)),
              1e-8 * target.diagonal() * static_cast<double>(count))
        << seed;
  }
}

TEST(TimedFit, HoldsTheDatumOfAbsoluteAngles) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const TracingFourBar linkage = testing::drawn_linkage(seed, true);
    const CurveTarget target = testing::traced_target(linkage, true, 20);
    CurveTiming timing = equal_turns(20, two_pi / 20, input_angle(linkage));
    timing.absolute = true;
    CurveFits found = fit_timed_curve(target, timing, quick);
    ASSERT_FALSE(found.fits.empty()) << seed;
    const CurveFit& best = found.fits.front();
    EXPECT_EQ(best.realisation_count, 1);
    EXPECT_LT(best.error.rms_over_diagonal, 1e-12) << seed;
    for (std::size_t j = 0; j < best.states.size(); ++j)
      EXPECT_NEAR(wrap_signed(best.states[j].input_angle - timing.input[j]), 0, 1e-12);
    for (double& input : timing.input) input += 1;  // another datum: held, so that the path is missed
    const CurveFits other = fit_timed_curve(target, timing, quick);
    for (const CurveFit& fit : other.fits) EXPECT_GT(fit.error.rms_over_diagonal, 1e-6) << seed;
    timing.absolute = false;
    found = fit_timed_curve(target, timing, quick);
    ASSERT_FALSE(found.fits.empty());
    EXPECT_LT(found.fits.front().error.rms_over_diagonal, 1e-12) << "free, it does not matter";
  }
}

CurveTarget transformed(CurveTarget target, Point turn, Point shift) {
  for (Point& p : target.points) p = turn * p + shift;
  return target;
}

TEST(TimedFit, DoesNotDependOnFrameUnitSenseOrFirstPoint) {
  CurveTarget target = testing::curve_case("kk18t").target;
  const double error = fit_timed_curve(target, all_round(18), quick).fits.front().error.rms;
  for (const double scale : {1e-6, 1e6}) {
    const CurveTarget other = transformed(target, std::polar(scale, 0.7), {3 * scale, -5 * scale});
    const CurveFits found = fit_timed_curve(other, all_round(18), quick);
    ASSERT_FALSE(found.fits.empty());
    EXPECT_NEAR(found.fits.front().error.rms / scale, error, 1e-3 * error);
  }
  std::reverse(target.points.begin(), target.points.end());
  EXPECT_NEAR(fit_timed_curve(target, all_round(18), quick).fits.front().error.rms, error, 1e-4 * error);
  CurveTiming falling = all_round(18);
  for (double& input : falling.input) input *= -1;
  EXPECT_NEAR(fit_timed_curve(target, falling, quick).fits.front().error.rms, error, 1e-4 * error);
  std::rotate(target.points.begin(), target.points.begin() + 5, target.points.end());
  EXPECT_NEAR(fit_timed_curve(target, all_round(18), quick).fits.front().error.rms, error, 1e-4 * error);
}

TEST(TimedFit, ComesNoNearerWithShorterLinks) {
  const CurveTarget target = testing::curve_case("kk18t").target;
  double before = 0;
  for (const double most : {10.0, 3.0, 1.0, 0.6}) {
    const CurveFits found = fit_timed_curve(target, all_round(18), {.max_length = most});
    ASSERT_FALSE(found.fits.empty()) << most;
    EXPECT_GE(found.fits.front().error.rms, (1 - 1e-5) * before) << most;
    EXPECT_LE(found.fits.front().linkage().bars.lengths().longest(), (1 + 2e-6) * most * target.diagonal());
    before = found.fits.front().error.rms;
  }
}

TEST(TimedFit, KeepsTheTransmissionAngleAndTheWindow) {
  const CurveTarget target = testing::curve_case("kk18t").target;
  CurveFitOptions options = {.min_transmission_angle = radians(40)};
  options.windows.ground = Box{-1, 2, -1, 1};
  const CurveFits found = fit_timed_curve(target, all_round(18), options);
  ASSERT_FALSE(found.fits.empty());
  for (const CurveFit& fit : found.fits) {
    EXPECT_GE(fit.min_transmission_angle, radians(40) - 1e-3);
    for (const Point pivot : {fit.linkage().bars.input_fixed, fit.linkage().bars.output_fixed}) {
      EXPECT_LE(std::abs(pivot.real() - 0.5), 1.5 + 1e-5);
      EXPECT_LE(std::abs(pivot.imag()), 1 + 1e-5);
    }
  }
}

TEST(TimedFit, LowersTheLargestDistanceWhereThatCounts) {
  const CurveTarget target = testing::curve_case("kk18t").target;
  const CurveFits squares = fit_timed_curve(target, all_round(18));
  const CurveFits largest = fit_timed_curve(target, all_round(18), {.measure = FitMeasure::least_largest});
  ASSERT_FALSE(squares.fits.empty() || largest.fits.empty());
  EXPECT_LT(largest.fits.front().error.max, 0.95 * squares.fits.front().error.max);
  EXPECT_GT(largest.fits.front().error.rms, squares.fits.front().error.rms);
}

TEST(TimedFit, FollowsThePointsThroughTheirNoise) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const TracingFourBar linkage = testing::drawn_linkage(seed, true);
    CurveTarget target = testing::traced_target(linkage, true, 120);
    testing::RandomFourBars draw(seed + 77);
    const double noise = 0.01 * target.diagonal();
    double true_square = 0;
    for (Point& p : target.points) {
      const Point off = noise * Point{draw.uniform(-1, 1), draw.uniform(-1, 1)};
      p += off;
      true_square += std::norm(off);
    }
    const CurveFits found = fit_timed_curve(target, all_round(120), quick);
    ASSERT_FALSE(found.fits.empty()) << seed;
    EXPECT_LE(found.fits.front().error.sum_of_squares, true_square) << "the linkage itself is one of those looked for";
    EXPECT_GE(found.fits.front().error.sum_of_squares, 0.8 * true_square) << "ten numbers take out few of 240";
  }
}

TEST(TimedFit, IsTheSameWhateverTheThreadsAndTheInstructionSet) {
  const CurveTarget target = testing::curve_case("kk18t").target;
  CurveFitOptions options{.effort = FitEffort::quick, .threads = 1, .simd = Simd::scalar};
  const CurveFits first = fit_timed_curve(target, all_round(18), options);
  options.threads = 2;
  options.simd = Simd::automatic;
  const CurveFits second = fit_timed_curve(target, all_round(18), options);
  ASSERT_FALSE(first.fits.empty());
  ASSERT_EQ(first.fits.size(), second.fits.size());
  for (std::size_t k = 0; k < first.fits.size(); ++k)
    EXPECT_EQ(farthest_pivot(first.fits[k].linkage().bars, second.fits[k].linkage().bars), 0);
}

// Nothing is asked of these but an answer without NaN.
TEST(TimedFit, AnswersStrangeTargets) {
  CurveTarget circle, line, dwell, three, zigzag;
  for (int k = 0; k < 20; ++k) circle.points.push_back(direction(k * 0.1 * pi));
  for (int k = 0; k < 15; ++k) line.points.emplace_back(k, 2 * k);
  for (int k = 0; k < 24; ++k) dwell.points.emplace_back(std::max(k, 12), std::max(k, 12) % 3);
  three.points = {{0, 0}, {1, 0}, {0, 1}};
  for (int k = 0; k < 40; ++k) zigzag.points.emplace_back(k, k % 2 == 0 ? 0 : 30);
  for (CurveTarget target : {circle, line, dwell, three, zigzag}) {
    for (const bool closed : {false, true}) {
      for (const bool absolute : {false, true}) {
        target.closed = closed;
        CurveTiming timing = equal_turns(target.points.size(), 6.2 / static_cast<double>(target.points.size()), 0.4);
        timing.absolute = absolute;
        const CurveFits found = fit_timed_curve(target, timing, quick);
        for (const CurveFit& fit : found.fits) {
          EXPECT_TRUE(std::isfinite(fit.error.sum_of_squares) && std::isfinite(fit.error.excursion));
          EXPECT_TRUE(is_finite(fit.linkage().point) && std::isfinite(fit.linkage().longest()));
          EXPECT_TRUE(fit.drive.no_defects(closed));
        }
      }
    }
  }
}

TEST(TimedFit, StopsWhenAskedTo) {
  const std::atomic<bool> cancelled = true;
  const CurveFits found = fit_timed_curve(testing::curve_case("kk18t").target, all_round(18),
                                          {.effort = FitEffort::deep}, {{}, &cancelled});
  EXPECT_TRUE(found.cancelled);
  EXPECT_TRUE(found.fits.empty());
}

TEST(CompareWithTimedCurve, SaysOfAFitWhatTheFitSays) {
  const CurveTarget target = testing::curve_case("kk18t").target;
  const CurveFits found = fit_timed_curve(target, all_round(18), quick);
  ASSERT_FALSE(found.fits.empty());
  const CurveFit& fit = found.fits.front();
  for (std::size_t k = 0; k < fit.realisation_count; ++k) {
    const auto compared = compare_with_timed_curve(fit.realisations[k], target, all_round(18));
    ASSERT_TRUE(compared);
    EXPECT_NEAR(compared->error.rms, fit.error.rms, 1e-9 * fit.error.rms);
    EXPECT_TRUE(compared->drive.no_defects(true));
  }
  const auto untimed = compare_with_curve(fit.linkage(), target);
  ASSERT_TRUE(untimed);
  EXPECT_LT(untimed->error.rms, fit.error.rms) << "without timing the path is nearer";
}

TEST(CompareWithTimedCurve, HoldsAbsoluteAngles) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const TracingFourBar linkage = testing::drawn_linkage(seed, true);
    const CurveTarget target = testing::traced_target(linkage, true, 20);
    CurveTiming timing = equal_turns(20, two_pi / 20, input_angle(linkage));
    timing.absolute = true;
    EXPECT_LT(compare_with_timed_curve(linkage, target, timing)->error.rms_over_diagonal, 1e-12);
    for (double& input : timing.input) input += 0.2;
    EXPECT_GT(compare_with_timed_curve(linkage, target, timing)->error.rms_over_diagonal, 1e-3);
  }
}

}  // namespace
}  // namespace linkwright::timed_fit_test
