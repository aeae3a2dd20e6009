#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "linkwright/approximate/pose_fit.hpp"
#include "linkwright/approximate/timed_fit.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/coupler_curve.hpp"
#include "support/curve_case.hpp"
#include "support/random_four_bar.hpp"

namespace linkwright::given_starts_test {
namespace {

constexpr double nearly = 1e-9;  // of the diagonal

// What is all but that linkage: pivots and point are elsewhere by up to a share of its size.
TracingFourBar disturbed(const TracingFourBar& linkage, double share, testing::RandomFourBars& draw) {
  const auto near = [&](Point p) {
    const double size = share * linkage.bars.lengths().longest();
    return p + size * Point{draw.uniform(-1, 1), draw.uniform(-1, 1)};
  };
  const FourBar& bars = linkage.bars;
  return {{near(bars.input_fixed), near(bars.input_moving), near(bars.output_fixed), near(bars.output_moving)},
          near(linkage.point)};
}

const TracingFourBar unmovable{{{0, 0}, {0, 0}, {1, 0}, {1, 1}}, {2, 2}};
const TracingFourBar unknown{{{0, 0}, {1, 0}, {3, 0}, {3, std::numeric_limits<double>::quiet_NaN()}}, {2, 2}};

TEST(GivenStarts, LeadBackToTheLinkageThatTracedTheCurve) {
  testing::RandomFourBars draw(77);
  for (std::uint64_t seed = 501; seed <= 516; ++seed) {
    const bool closed = seed % 2 == 0;
    const TracingFourBar linkage = testing::drawn_linkage(seed, closed);
    const CurveTarget target = testing::traced_target(linkage, closed, 40);
    CurveFitOptions options{.effort = FitEffort::quick, .max_length = 1000, .min_length = 1e-6};
    options.starts = {unmovable, disturbed(linkage, 0.003, draw), unknown};
    const CurveFits found = fit_curve(target, options);
    ASSERT_FALSE(found.fits.empty()) << seed;
    EXPECT_LT(found.fits.front().error.rms_over_diagonal, nearly) << seed;
    options.starts.clear();
    EXPECT_EQ(found.counts.starts, fit_curve(target, options).counts.starts + 2) << "on its branch, and free";
  }
}

TEST(GivenStarts, AreBroughtToThePivotsThatAreGiven) {
  testing::RandomFourBars draw(78);
  for (std::uint64_t seed = 521; seed <= 532; ++seed) {
    const TracingFourBar linkage = testing::drawn_linkage(seed, true);
    const CurveTarget target = testing::traced_target(linkage, true, 40);
    CurveFitOptions options{.effort = FitEffort::quick, .max_length = 1000, .min_length = 1e-6};
    options.input_pivot = linkage.bars.input_fixed;
    options.starts = {disturbed(linkage, 0.002, draw)};
    const CurveFits found = fit_curve(target, options);
    ASSERT_FALSE(found.fits.empty()) << seed;
    EXPECT_LT(found.fits.front().error.rms_over_diagonal, nearly) << seed;
    EXPECT_LT(std::abs(found.fits.front().linkage().bars.input_fixed - *options.input_pivot), 1e-12);
  }
}

TEST(GivenStarts, LeadBackAtAnglesOfTheCrank) {
  testing::RandomFourBars draw(79);
  for (std::uint64_t seed = 541; seed <= 552; ++seed) {
    const TracingFourBar linkage = testing::drawn_linkage(seed, true);
    const CurveTarget target = testing::traced_target(linkage, true, 20);
    CurveTiming timing;
    for (int k = 0; k < 20; ++k) timing.input.push_back(two_pi * k / 20);
    CurveFitOptions options{.effort = FitEffort::quick, .max_length = 1000, .min_length = 1e-6};
    const std::size_t without = fit_timed_curve(target, timing, options).counts.starts;
    options.starts = {disturbed(linkage, 0.003, draw), unmovable};
    const CurveFits found = fit_timed_curve(target, timing, options);
    ASSERT_FALSE(found.fits.empty()) << seed;
    EXPECT_LT(found.fits.front().error.rms_over_diagonal, nearly) << seed;
    EXPECT_GT(found.counts.starts, without);
  }
}

TEST(GivenStarts, LeadBackToTheLinkageThatLeftThePoses) {
  testing::RandomFourBars draw(80);
  for (std::uint64_t seed = 561; seed <= 572; ++seed) {
    const TracingFourBar linkage = testing::drawn_linkage(seed, true);
    const double sense = seed % 2 == 0 ? 1 : -1;
    PoseTarget target;
    for (const auto& state : motion_sweep(linkage.bars, linkage.point, sense * 2, 12))
      target.poses.push_back(
          {state.coupler_point, std::arg(state.four_bar.output_moving - state.four_bar.input_moving)});
    target.turning_length = linkage.bars.lengths().coupler;
    PoseFitOptions options{.effort = FitEffort::quick, .max_length = 1000, .min_length = 1e-6, .max_link_ratio = 1e6};
    const std::size_t without = fit_poses(target, options).counts.starts;
    options.starts = {{unmovable.bars, {}}, {disturbed(linkage, 0.003, draw).bars, {}}, {unknown.bars, {}}};
    const PoseFits found = fit_poses(target, options);
    ASSERT_FALSE(found.fits.empty()) << seed;
    EXPECT_LT(found.fits.front().error.rms, 1e-8 * target.scale()) << seed;
    EXPECT_GT(found.counts.starts, without);
  }
}

// Another measure of the same: what a long search found is found by a short one that begins there.
TEST(GivenStarts, BringALongSearchIntoAShortOne) {
  const CurveTarget target = testing::curve_case("mkh2").target;
  CurveFitOptions options;
  const CurveFits longer = fit_curve(target, options);
  options.effort = FitEffort::quick;
  for (const CurveFit& fit : longer.fits) options.starts.push_back(fit.linkage());
  const CurveFits found = fit_curve(target, options);
  ASSERT_FALSE(found.fits.empty());
  ASSERT_GE(found.fits.size(), longer.fits.size() / 2);
  EXPECT_LE(found.fits.front().error.sum_of_squares, (1 + 1e-9) * longer.fits.front().error.sum_of_squares);
}

// Of another curve, they are not listed among what was found for this one.
TEST(GivenStarts, AreListedThemselvesOnlyWhereNothingIsNearer) {
  const CurveTarget target = testing::curve_case("mkh2").target;
  CurveFitOptions options{.effort = FitEffort::quick};
  const double usual = fit_curve(target, options).fits.front().error.sum_of_squares;
  for (std::uint64_t seed = 581; seed <= 588; ++seed) options.starts.push_back(testing::drawn_linkage(seed, true));
  const CurveFits found = fit_curve(target, options);
  ASSERT_FALSE(found.fits.empty());
  EXPECT_LE(found.fits.front().error.sum_of_squares, (1 + 1e-9) * usual);
  for (const CurveFit& fit : found.fits)
    for (const TracingFourBar& start : options.starts)
      EXPECT_GT(std::abs(fit.linkage().bars.input_fixed - start.bars.input_fixed) +
                    std::abs(fit.linkage().bars.output_fixed - start.bars.output_fixed),
                1e-6);
}

}  // namespace
}  // namespace linkwright::given_starts_test
