#include "support/curve_gallery.hpp"

#include <algorithm>
#include <gtest/gtest.h>

#include "linkwright/approximate/curve_fit.hpp"
#include "linkwright/mechanism/coupler_curve.hpp"

namespace linkwright::curve_gallery_test {
namespace {

// By the tree's own motion, which knows nothing of fits: exact but for the steps.
double farthest_from_path(const TracingFourBar& linkage, const CurveTarget& target) {
  const auto path = motion_cycle(linkage.bars, linkage.point, 20'000);
  double farthest = 0;
  for (const Point p : target.points) {
    double least = std::abs(p - path.front().coupler_point);
    for (const MotionState& state : path) least = std::min(least, std::abs(p - state.coupler_point));
    farthest = std::max(farthest, least);
  }
  return farthest;
}

// Steps of the path are as long as those of the polygon but where it bends, and so no polygon's step is longer.
TEST(CurveGallery, PointsStandAtEqualSteps) {
  const auto gallery = testing::curve_gallery();
  ASSERT_EQ(gallery.size(), 24u);
  for (const testing::GalleryCurve& curve : gallery) {
    const std::vector<Point>& points = curve.target.points;
    ASSERT_EQ(points.size(), 64u);
    std::vector<double> steps;
    for (std::size_t k = 1; k < points.size(); ++k) steps.push_back(std::abs(points[k] - points[k - 1]));
    if (curve.target.closed) steps.push_back(std::abs(points.front() - points.back()));
    std::sort(steps.begin(), steps.end());
    EXPECT_LT(steps.back(), 1.03 * steps[steps.size() / 2]) << curve.id;
  }
}

// Two short arcs of non-Grashof linkages have many linkages that pass all but exactly along them; the rest have one.
TEST(CurveGallery, IsFoundAgain) {
  for (const testing::GalleryCurve& curve : testing::curve_gallery()) {
    const bool is_short_arc = curve.id.rfind("non-grashof", 0) == 0;
    const CurveFits found = fit_curve(curve.target);
    ASSERT_FALSE(found.fits.empty()) << curve.id;
    const CurveFit& best = found.fits.front();
    EXPECT_LE(best.error.rms_over_diagonal, is_short_arc ? 1e-6 : 1e-9) << curve.id;
    EXPECT_TRUE(best.drive.no_defects(curve.target.closed) && best.within_limits) << curve.id;
    EXPECT_LE(farthest_from_path(best.linkage(), curve.target), 1e-3 * curve.target.diagonal()) << curve.id;
  }
}

}  // namespace
}  // namespace linkwright::curve_gallery_test
