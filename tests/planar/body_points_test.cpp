#include "linkwright/planar/body_points.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "support/random_task.hpp"

namespace linkwright::body_points_test {
namespace {

using testing::uniform;

double miss(const std::vector<BodyPoints>& given, const std::vector<Pose>& poses, double distance) {
  double sum = 0;
  for (std::size_t i = 0; i < given.size(); ++i)
    sum += std::norm(given[i].first - poses[i].origin) +
           std::norm(given[i].second - poses[i].origin - distance * direction(poses[i].angle));
  return sum;
}

TEST(BodyPoints, OfOneDistanceAreTheFramesOriginAndAPointOfItsXAxis) {
  const std::vector<BodyPoints> given = {{{1, 2}, {4, 6}}, {{0, 0}, {0, -5}}, {{7, 1}, {2, 1}}};
  const std::vector<Pose> poses = poses_of_points(given);
  EXPECT_FALSE(points_notice(given));
  for (std::size_t i = 0; i < given.size(); ++i) {
    EXPECT_LT(std::abs(poses[i].origin - given[i].first), 1e-14);
    EXPECT_LT(std::abs(poses[i].origin + 5.0 * direction(poses[i].angle) - given[i].second), 1e-14);
  }
}

TEST(BodyPoints, OfDifferentDistancesAreFittedByLeastSquaresAndTold) {
  std::mt19937_64 random(1);
  std::vector<BodyPoints> given;
  for (int i = 0; i < 4; ++i) {
    const Point at{uniform(random, -9, 9), uniform(random, -9, 9)};
    given.push_back({at, at + uniform(random, 4.9, 5.1) * direction(uniform(random, -3, 3))});
  }
  const std::vector<Pose> poses = poses_of_points(given);
  const auto notice = points_notice(given);
  ASSERT_TRUE(notice);
  EXPECT_EQ(notice->code, "points_distance");
  const auto value = [&](std::size_t i) { return std::get<double>(notice->values[i].value); };
  const double distance = value(2), best = miss(given, poses, distance);
  EXPECT_LT(value(0), distance);
  EXPECT_GT(value(1), distance);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<Pose> other = poses;
    for (Pose& pose : other) {
      pose.origin += 1e-3 * Point{uniform(random, -1, 1), uniform(random, -1, 1)};
      pose.angle += 1e-3 * uniform(random, -1, 1);
    }
    EXPECT_GT(miss(given, other, distance + 1e-3 * uniform(random, -1, 1)), best);
  }
  double worst = 0;
  for (std::size_t i = 0; i < given.size(); ++i) worst = std::max(worst, std::abs(poses[i].origin - given[i].first));
  EXPECT_NEAR(value(3), worst, 1e-12);
}

TEST(BodyPoints, NamesThePlaceOfEachMistake) {
  std::vector<Error> found;
  check_points(std::vector<BodyPoints>{{{1, 2}, {1, 2}}, {{1, 2}, {3, 2e9}}}, found);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].code, "same_points");
  EXPECT_EQ(found[0].place, "task.poses[0].points");
  EXPECT_EQ(found[1].place, "task.poses[1].points[1][1]");
}

}  // namespace
}  // namespace linkwright::body_points_test
