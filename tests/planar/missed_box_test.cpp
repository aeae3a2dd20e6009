#include "linkwright/planar/missed_box.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "linkwright/planar/task_family.hpp"
#include "support/planar_case.hpp"

namespace linkwright::missed_box_test {
namespace {

class MissedBoxes : public ::testing::Test {
 protected:
  TaskFamily task = task_family(MotionTask{testing::planar_case("landing_gear").poses}, {}, {});
  const FourBarFamily& family = *task.family;

  [[nodiscard]] std::vector<Point> curve(Homogeneous Dyad::*end) const {
    std::vector<Point> points;
    for (const double tau : family.samples(Side::input, 20'000, Spacing::arc_length))
      if (const auto links = family.dyad_pair({tau, tau}))
        if (const auto p = finite_point(links->input.*end)) points.push_back(family.frame().to_user(*p));
    return points;
  }
  [[nodiscard]] static double distance(const Box& box, Point p) {
    return std::hypot(p.real() - std::clamp(p.real(), box.x_low, box.x_high),
                      p.imag() - std::clamp(p.imag(), box.y_low, box.y_high));
  }
};

TEST_F(MissedBoxes, NearestIsNearerThanAnySample) {
  int missed = 0;
  for (const auto& [kind, end] : {std::pair(RequirementKind::ground_pivots_within, &Dyad::center),
                                  std::pair(RequirementKind::moving_pivots_within, &Dyad::circle)}) {
    const std::vector<Point> points = curve(end);
    for (int x = -1500; x <= 1500; x += 250)
      for (int y = -1500; y <= 1500; y += 250) {
        const Box box{double(x), x + 60.0, double(y), y + 40.0};
        Requirements wanted;
        (kind == RequirementKind::ground_pivots_within ? wanted.ground_pivots_within : wanted.moving_pivots_within) =
            box;
        double least = 1e9;
        for (const Point p : points) least = std::min(least, distance(box, p));
        const auto found = missed_boxes(family, wanted);
        if (least == 0) {
          EXPECT_TRUE(found.empty()) << x << " " << y;
          continue;
        }
        ASSERT_LE(found.size(), 1u);
        if (found.empty()) {
          EXPECT_LT(least, 1) << "it may slip in between two samples";
          continue;
        }
        ++missed;
        EXPECT_EQ(found[0].box, kind);
        EXPECT_LE(distance(box, found[0].nearest), least + 1e-6);
        EXPECT_NEAR(std::abs(found[0].beyond), distance(box, found[0].nearest), 1e-9);
      }
  }
  EXPECT_GT(missed, 100);
}

TEST(MissedBox, IsToldInWords) {
  const MissedBox below{RequirementKind::ground_pivots_within, {250, 210}, {0, -60}};
  EXPECT_EQ(missed_box_text(below),
            "The centre-point curve does not enter ground_pivots_within; nearest is (250, 210), 60 below it.");
  const MissedBox aside{RequirementKind::moving_pivots_within, {-12.5, 3}, {7.25, 2}};
  EXPECT_EQ(missed_box_text(aside),
            "The circle-point curve does not enter moving_pivots_within; nearest is (-12.5, 3), 7.25 right of and 2 "
            "above it.");
}

}  // namespace
}  // namespace linkwright::missed_box_test
