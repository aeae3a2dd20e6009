#include "linkwright/planar/path_task.hpp"

#include <gtest/gtest.h>
#include <limits>

#include "linkwright/core/angle.hpp"
#include "support/path_case.hpp"

namespace linkwright::path_task_test {
namespace {

using testing::timed_points;

std::string codes(const PathTask& task) {
  std::string text;
  for (const Error& e : mistakes_in(task)) text += (text.empty() ? "" : " ") + e.code + "@" + e.place.substr(5);
  return text;
}

PathTask claw() { return timed_points({{0, 9.5, 0}, {0.1, 3.2, 35}, {0.1, -3.3, 70}, {0, -9.5, 105}}); }

TEST(PathTask, TakesFourAndFivePositionsOfAnyPattern) {
  EXPECT_EQ(codes(claw()), "");
  PathTask task = claw();
  task.points[2].derivatives = {{{0, -1}, {}, {}}};
  EXPECT_EQ(codes(task), "");
  task.points[0].derivatives = {{{0, -1}, 1.0, {}}};
  EXPECT_EQ(codes(task), "too_many_path_positions@points");
  task = claw();
  task.points.pop_back();
  EXPECT_EQ(codes(task), "too_few_path_points@points");
  task.points[1].derivatives = {{{0, -1}, {}, {}}};
  EXPECT_EQ(codes(task), "");
  task.points.pop_back();
  EXPECT_EQ(codes(task), "too_few_path_positions@points");
  EXPECT_EQ(codes(PathTask{}), "too_few_path_points@points");
}

TEST(PathTask, TakesAnglesAtSomePoints) {
  PathTask task = claw();
  task.points.push_back({{3, 2}, {}, {}, {}});
  EXPECT_EQ(codes(task), "");
  EXPECT_EQ(task.timing(), PathTiming::some);
  EXPECT_EQ(task.form(), PathForm::curve_of_arms);
  task.points[1].input.reset();
  EXPECT_EQ(codes(task), "");
  EXPECT_EQ(task.form(), PathForm::ground_pivot);
  task.pivots.input = Point{40, 0};
  EXPECT_EQ(codes(task), "pivots_and_angles@given");
  task = claw();
  task.points[2].input.reset();
  EXPECT_EQ(codes(task), "mixed_path_count@points");
  task.points[2].derivatives = {{{0, 1}, {}, {}}};
  EXPECT_EQ(codes(task), "") << "two plain positions at one place";
}

PathTask posed() {
  PathTask task;
  for (const double x : {0.0, 100.0, 250.0}) task.points.push_back({{x, 10 + x * x / 900}, {}, -x / 200, {}});
  return task;
}

TEST(PathTask, TakesAnglesOfTheCouplerAtSomePoints) {
  PathTask task = posed();
  EXPECT_EQ(codes(task), "path_of_poses@points");
  for (const Point p : {Point{60, 150}, Point{260, 160}}) task.points.push_back({p, {}, {}, {}});
  EXPECT_EQ(codes(task), "");
  EXPECT_EQ(task.timing(), PathTiming::none);
  EXPECT_EQ(task.form(), PathForm::ground_pivot);
  task.points[4].input = 0.5;
  EXPECT_EQ(codes(task), "path_angles_of_both_links@points[4]");
  task.points[4].angle = 0.5;
  EXPECT_EQ(codes(task), "path_point_with_both_angles@points[4]");
  task.points[4].input.reset();
  EXPECT_EQ(codes(task), "") << "four and one";
  task.points[4] = task.points[1];
  EXPECT_EQ(codes(task), "repeated_path_pose@points[4]");
  task = posed();
  task.points.push_back({{60, 150}, {}, {}, {}});
  task.points[0].derivatives = {{{1, 2}, {}, {}}};
  EXPECT_EQ(codes(task), "coupler_rate_missing@points[0].derivatives[0]");
  task.points[0].derivatives[0].angle = 0.1;
  EXPECT_EQ(codes(task), "");
  task.points[3].derivatives = {{{1, 2}, {}, 0.1}};
  EXPECT_EQ(codes(task), "rate_without_coupler_angle@points[3].derivatives[0].theta");
}

TEST(PathTask, TakesThreeTimedPointsWithPivots) {
  PathTask task = claw();
  task.pivots.input = Point{40, 0};
  EXPECT_EQ(codes(task), "timed_count_for_pivots@points");
  task.points.pop_back();
  EXPECT_EQ(codes(task), "");
  EXPECT_EQ(task.form(), PathForm::other_pivot);
  task.pivots.output = Point{40, 60};
  EXPECT_EQ(codes(task), "");
  EXPECT_EQ(task.form(), PathForm::few);
}

PathTask mixer() {
  PathTask task;
  for (const Point p : {Point{0, 0}, Point{95, 40}, Point{150, 140}, Point{60, 230}, Point{-70, 190}})
    task.points.push_back({p, {}, {}, {}});
  task.pivots.input = Point{40, 90};
  return task;
}

TEST(PathTask, TakesPointsAloneWithGroundPivots) {
  PathTask task = mixer();
  EXPECT_EQ(codes(task), "");
  task.pivots = {std::nullopt, Point{40, 90}};
  EXPECT_EQ(codes(task), "");
  task.pivots.input = Point{0, 50};
  EXPECT_EQ(codes(task), "") << "five and both";
  EXPECT_EQ(task.form(), PathForm::few);
  task.pivots.input.reset();
  task.points.pop_back();
  EXPECT_EQ(codes(task), "too_few_points_for_pivot@points");
  task.points[2].derivatives = {{{0, 1}, {}, {}}};
  EXPECT_EQ(codes(task), "");
  task.pivots.input = Point{0, 50};
  EXPECT_EQ(codes(task), "derivatives_between_pivots@points[2].derivatives");
  task.points.resize(3);
  EXPECT_EQ(codes(task), "four_points_for_pivots@points");
  task.points[2].derivatives.clear();
  EXPECT_EQ(codes(task), "");
}

TEST(PathTask, RefusesPointsAloneThatMakeNoSense) {
  PathTask task = mixer();
  task.pivots = {};
  EXPECT_EQ(codes(task), "path_leaves_too_much@points");
  task.box = Box{-100, 200, -50, 300};
  EXPECT_EQ(codes(task), "");
  EXPECT_TRUE(task.seeks_pivot());
  task.box->y_low = 400;
  EXPECT_EQ(codes(task), "empty_box@ns.box");
  task.points.resize(4);
  task.box->y_low = 0;
  EXPECT_EQ(codes(task), "too_few_points_for_pivot@points");
  task = mixer();
  task.box = Box{-100, 200, -50, 300};
  EXPECT_EQ(codes(task), "box_of_path@ns.box") << "its pivot is given";
  task = claw();
  task.box = Box{-100, 200, -50, 300};
  EXPECT_EQ(codes(task), "box_of_path@ns.box");
  task = mixer();
  task.pivots.input = task.points[3].point;
  EXPECT_EQ(codes(task), "point_at_pivot@points[3]");
  task = mixer();
  task.pivots.input = Point{std::numeric_limits<double>::infinity(), 0};
  EXPECT_EQ(codes(task), "number_range@given.ground_pivots.input[0]");
  task = mixer();
  task.points.resize(3);
  task.pivots.output = task.pivots.input;
  EXPECT_EQ(codes(task), "pivots_at_one_place@given.ground_pivots");
  task = mixer();
  task.points.pop_back();
  task.points[1].derivatives = {{{1, 2}, 0.5, {}}};
  EXPECT_EQ(codes(task), "rate_without_angle@points[1].derivatives[0].input");
  task.points[1].derivatives = {{{0, 0}, {}, {}}};
  EXPECT_EQ(codes(task), "point_at_rest@points[1].derivatives[0]");
  task = mixer();
  task.points[2].point = task.points[1].point;
  EXPECT_EQ(codes(task), "path_point_again_at_once@points[2]");
  task = mixer();
  task.points[2].point = task.points[4].point = task.points[0].point;
  EXPECT_EQ(codes(task), "path_point_three_times@points[0]");
  task = mixer();
  task.points[2].point = task.points[0].point;
  EXPECT_EQ(codes(task), "");
  task.pivots.output = Point{300, 0};
  EXPECT_EQ(codes(task), "repeated_point_between_pivots@points[2]");
}

TEST(PathTask, TakesNumbersOnly) {
  PathTask task = claw();
  task.points[1].point = {0, std::numeric_limits<double>::infinity()};
  task.points[3].input = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(codes(task), "number_range@points[1].y number_range@points[3].input_deg");
  task = claw();
  task.points.pop_back();
  task.points[0].derivatives = {{{1e12, 0}, std::numeric_limits<double>::infinity()}};
  EXPECT_EQ(codes(task), "number_range@points[0].derivatives[0].x number_range@points[0].derivatives[0].input");
}

// The tasks that are refused say the sentences that the case file expects.
TEST(PathTask, RefusesWhatACrankCannotDo) {
  const auto items = testing::path_case("nasty_timed").json.at("items");
  int refused = 0;
  for (const auto& item : items) {
    const auto mistakes = mistakes_in(testing::path_task(item.at("task")));
    const std::string name = item.at("name");
    if (name == "reversing_crank") {
      ASSERT_EQ(mistakes.size(), 1u);
      EXPECT_EQ(mistakes[0].code, "crank_reverses");
      EXPECT_EQ(mistakes[0].place, "task.points[2].input_deg");
      continue;
    }
    EXPECT_EQ(mistakes.size(), item.at("expect").contains("refused") ? 1u : 0u) << name;
    refused += static_cast<int>(mistakes.size());
  }
  EXPECT_EQ(refused, 4);
}

std::string message(const PathTask& task) {
  const auto found = mistakes_in(task);
  return found.empty() ? "" : found.front().message;
}

TEST(PathTask, NamesThePointsByTheirNumbers) {
  const auto starts = [](const PathTask& task, const std::string& text) {
    EXPECT_EQ(message(task).substr(0, text.size()), text);
  };
  starts(timed_points({{0, 0, 0}, {10, 4, 40}, {13, -5, 40}, {2, 8, 40}}),
         "points 2, 3 and 4 have the same crank angle;");
  starts(timed_points({{0, 0, 0}, {10, 4, 40}, {13, -5, 190}, {2, 8, 360}}),
         "points 1 and 4 have the same crank angle, modulo 360;");
  starts(timed_points({{0, 0, 0}, {10, 4, 40}, {13, -5, 190}, {0, 0, 360}}),
         "point 4 is point 1 again after a full turn of the crank; leave it out");
  starts(timed_points({{0, 0, 0}, {10, 4, 150}, {13, -5, 300}, {2, 8, 450}}),
         "the crank passes point 4 (90° from point 1, modulo 360) before point 2;");
  starts(timed_points({{0, 0, 0}, {0, 0, 0}, {13, -5, 300}, {2, 8, 350}}),
         "points 1 and 2 are the same at the same angle of the crank;");
  EXPECT_EQ(message(timed_points({{0, 0, 0}, {10, 4, -150}, {13, -5, -300}, {2, 8, -359}})), "") << "clockwise";
  EXPECT_EQ(message(timed_points({{0, 0, 0}, {10, 4, 40}, {10, 4, 90}, {2, 8, 150}})), "") << "a dwell";
}

TEST(PathTask, TheCrankMovesOnAtADerivative) {
  PathTask task = claw();
  task.points.pop_back();
  task.points[1].derivatives = {{{0, -1}, 0.0, {}}};
  EXPECT_EQ(codes(task), "crank_at_rest@points[1].derivatives[0].input");
  task.points[1].derivatives = {{{0, 1}, -1.0, {}}};
  EXPECT_EQ(codes(task), "crank_against_sense@points[1].derivatives[0].input");
  for (PathPoint& point : task.points) *point.input *= -1;
  EXPECT_EQ(codes(task), "");
  EXPECT_EQ(crank_sense(task), -1);
}

TEST(PathTask, CrankPosesTurnWithTheCrankAndAreCarriedByThePoint) {
  PathTask task = timed_points({{3, 4, 20}, {5, 6, -30}, {7, 9, -80}});
  task.points[1].derivatives = {{{1, 2}, {}, {}}};
  task.points[2].derivatives = {{{2, 3}, -2.0, {}}};
  const auto poses = angled_poses(task);
  ASSERT_EQ(poses.size(), 3u);
  EXPECT_EQ(pattern(poses), "P-PP-PP");
  EXPECT_EQ(poses[0].pose.origin, (Point{3, 4}));
  EXPECT_EQ(poses[0].pose.angle, 0);
  EXPECT_NEAR(degrees(poses[1].pose.angle), -50, 1e-12);
  EXPECT_NEAR(degrees(poses[2].pose.angle), -100, 1e-12);
  EXPECT_EQ(poses[1].derivatives[0], (PoseDerivative{{1, 2}, -1})) << "one radian on, clockwise as the task";
  EXPECT_EQ(poses[2].derivatives[0], (PoseDerivative{{2, 3}, -2}));
}

TEST(PathTask, HigherDerivativesOfTheCrankAreNothingByItsOwnTurn) {
  PathTask task;
  task.points = {{{0, 0}, 0.0, {}, {{{1, 0}, {}, {}}, {{0, 1}, {}, {}}, {{0, 0}, {}, {}}}}};
  EXPECT_EQ(codes(task), "");
  const auto poses = angled_poses(task);
  EXPECT_EQ(poses[0].derivatives[0].angle, 1);
  EXPECT_EQ(poses[0].derivatives[1].angle, 0);
  EXPECT_EQ(poses[0].derivatives[2].angle, 0);
}

}  // namespace
}  // namespace linkwright::path_task_test
