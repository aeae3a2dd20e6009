#include "linkwright/approximate/curve_fit.hpp"

#include <algorithm>
#include <atomic>
#include <gtest/gtest.h>

#include "linkwright/mechanism/coupler_curve.hpp"
#include "linkwright/mechanism/linkage_type.hpp"
#include "support/curve_case.hpp"

namespace linkwright::curve_fit_test {
namespace {

const CurveFitOptions quick{.effort = FitEffort::quick};

double distance_to_path(Point p, const std::vector<MotionState>& path) {
  double least = std::abs(p - path.front().coupler_point);
  for (std::size_t k = 1; k < path.size(); ++k) {
    const Point from = path[k - 1].coupler_point, along = path[k].coupler_point - from;
    const double share = std::clamp(dot(p - from, along) / std::norm(along), 0.0, 1.0);
    least = std::min(least, std::abs(p - from - share * along));
  }
  return least;
}

// The sum of squares by the tree's own motion, in 20 000 steps: it shares nothing with the fit.
double sampled_sum_of_squares(const TracingFourBar& linkage, const CurveTarget& target) {
  const auto path = motion_cycle(linkage.bars, linkage.point, 20'000);
  double sum = 0;
  for (const Point p : target.points) sum += std::pow(distance_to_path(p, path), 2);
  return sum;
}

class PublishedTarget : public ::testing::TestWithParam<const char*> {};

TEST_P(PublishedTarget, IsFittedAsWellAsIsKnown) {
  const testing::CurveCase c = testing::curve_case(GetParam());
  const CurveFits found = fit_curve(c.target);
  ASSERT_FALSE(found.fits.empty());
  const CurveFit& best = found.fits.front();
  EXPECT_LE(best.error.sum_of_squares, 1.002 * c.best);
  EXPECT_TRUE(best.drive.no_defects(c.target.closed));
  EXPECT_TRUE(best.within_limits);
  EXPECT_LE(sampled_sum_of_squares(best.linkage(), c.target), 1.0001 * best.error.sum_of_squares);
}

INSTANTIATE_TEST_SUITE_P(Of, PublishedTarget,
                         ::testing::Values("mkh2", "mkh3", "yu1", "yu2", "tri24", "gait13", "wu3_open", "mcgarva",
                                           "ullah", "slice11"));

// Of nine points on an ellipse: the elliptic trammel is exact, and ever longer links come ever nearer to it.
TEST(CurveFit, LongerLinksComeNearerToAnEllipse) {
  const CurveTarget target = testing::curve_case("ell10").target;
  const auto error = [&](double max_length) {
    CurveFitOptions options;
    options.max_length = max_length / target.diagonal();
    return fit_curve(target, options).fits.front().error.sum_of_squares;
  };
  EXPECT_LE(error(60), 1.002 * 1.2118e-3);
  EXPECT_LE(error(80), 1.002 * 4.0507e-4);
  EXPECT_LE(error(400), error(80));
}

TEST(CurveFit, FindsExactClosedCurvesAgain) {
  int exact = 0;
  constexpr int draws = 30;
  for (int seed = 0; seed < draws; ++seed) {
    const CurveTarget target = testing::traced_target(testing::drawn_linkage(seed + 1, true), true, 48);
    const CurveFits found = fit_curve(target, quick);
    if (!found.fits.empty() && found.fits.front().error.rms_over_diagonal < 1e-9) ++exact;
  }
  EXPECT_GE(exact, draws - 1);
}

// Their paths are nearly circles, to which dyads of any lengths come about as near.
TEST(CurveFit, FindsPathsOfDoubleCranksAgain) {
  int exact = 0;
  constexpr int draws = 40;
  testing::RandomFourBars draw(1);
  for (int k = 0; k < draws; ++k) {
    const TracingFourBar linkage = testing::drawn_linkage(draw, {LinkageType::double_crank});
    const CurveFits found = fit_curve(testing::traced_target(linkage, true, 48), quick);
    if (!found.fits.empty() && found.fits.front().error.rms_over_diagonal < 1e-9) ++exact;
  }
  EXPECT_GE(exact, draws - 6);
}

TEST(CurveFit, FollowsDensePointsThroughTheirNoise) {
  for (const bool closed : {true, false}) {
    CurveTarget target = testing::traced_target(testing::drawn_linkage(3, true), closed, 300);
    const double noise = 0.004 * target.diagonal();
    std::uint64_t state = 7;
    const auto draw = [&] {  // sum of uniforms: of variance 1, all but normal
      double sum = -6;
      for (int k = 0; k < 12; ++k) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        sum += static_cast<double>(state >> 11) * 0x1p-53;
      }
      return sum;
    };
    for (Point& point : target.points) point += noise * Point{draw(), draw()};
    const CurveFits found = fit_curve(target, quick);
    ASSERT_FALSE(found.fits.empty()) << closed << ": neighbours lie nearer to each other than their noise";
    EXPECT_LT(found.fits.front().error.rms, 1.2 * noise) << closed;
  }
}

TEST(CurveFit, IsTracedByThreeRealisations) {
  const CurveTarget target = testing::curve_case("yu1").target;
  const CurveFits found = fit_curve(target);
  ASSERT_FALSE(found.fits.empty());
  const CurveFit& best = found.fits.front();
  ASSERT_EQ(best.realisation_count, 3);
  for (const TracingFourBar& linkage : best.realisations)
    EXPECT_NEAR(sampled_sum_of_squares(linkage, target), best.error.sum_of_squares, 1e-4 * best.error.sum_of_squares);
}

TEST(CurveFit, IsTheSameWhateverTheThreadsAndTheInstructionSet) {
  const CurveTarget target = testing::curve_case("mkh2").target;
  CurveFitOptions options{.effort = FitEffort::quick, .threads = 1, .simd = Simd::scalar};
  const CurveFits first = fit_curve(target, options);
  ASSERT_FALSE(first.fits.empty());
  options.threads = 2;
  options.simd = Simd::automatic;
  const CurveFits second = fit_curve(target, options);
  ASSERT_EQ(first.fits.size(), second.fits.size());
  for (std::size_t k = 0; k < first.fits.size(); ++k)
    EXPECT_EQ(farthest_pivot(first.fits[k].linkage().bars, second.fits[k].linkage().bars), 0);
}

CurveTarget transformed(CurveTarget target, Point turn, Point shift) {
  for (Point& p : target.points) p = turn * p + shift;
  return target;
}

TEST(CurveFit, DoesNotDependOnTheFrameOrTheUnit) {
  for (const char* const name : {"mkh2", "gait13", "wu3_open"}) {
    const CurveTarget target = testing::curve_case(name).target;
    const double error = fit_curve(target, quick).fits.front().error.rms_over_diagonal;
    for (const double scale : {1e-6, 1.0, 1e6}) {
      const CurveTarget other = transformed(target, std::polar(scale, 0.7), {3 * scale, -5 * scale});
      const CurveFits found = fit_curve(other, quick);
      ASSERT_FALSE(found.fits.empty());
      const double size = other.diagonal() / (scale * target.diagonal());  // the box turns, too
      EXPECT_NEAR(found.fits.front().error.rms_over_diagonal * size, error, 0.01 * error) << name << scale;
    }
  }
}

TEST(CurveFit, DoesNotDependOnTheSenseOrTheFirstPoint) {
  for (const char* const name : {"mkh2", "yu1", "tri24"}) {
    CurveTarget target = testing::curve_case(name).target;
    const double error = fit_curve(target, quick).fits.front().error.rms;
    std::reverse(target.points.begin(), target.points.end());
    EXPECT_NEAR(fit_curve(target, quick).fits.front().error.rms, error, 1e-4 * error) << name;
    std::rotate(target.points.begin(), target.points.begin() + 5, target.points.end());
    EXPECT_NEAR(fit_curve(target, quick).fits.front().error.rms, error, 1e-4 * error) << name;
  }
}

TEST(CurveFit, ComesNearToPartsOfCurves) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const CurveTarget target = testing::traced_target(testing::drawn_linkage(seed, true), false, 48, 1.8);
    const CurveFits found = fit_curve(target, quick);
    ASSERT_FALSE(found.fits.empty()) << seed;
    EXPECT_LT(found.fits.front().error.rms_over_diagonal, 1e-5) << seed;
  }
}

