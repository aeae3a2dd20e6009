#include <gtest/gtest.h>
#include <limits>

#include "linkwright/approximate/curve_fit.hpp"
#include "linkwright/core/angle.hpp"
#include "support/curve_case.hpp"

namespace linkwright::fit_limits_test {
namespace {

TEST(FitLimits, HoldTheTransmissionAngleOfClosedPathsAllRound) {
  int kept = 0;
  for (int seed = 1; seed <= 6; ++seed) {
    const CurveTarget target = testing::traced_target(testing::drawn_linkage(seed, true), true, 16);
    CurveFitOptions options{.effort = FitEffort::quick};
    options.min_transmission_angle = 0.6;
    for (const CurveFit& fit : fit_curve(target, options).fits) {
      ++kept;
      EXPECT_GE(fit.min_transmission_angle, 0.6 - 1e-3) << seed;
    }
  }
  EXPECT_GT(kept, 6);
}

TEST(FitLimits, PivotsLieWhereTheyAreAskedFor) {
  const CurveTarget target = testing::curve_case("yu1").target;
  const Box box{-30, 30, -45, -20};
  CurveFitOptions options;
  options.windows.ground = box;
  const CurveFits found = fit_curve(target, options);
  ASSERT_FALSE(found.fits.empty());
  EXPECT_LT(found.fits.front().error.sum_of_squares, 3.42);
  for (const CurveFit& fit : found.fits) {
    EXPECT_TRUE(box.contains(fit.linkage().bars.input_fixed));
    EXPECT_TRUE(box.contains(fit.linkage().bars.output_fixed));
  }
}

TEST(FitLimits, LinksAreNoLongerThanAllowedAndTheErrorFallsWithTheirLength) {
  CurveTarget ellipse;
  ellipse.closed = true;
  for (int k = 0; k < 9; ++k)
    ellipse.points.push_back({10 + 10 * direction(k * two_pi / 9).real(), 10 + 8 * direction(k * two_pi / 9).imag()});
  const double diagonal = ellipse.diagonal();
  double before = std::numeric_limits<double>::infinity();
  for (const double longest : {30.0, 60.0, 80.0}) {
    CurveFitOptions options;
    options.max_length = longest / diagonal;
    const CurveFits found = fit_curve(ellipse, options);
    ASSERT_FALSE(found.fits.empty());
    const CurveFit& best = found.fits.front();
    EXPECT_LE(best.linkage().bars.lengths().longest(), longest * (1 + 1e-5));
    EXPECT_TRUE(best.at_length_limit);
    EXPECT_LT(best.error.sum_of_squares, before);
    before = best.error.sum_of_squares;
  }
  EXPECT_LT(before, 1.002 * 4.0507e-4);
}

TEST(FitLimits, TransmissionAngleIsKeptAtThePoints) {
  const CurveTarget target = testing::curve_case("mkh3").target;
  CurveFitOptions options;
  options.min_transmission_angle = radians(30);
  const CurveFits found = fit_curve(target, options);
  ASSERT_FALSE(found.fits.empty());
  for (const CurveFit& fit : found.fits)
    for (const FitState& state : fit.states) {
      const Point coupler = state.bars.output_moving - state.bars.input_moving;
      const Point output = state.bars.output_moving - state.bars.output_fixed;
      EXPECT_GT(std::abs(cross(coupler, output)) / (std::abs(coupler) * std::abs(output)), 0.5 - 1e-5);
    }
  const CurveFits free = fit_curve(target);
  EXPECT_GE(found.fits.front().error.rms, free.fits.front().error.rms);
}

TEST(FitLimits, MarginKeepsLinkagesFromChangePoints) {
  const CurveTarget target = testing::curve_case("tri24").target;
  double before = std::numeric_limits<double>::infinity();
  for (const double margin : {0.01, 0.003}) {
    CurveFitOptions options;
    options.grashof_margin = margin;
    const CurveFits found = fit_curve(target, options);
    ASSERT_FALSE(found.fits.empty());
    for (const CurveFit& fit : found.fits) {
      const LinkLengths lengths = fit.linkage().bars.lengths();
      const double excess = lengths.perimeter() - 2 * (lengths.longest() + lengths.shortest());
      EXPECT_GE(excess, margin * target.diagonal() * (1 - 1e-3));
    }
    EXPECT_LT(found.fits.front().error.rms, before);
    before = found.fits.front().error.rms;
  }
}

TEST(FitLimits, LeastLargestErrorIsSmallerThanThatOfLeastSquares) {
  for (const char* const name : {"mkh2", "yu1"}) {
    const CurveTarget target = testing::curve_case(name).target;
    const CurveFits squares = fit_curve(target);
    const CurveFits largest = fit_curve(target, {.measure = FitMeasure::least_largest});
    ASSERT_FALSE(squares.fits.empty() || largest.fits.empty());
    EXPECT_LT(largest.fits.front().error.max, 0.75 * squares.fits.front().error.max) << name;
    EXPECT_GT(largest.fits.front().error.rms, squares.fits.front().error.rms) << name;
  }
}

}  // namespace
}  // namespace linkwright::fit_limits_test
