#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "approximate/fit_hinges.hpp"
#include "linkwright/approximate/curve_fit.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/coupler_curve.hpp"
#include "support/curve_case.hpp"

namespace linkwright::fit_limits_test {
namespace {

// In 3600 steps of the input, by the tree's own motion.
double transmission_over_turn(const FourBar& bars) {
  double least = pi / 2;
  for (const MotionState& there : motion_cycle(bars, bars.input_moving, 3600)) {
    const Point coupler = there.four_bar.output_moving - there.four_bar.input_moving;
    const Point output = there.four_bar.output_moving - there.four_bar.output_fixed;
    least = std::min(least,
                     std::asin(std::min(std::abs(cross(coupler, output)) / std::abs(coupler) / std::abs(output), 1.0)));
  }
  return least;
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

TEST(FitLimits, AClosedPathTransmitsWellAllTheWayRound) {
  for (const char* const name : {"yu1", "tri24"}) {
    const CurveTarget target = testing::curve_case(name).target;
    CurveFitOptions options;
    options.min_transmission_angle = radians(30);
    const CurveFits found = fit_curve(target, options);
    ASSERT_FALSE(found.fits.empty()) << name;
    EXPECT_GE(found.fits.front().error.sum_of_squares,
              fit_curve(target).fits.front().error.sum_of_squares * (1 - 1e-9));
    for (const CurveFit& fit : found.fits)
      EXPECT_GE(transmission_over_turn(fit.linkage().bars), radians(30) - 1e-5) << name;
  }
}

// The hinge's rows lead a linkage to its limit, so they are derivatives of what it bounds.
TEST(FitLimits, TheTurnsHingeHasTheRowsThatDifferencesShow) {
  FitLimits limits;
  limits.min_turn_sine = 0.95;
  const CouplerLinkage linkage{{0.1, -0.2}, {3.0, 0.4}, 0.8, 2.6, 1.9, {1.2, 0.7}};
  const auto hinges_at = [&](const CouplerLinkage& of) {
    std::vector<FitRow> rows;
    append_linkage_hinges(limits, of, rows);
    return rows;
  };
  const std::vector<FitRow> rows = hinges_at(linkage);
  ASSERT_FALSE(rows.empty());
  constexpr double step = 1e-6;
  const auto moved = [&](std::size_t i, double by) {
    std::array<double, fit_dimensions> d{};
    d[i] = by;
    return CouplerLinkage{linkage.a0 + Point{d[0], d[1]},
                          linkage.b0 + Point{d[2], d[3]},
                          linkage.a + d[4],
                          linkage.h + d[5],
                          linkage.b + d[6],
                          linkage.p + Point{d[7], d[8]}};
  };
  for (std::size_t i = 0; i < fit_dimensions; ++i) {
    const auto after = hinges_at(moved(i, step)), before = hinges_at(moved(i, -step));
    ASSERT_EQ(after.size(), rows.size());
    ASSERT_EQ(before.size(), rows.size());
    for (std::size_t k = 0; k < rows.size(); ++k)
      EXPECT_NEAR(rows[k].row[i], (after[k].residual - before[k].residual) / (2 * step), 1e-7);
  }
}

}  // namespace
}  // namespace linkwright::fit_limits_test