TEST(CurveFit, AWeightOfZeroLeavesAPointOut) {
  CurveTarget target = testing::curve_case("mkh2").target;
  const double error = fit_curve(target).fits.front().error.sum_of_squares;
  target.weights.assign(target.points.size(), 3);
  EXPECT_NEAR(fit_curve(target).fits.front().error.sum_of_squares, 3 * error, 1e-4 * error);
  target.points.insert(target.points.begin() + 4, 0.5 * (target.points[3] + target.points[4]) + Point{0.1, -0.1});
  target.weights.insert(target.weights.begin() + 4, 0);
  const CurveFits found = fit_curve(target);
  ASSERT_FALSE(found.fits.empty());
  EXPECT_NEAR(found.fits.front().error.sum_of_squares, 3 * error, 1e-3 * error);
  EXPECT_NE(found.fits.front().error.max_at, 4);
}

// Nothing is asked of these but an answer without NaN.
TEST(CurveFit, AnswersStrangeTargets) {
  CurveTarget circle, line, doubled, three, zigzag;
  for (int k = 0; k < 20; ++k) circle.points.push_back(direction(k * 0.1 * 3.14159265));
  circle.closed = true;
  for (int k = 0; k < 15; ++k) line.points.emplace_back(k, 2 * k);
  for (int k = 0; k < 24; ++k) doubled.points.emplace_back(k / 2, (k / 2) % 3);
  three.points = {{0, 0}, {1, 0}, {0, 1}};
  for (int k = 0; k < 40; ++k) zigzag.points.emplace_back(k, k % 2 == 0 ? 0 : 30);
  for (CurveTarget target : {circle, line, doubled, three, zigzag}) {
    for (const bool closed : {false, true}) {
      target.closed = closed;
      const CurveFits found = fit_curve(target, quick);
      for (const CurveFit& fit : found.fits) {
        EXPECT_TRUE(std::isfinite(fit.error.sum_of_squares) && std::isfinite(fit.error.excursion));
        EXPECT_TRUE(is_finite(fit.linkage().point) && std::isfinite(fit.linkage().longest()));
        EXPECT_TRUE(fit.drive.no_defects(closed));
      }
    }
  }
}

