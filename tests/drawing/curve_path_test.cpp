#include "drawing/curve_path.hpp"

#include <array>
#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "support/draws.hpp"
#include "support/file_support.hpp"

namespace linkwright::curve_path_test {
namespace {

constexpr PixelBox box{0, 0, 800, 600};

double distance(Point p, Point from, Point to) {
  const Point way = to - from;
  const double share = std::norm(way) > 0 ? std::clamp(dot(p - from, way) / std::norm(way), 0.0, 1.0) : 0;
  return std::abs(p - from - share * way);
}

double distance(Point p, const std::vector<std::vector<Point>>& paths) {
  double nearest = 1e300;
  for (const auto& path : paths) {
    for (std::size_t i = 0; i + 1 < path.size(); ++i) nearest = std::min(nearest, distance(p, path[i], path[i + 1]));
  }
  return nearest;
}

/// Every point of the curve in the window is on a path, and no stretch of a path is a leap.
void expect_faithful(const Problem& problem, const PlaneWindow& window) {
  const Answer answer = testing::answer_of(problem);
  const WorkingFrame& frame = testing::four_bars(answer).given.conditions.frame;
  const CurvePaths paths = visible_curves(*testing::four_bars(answer).given.curve, frame, window);
  const auto visible = [&](Point px) {
    return px.real() > box.left && px.real() < box.right() && px.imag() > box.top && px.imag() < box.bottom();
  };
  const BurmesterCurve& curve = *testing::four_bars(answer).given.curve;
  const int points = testing::draws(4000);
  int seen = 0;
  for (int i = 0; i < points; ++i) {
    const Dyad dyad = frame.to_user(curve.dyad(curve.coordinate_length() * (i + 0.37) / points));
    for (const auto& [point, drawn] :
         {std::pair{dyad.center, &paths.centers}, std::pair{dyad.circle, &paths.circles}}) {
      if (point.w == 0) continue;
      const Point px = window.to_px({point.x / point.w, point.y / point.w});
      if (!visible(px)) continue;
      ++seen;
      EXPECT_LT(distance(px, *drawn), 0.5);
    }
  }
  EXPECT_GT(seen, points / 40);
  for (const auto* drawn : {&paths.centers, &paths.circles}) {
    for (const auto& path : *drawn) {
      for (std::size_t i = 0; i + 1 < path.size(); ++i) EXPECT_LT(std::abs(path[i + 1] - path[i]), 60);
    }
  }
}

TEST(CurvePath, IsTheCurveThatTheWindowShows) {
  const std::array<Point, 2> around = {Point{-300, -100}, Point{500, 500}};
  expect_faithful(testing::tailgate(), PlaneWindow(box, around, 0));
  const std::array<Point, 2> close = {Point{100, 250}, Point{200, 360}};
  expect_faithful(testing::tailgate(), PlaneWindow(box, close, 0));
  const std::array<Point, 2> far = {Point{-30'000, -30'000}, Point{30'000, 30'000}};
  expect_faithful(testing::tailgate(), PlaneWindow(box, far, 0));
}

TEST(CurvePath, OfDegenerateCurvesIsWholeToo) {
  const Problem symmetric = testing::problem_of({{-2, 0, 30}, {-1, 1, 10}, {1, 1, -10}, {2, 0, -30}});
  const std::array<Point, 2> around = {Point{-6, -6}, Point{6, 6}};
  expect_faithful(symmetric, PlaneWindow(box, around, 0));
}

Dyad dyad_at(double x, double tau) { return {{1, x, 10}, {1, x, 30}, tau}; }

TEST(CurvePath, OfAPolygonBreaksAtInfinityAndAtLeaps) {
  const std::array<Point, 2> around = {Point{0, 0}, Point{800, 600}};
  const PlaneWindow window(box, around, 0);
  std::vector<Dyad> dyads;
  for (int i = 0; i < 10; ++i) dyads.push_back(dyad_at(100 + 20 * i, 0.05 * i));
  for (int i = 0; i < 10; ++i) dyads.push_back(dyad_at(500 + 20 * i, 1 + 0.05 * i));  // the next branch, far away
  const CurvePaths paths = visible_polygon(dyads, window);
  ASSERT_EQ(paths.centers.size(), 2u);
  EXPECT_EQ(paths.centers[0].size(), 10u);
  EXPECT_EQ(paths.circles.size(), 2u);
  dyads[15].center = {0, 1, 0};
  EXPECT_EQ(visible_polygon(dyads, window).centers.size(), 4u) << "parted, and joined again with a stretch";
  dyads[15].center = {1, 620, 600};
  EXPECT_GT(visible_polygon(dyads, window).centers.size(), 2u);
}

TEST(CurvePath, OfAPolygonJoinsTheEndsOfSheetsThatMeet) {
  const std::array<Point, 2> around = {Point{0, 0}, Point{800, 600}};
  const PlaneWindow window(box, around, 0);
  std::vector<Dyad> dyads;
  for (int i = 0; i < 10; ++i) dyads.push_back(dyad_at(100 + 20 * i, 0.05 * i));
  for (int i = 0; i < 10; ++i) dyads.push_back({{1, 100.0 + 20 * i, 30}, {1, 100, 30.0 + i}, 1 + 0.05 * i});
  EXPECT_EQ(visible_polygon(dyads, window).centers.size(), 4u) << "two paths and a stretch at either end";
}

// A circle of 40 times the window's width, and a line through it: what can be seen, and nothing else.
TEST(CurvePath, OfAClosedCurveIsThePartInTheWindow) {
  const std::array<Point, 2> around = {Point{-4, -3}, Point{4, 3}};
  const PlaneWindow window(box, around, 0);
  constexpr double radius = 320;
  const auto circle = [=](double share) {
    return Homogeneous::of(Point{0, radius} + radius * direction(two_pi * share));
  };
  const auto arc = visible_curve(circle, window);
  ASSERT_FALSE(arc.empty());
  double length = 0;
  for (const auto& path : arc)
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      length += std::abs(path[i + 1] - path[i]);
      EXPECT_NEAR(std::abs(window.to_user(path[i]) - Point{0, radius}), radius, 1e-3);
    }
  EXPECT_NEAR(length, 840, 10);  // with what is drawn beyond the borders
  const auto line = visible_curve(
      [](double share) {
        return Homogeneous{std::cos(pi * share), std::sin(pi * share), 1e-3};
      },
      window);
  EXPECT_TRUE(line.size() == 1 || line.size() == 2);  // which begins in the window or beyond it
  const auto nowhere =
      visible_curve([](double share) { return Homogeneous::of(100.0 + direction(two_pi * share)); }, window);
  EXPECT_TRUE(nowhere.empty());
}

}  // namespace
}  // namespace linkwright::curve_path_test
