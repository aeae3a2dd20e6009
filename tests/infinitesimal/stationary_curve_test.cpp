#include <gtest/gtest.h>

#include "linkwright/infinitesimal/stationary_curvature.hpp"
#include "support/circle_contact.hpp"

namespace linkwright::stationary_curve_test {
namespace {

MotionSeries motion_of(const FourBar& bars) { return coupler_motion(bars, *loop_series(bars)); }

void expect_four_point_contact(const FourBar& bars) {
  const MotionSeries motion = motion_of(bars);
  const Instant instant = *instant_of(motion);
  const StationaryCurve curve = circling_point_curve(instant);
  ASSERT_FALSE(curve.pieces.empty());
  int checked = 0;
  for (const auto& piece : curve.pieces)
    for (double share = 0.0137; share < 1; share += 0.05) {
      const auto point = finite_point(piece(share));
      if (!point || std::abs(*point) > 50) continue;
      const auto center = center_of_curvature(motion, *point);
      if (!center) continue;
      const auto finite = finite_point(normalized(*center));
      if (!finite || std::abs(*finite) > 1e4) continue;
      if (std::abs(*finite - *point) < 1e-6) continue;  // the pole
      EXPECT_GE(testing::contact_with_circle(motion, *point, *finite), 4) << *point;
      ++checked;
    }
  EXPECT_GT(checked, 5);
}

TEST(StationaryCurve, HoldsPointsWithFourPointContact) {
  expect_four_point_contact({{0, 0}, {1, 1.2}, {4, 0.3}, {3.5, 3}});
  expect_four_point_contact({{-2, 0}, {-1, 1.5}, {2, 0}, {1, 1.5}});      // coupler parallel to the frame
  expect_four_point_contact({{0, 0}, {1, 0}, {4, 0}, {3, 2}});            // input on the frame line
  expect_four_point_contact({{0, 0}, {1, 0.5}, {4, -1}, {3, 1.5}});       // crank in line with the coupler
  expect_four_point_contact({{0, 0}, {0, 1}, {3, 4}, {3, 1.5}});          // parallel side links
  expect_four_point_contact({{0, 0}, {0.3, 1.1}, {4, -1}, {3.4, -3.2}});  // the same, aslant and apart
}

// On the same ray, and so at the same share.
TEST(StationaryCurve, CentersAreOnTheCenteringPointCurve) {
  const MotionSeries motion = motion_of({{0, 0}, {1, 1.2}, {4, 0.3}, {3.5, 3}});
  const Instant instant = *instant_of(motion);
  const auto circling = circling_point_curve(instant), centering = centering_point_curve(instant);
  ASSERT_EQ(circling.pieces.size(), 1U);
  ASSERT_EQ(centering.pieces.size(), 1U);
  for (double share = 0.04; share < 1; share += 0.07) {
    const Point point = *finite_point(circling.pieces[0](share));
    const Point center = *finite_point(*center_of_curvature(motion, point));
    EXPECT_NEAR(std::abs(*finite_point(centering.pieces[0](share)) - center), 0, 1e-10 * (1 + std::norm(center)));
  }
}

TEST(StationaryCurve, PassesThroughThePivots) {
  const FourBar bars{{0, 0}, {0.3, 1.1}, {4, -1}, {3.4, -3.2}};
  const auto instant = std::get<TranslatingInstant>(*instant_of(motion_of(bars)));
  ASSERT_TRUE(instant.circling_points);
  const auto product_at = [&](const EquilateralHyperbola& hyperbola, Point p) {
    const Point local = std::conj(instant.velocity) * (p - hyperbola.center);
    return local.real() * local.imag() - hyperbola.product;
  };
  for (const Point pivot : {bars.input_moving, bars.output_moving})
    EXPECT_NEAR(product_at(*instant.circling_points, pivot), 0, 1e-12);
  for (const Point pivot : {bars.input_fixed, bars.output_fixed})
    EXPECT_NEAR(product_at(*instant.centering_points(), pivot), 0, 1e-12);
}

TEST(StationaryCurve, IsNoneWhereAllPointsHaveIt) {
  const FourBar parallelogram{{0, 0}, {1, 2}, {4, 0}, {5, 2}};
  EXPECT_TRUE(circling_point_curve(*instant_of(motion_of(parallelogram))).pieces.empty());
  EXPECT_TRUE(centering_point_curve(PivotingInstant{{1, 2}}).pieces.empty());
}

// Coupler at right angles to parallel side links: Watt's.
TEST(StationaryCurve, OfWattsLinkageIsThePairOfItsAsymptotes) {
  const FourBar watt{{-2, 0.5}, {0, 0.5}, {2, -0.5}, {0, -0.5}};
  const auto instant = std::get<TranslatingInstant>(*instant_of(motion_of(watt)));
  ASSERT_TRUE(instant.circling_points);
  EXPECT_NEAR(instant.circling_points->product, 0, 1e-15);
  EXPECT_EQ(circling_point_curve(instant).pieces.size(), 2U);
}

}  // namespace
}  // namespace linkwright::stationary_curve_test