TEST(CompareWithCurve, SaysOfAFitWhatTheFitSays) {
  for (const char* const name : {"yu1", "mkh3", "wu3_open"}) {
    const CurveTarget target = testing::curve_case(name).target;
    const CurveFits found = fit_curve(target, quick);
    ASSERT_FALSE(found.fits.empty());
    const CurveFit& fit = found.fits.front();
    for (std::size_t k = 0; k < fit.realisation_count; ++k) {
      const auto compared = compare_with_curve(fit.realisations[k], target);
      ASSERT_TRUE(compared);
      EXPECT_NEAR(compared->error.rms, fit.error.rms, 1e-6 * fit.error.rms) << name << k;
      EXPECT_NEAR(compared->error.excursion, fit.error.excursion, 0.05 * fit.error.excursion) << name << k;
      EXPECT_TRUE(compared->drive.in_order) << name << k;
    }
    EXPECT_TRUE(compare_with_curve(fit.linkage(), target)->drive.no_defects(target.closed));
  }
}

TEST(CompareWithCurve, IsExactOfPointsOnThePath) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const TracingFourBar linkage = testing::drawn_linkage(seed, true);
    CurveTarget target = testing::traced_target(linkage, true, 30);
    std::reverse(target.points.begin(), target.points.end());
    std::rotate(target.points.begin(), target.points.begin() + 7, target.points.end());
    const auto compared = compare_with_curve(linkage, target);
    ASSERT_TRUE(compared);
    EXPECT_LT(compared->error.rms_over_diagonal, 1e-12);
    EXPECT_TRUE(compared->drive.no_defects(true));
    EXPECT_NEAR(compared->error.path_length_ratio, 1, 0.05);
  }
}

TEST(CurveFit, StopsWhenAskedTo) {
  const std::atomic<bool> cancelled = true;
  const CurveFits found = fit_curve(testing::curve_case("mkh2").target, {.effort = FitEffort::deep}, {{}, &cancelled});
  EXPECT_TRUE(found.cancelled);
  EXPECT_TRUE(found.fits.empty());
}

}  // namespace
}  // namespace linkwright::curve_fit_test
