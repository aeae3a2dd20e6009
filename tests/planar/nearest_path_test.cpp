#include "planar/nearest_path.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <vector>

namespace linkwright::nearest_path_test {
namespace {

using ::testing::ElementsAre;

PathTask through(const std::vector<Point>& places) {
  PathTask task;
  for (const Point place : places) task.points.push_back({place, {}, {}, {}});
  return task;
}
PathTask hexagon() { return through({{2, 0}, {1, 2}, {-1, 2}, {-2, 0}, {-1, -2}, {1, -2}}); }

std::string codes(const PathTask& task) {
  std::string text;
  for (const Error& e : mistakes_in(task)) text += (text.empty() ? "" : " ") + e.code + "@" + e.place;
  return text;
}

TEST(NearestPath, IsAskedForByItsOwnMembersOrByMorePointsThanAnyPathPasses) {
  EXPECT_TRUE(hexagon().is_approximate());
  PathTask five = hexagon();
  five.points.pop_back();
  EXPECT_FALSE(five.is_approximate());
  five.closed = true;
  EXPECT_TRUE(five.is_approximate());
  EXPECT_EQ(five.form(), PathForm::nearest);
  EXPECT_EQ(&five.linkage_class(), &near_path_linkages);
  five.closed = false;
  five.points[2].weight = 2;
  EXPECT_TRUE(five.is_approximate());
  five.points[2].weight.reset();
  five.points[2].tolerance = 0.1;
  EXPECT_TRUE(five.is_approximate());
  five.points[2].tolerance.reset();
  five.between = PathBetween::free;
  EXPECT_TRUE(five.is_approximate());
  five.between.reset();
  EXPECT_EQ(&five.linkage_class(), &path_linkages);
  PathTask about_pivot = hexagon();
  about_pivot.pivots.input = Point{0, 0};
  EXPECT_FALSE(about_pivot.is_approximate()) << "it is told that one point is too many";
}

TEST(NearestPath, TellsWhatDoesNotGoWithIt) {
  EXPECT_EQ(codes(hexagon()), "");
  PathTask task = hexagon();
  task.closed = true;
  task.pivots.input = Point{0, 0};
  EXPECT_EQ(codes(task), "");
  task.map = NearestMap::pivots;
  EXPECT_EQ(codes(task), "pivot_map_with_pivots@task.map");
  task.map.reset();
  task.pivots.output = task.pivots.input;
  EXPECT_EQ(codes(task), "pivots_at_one_place@task.given.ground_pivots");
  task.pivots.output = task.points[2].point;
  EXPECT_EQ(codes(task), "point_at_pivot@task.points[2]");
  task = hexagon();
  task.closed = true;
  task.points[1].input = 0.5;
  EXPECT_EQ(codes(task), "nearest_with_angles@task.points[1].input_deg");
  task.points[1] = {{1, 2}, {}, {}, {{{1, 0}, {}, {}}}};
  EXPECT_EQ(codes(task), "nearest_with_derivatives@task.points[1].derivatives");
  task.points = {{{0, 0}, {}, {}, {}}, {{1, 0}, {}, {}, {}}, {{0, 0}, {}, {}, {}}};
  EXPECT_EQ(codes(task), "too_few_near_points@task.points");
}

TEST(NearestPath, TellsPointsWhoseDistancesHaveNoSquares) {
  for (const double size : {1e-50, 1e-61, 1e-200, 1e-310}) {
    PathTask task = hexagon();
    for (PathPoint& point : task.points) point.point *= size;
    EXPECT_EQ(codes(task), size > 1e-60 ? "" : "too_few_near_points@task.points") << size;
  }
}

TEST(NearestPath, TellsTolerancesAndWeightsOutOfRange) {
  PathTask task = hexagon();
  for (const double wrong :
       {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    task = hexagon();
    task.tolerance = wrong;
    EXPECT_EQ(codes(task), "path_tolerance@task.tolerance");
    task = hexagon();
    task.points[3].tolerance = wrong;
    EXPECT_EQ(codes(task), "path_tolerance@task.points[3].tolerance");
  }
  task = hexagon();
  task.points[0].weight = -1;
  EXPECT_EQ(codes(task), "path_weight@task.points[0].weight");
  for (PathPoint& point : task.points) point.weight = 0;
  EXPECT_EQ(codes(task), "no_path_weight@task.points");
}

TEST(NearestPath, LeavesOutEqualNeighboursAndThePointThatCloses) {
  PathTask task = through({{2, 0}, {2, 0}, {1, 2}, {-1, 2}, {-1, 2}, {-2, 0}, {2, 0}});
  task.closed = true;
  NearestTarget near = nearest_target(task);
  EXPECT_THAT(near.point, ElementsAre(0, 2, 3, 5));
  ASSERT_EQ(near.warnings.size(), 2u);
  EXPECT_EQ(near.warnings[0].code, "path_points_repeated");
  EXPECT_EQ(near.warnings[1].code, "path_point_closes");
  task.closed = false;
  near = nearest_target(task);
  EXPECT_THAT(near.point, ElementsAre(0, 2, 3, 5, 6)) << "an open path comes back there";
}

TEST(NearestPath, KeepsTheStricterOfEqualPoints) {
  PathTask task = through({{2, 0}, {2, 0}, {1, 2}, {-1, 2}, {2, 0}});
  task.closed = true;
  for (PathPoint& point : task.points) point.weight = 0;
  task.points[1].weight = 3;
  task.points[4].tolerance = 0.5;
  const NearestTarget near = nearest_target(task);
  EXPECT_THAT(near.target.weights, ElementsAre(3, 0, 0)) << "a target all without weight could not be fitted";
  EXPECT_EQ(near.tolerance[0], 0.5);
}

TEST(NearestPath, HasAWeightWhateverTheTolerances) {
  PathTask task = hexagon();
  for (PathPoint& point : task.points) point.weight = 0;
  task.points[0].weight = 1;
  task.points[0].tolerance = 1e9;
  task.points[1].tolerance = 1e-300;
  EXPECT_EQ(nearest_target(task).target.weights[0], 1);
}

TEST(NearestPath, WeighsByTolerances) {
  PathTask task = hexagon();
  task.tolerance = 4;
  task.points[1].tolerance = 1;
  task.points[2].weight = 3;
  const NearestTarget near = nearest_target(task);
  EXPECT_THAT(near.target.weights, ElementsAre(1. / 16, 1, 3. / 16, 1. / 16, 1. / 16, 1. / 16));
  EXPECT_THAT(near.tolerance, ElementsAre(4, 1, 4, 4, 4, 4));
}

TEST(NearestPath, PutsMiddlesBetweenThePointsOfAPolyline) {
  PathTask task = through({{0, 0}, {4, 0}, {4, 2}});
  task.between = PathBetween::polyline;
  NearestTarget near = nearest_target(task);
  EXPECT_THAT(near.target.points, ElementsAre(Point{0, 0}, Point{2, 0}, Point{4, 0}, Point{4, 1}, Point{4, 2}));
  EXPECT_THAT(near.target.weights, ElementsAre(1, 0.25, 1, 0.25, 1));
  EXPECT_EQ(near.point[1], NearestTarget::between);
  task.closed = true;
  near = nearest_target(task);
  EXPECT_EQ(near.target.points.size(), 6u);
  EXPECT_EQ(near.target.points.back(), (Point{2, 1}));
}

}  // namespace
}  // namespace linkwright::nearest_path_test
