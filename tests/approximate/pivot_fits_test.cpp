#include "linkwright/approximate/pivot_fits.hpp"

#include <atomic>
#include <cmath>
#include <gtest/gtest.h>

#include "support/curve_case.hpp"

namespace linkwright::pivot_fits_test {
namespace {

const CurveFitOptions quick{.effort = FitEffort::quick};

std::vector<Point> lattice_around(const CurveTarget& target, int count) {
  const double size = target.diagonal();
  std::vector<Point> places;
  for (int i = 0; i < count; ++i)
    for (int k = 0; k < count; ++k)
      places.push_back(target.points.front() + 3 * size * Point{(i + 0.5) / count - 0.5, (k + 0.5) / count - 0.5});
  return places;
}

class PivotFitsOf : public ::testing::TestWithParam<const char*> {
 protected:
  const testing::CurveCase c = testing::curve_case(GetParam());
  const CurveFits known = fit_curve(c.target);
  const std::vector<Point> lattice = lattice_around(c.target, 12);
  const PivotFits fits{c.target, {}, lattice, known.fits};
};

TEST_P(PivotFitsOf, FindTheBestCurveAtEachPivotItIsDrivenFrom) {
  ASSERT_FALSE(known.fits.empty());
  const CurveFit& best = known.fits.front();
  int drivers = 0;
  for (std::size_t k = 0; k < best.realisation_count; ++k) {
    const FourBar& bars = best.realisations[k].bars;
    const auto there = fits.at(bars.input_fixed);
    ASSERT_TRUE(there);
    EXPECT_LE(std::abs(there->linkage().bars.input_fixed - bars.input_fixed), 1e-9 * c.target.diagonal());
    EXPECT_GE(there->error.sum_of_squares, (1 - 1e-6) * best.error.sum_of_squares);
    const bool is_same = there->error.sum_of_squares <= (1 + 1e-6) * best.error.sum_of_squares + 1e-24;
    drivers += is_same && there->drive.no_defects(c.target.closed) ? 1 : 0;
  }
  EXPECT_GE(drivers, 1);
}

TEST_P(PivotFitsOf, HoldThePivotWhereItIsAskedForAndComeNoNearerThanWithout) {
  ASSERT_FALSE(known.fits.empty());
  const double least = known.fits.front().error.sum_of_squares;
  int found = 0;
  for (const Point place : lattice) {
    const auto there = fits.at(place);
    if (!there) continue;
    EXPECT_LE(std::abs(there->linkage().bars.input_fixed - place), 1e-9 * c.target.diagonal());
    const bool is_clean = there->drive.no_defects(c.target.closed) && there->within_limits;
    if (is_clean) {
      EXPECT_GE(there->error.sum_of_squares, 0.98 * least) << place;
    }
    found += is_clean ? 1 : 0;
  }
  EXPECT_GT(found, static_cast<int>(lattice.size()) / 4);
}

INSTANTIATE_TEST_SUITE_P(Of, PivotFitsOf, ::testing::Values("mkh2", "yu1", "tri24", "wu3_open"));

TEST(PivotFits, GiveTheSameAnswerWhateverTheThreads) {
  const testing::CurveCase c = testing::curve_case("yu1");
  const std::vector<Point> lattice = lattice_around(c.target, 5);
  CurveFitOptions one = quick, many = quick;
  one.threads = 1;
  many.threads = 3;
  const PivotFits a(c.target, one, lattice, {}), b(c.target, many, lattice, {});
  for (const Point place : lattice) {
    const auto first = a.at(place + Point{0.1, 0.2}), second = b.at(place + Point{0.1, 0.2});
    ASSERT_EQ(first.has_value(), second.has_value());
    if (first) {
      EXPECT_EQ(first->error.sum_of_squares, second->error.sum_of_squares);
    }
  }
}

// A target moved, turned and enlarged has the map moved, turned and enlarged.
TEST(PivotFits, GoWithTheTarget) {
  const testing::CurveCase c = testing::curve_case("mkh2");
  const Point turn = 3.0 * direction(0.7), shift{40, -25};
  CurveTarget other = c.target;
  for (Point& p : other.points) p = shift + turn * p;
  std::vector<Point> lattice = lattice_around(c.target, 6), moved;
  for (const Point p : lattice) moved.push_back(shift + turn * p);
  const PivotFits fits(c.target, quick, lattice, {}), others(other, quick, moved, {});
  int alike = 0, both = 0;
  for (std::size_t k = 0; k < lattice.size(); ++k) {
    const auto one = fits.at(lattice[k]), two = others.at(moved[k]);
    if (!one || !two) continue;
    ++both;
    alike += std::abs(3 * one->error.rms - two->error.rms) <= 1e-3 * two->error.rms ? 1 : 0;
  }
  EXPECT_GE(both, 30);
  EXPECT_GE(alike, both * 9 / 10) << "of " << both;
}

TEST(PivotFits, MayBeCancelled) {
  const testing::CurveCase c = testing::curve_case("yu1");
  const std::atomic<bool> cancelled = true;
  Progress progress;
  progress.cancelled = &cancelled;
  const std::vector<Point> lattice = lattice_around(c.target, 20);
  const PivotFits fits(c.target, quick, lattice, {}, progress);
  const auto there = fits.at(c.target.points.front() + Point{10, 10});
  if (there) {
    EXPECT_TRUE(std::isfinite(there->error.rms));
  }
}

}  // namespace
}  // namespace linkwright::pivot_fits_test
