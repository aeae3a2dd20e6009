#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <random>
#include <string>

#include "files/problem_writer.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/files/problem_file.hpp"
#include "linkwright/files/result_file.hpp"
#include "linkwright/files/task_label.hpp"
#include "linkwright/synthesis/solve.hpp"
#include "support/draws.hpp"
#include "support/path_case.hpp"
#include "support/random_task.hpp"

namespace linkwright::path_problem_file_test {
namespace {

PathTask random_task(std::mt19937_64& random) {
  PathTask task;
  double angle = testing::uniform(random, -9, 9);
  for (int j = 0; j < 3; ++j) {
    task.points.push_back({{testing::uniform(random, -9, 9), testing::uniform(random, -9, 9)}, angle, {}});
    angle += testing::uniform(random, 0.2, 1.5);
  }
  task.points[1].derivatives = {{{testing::uniform(random, -9, 9), 1}, testing::uniform(random, 0.1, 9)}};
  task.points[2].derivatives = {{{3, testing::uniform(random, -9, 9)}, std::nullopt}};
  return task;
}

TEST(PathProblemFile, ComesBackBitIdentical) {
  std::mt19937_64 random(7);
  for (int trial = 0; trial < testing::draws(60); ++trial) {
    Problem problem;
    problem.task = random_task(random);
    problem.requirements.full_turn = trial % 2 == 0;
    const std::string text = write_problem(problem);
    const auto again = read_problem(text);
    ASSERT_TRUE(again.ok()) << again.errors().front().message;
    EXPECT_EQ(write_problem(*again), text);
    EXPECT_EQ(again->requirements.full_turn, problem.requirements.full_turn);
    const auto &one = std::get<PathTask>(problem.task).points, &other = std::get<PathTask>(again->task).points;
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
      EXPECT_EQ(one[i].point, other[i].point);
      EXPECT_EQ(one[i].derivatives, other[i].derivatives);
      EXPECT_NEAR(*one[i].input, *other[i].input, 1e-14);
    }
  }
}

// Points alone, with one ground pivot or both.
TEST(PathProblemFile, PivotsComeBack) {
  std::mt19937_64 random(8);
  const auto place = [&] { return Point{testing::uniform(random, -9, 9), testing::uniform(random, -9, 9)}; };
  for (int trial = 0; trial < testing::draws(60); ++trial) {
    PathTask task;
    const int way = trial % 3, points = way == 2 ? 3 : 5;
    for (int j = 0; j < points; ++j) task.points.push_back({place(), std::nullopt, {}});
    if (way != 1) task.pivots.input = place();
    if (way != 0) task.pivots.output = place();
    Problem problem;
    problem.task = task;
    const auto again = read_problem(write_problem(problem));
    ASSERT_TRUE(again.ok()) << again.errors().front().message;
    EXPECT_EQ(std::get<PathTask>(again->task), task);
  }
}

TEST(PathProblemFile, IsSpokenOf) {
  const Task task = testing::path_case("thread_takeup_timed_mixed").task;
  EXPECT_EQ(task_label(task), "path through four positions at given crank angles (PP-P-P)");
  EXPECT_EQ(short_task_label(task), "path through four positions");
  const Task mixer = testing::path_case("dough_mixer_five_points").task;
  EXPECT_EQ(task_label(mixer),
            "path through five positions with given ground pivot of the input link (40, 90) "
            "(P-P-P-P-P)");
  const Task wiper = testing::path_case("wiper_pivots_three_points").task;
  EXPECT_EQ(task_label(wiper),
            "path through three positions with given ground pivots (150, -200) and (330, -160) "
            "(P-P-P)");
}

nlohmann::json result_of(const std::string& name, int samples) {
  Problem problem;
  problem.task = testing::path_case(name).task;
  problem.options.region_samples = samples;
  const auto answer = solve(problem);
  EXPECT_TRUE(answer.ok());
  return nlohmann::json::parse(write_result(problem, *answer, false));
}

TEST(PathProblemFile, AResultTellsThePath) {
  const auto result = result_of("film_claw_timed", 40);
  EXPECT_EQ(result.at("timing"), "all");
  EXPECT_FALSE(result.contains("cranks"));
  EXPECT_EQ(result.at("region").at("axes")[0].at("quantity"), "crank_coordinate");
  EXPECT_EQ(result.at("region").at("axes")[1].at("quantity"), "cognate_coordinate");
  EXPECT_EQ(result.at("curve").at("kind"), "two_branches");
  ASSERT_FALSE(result.at("linkages").empty());
  const auto& first = result.at("linkages")[0];
  EXPECT_EQ(first.at("point"), (nlohmann::json{0.0, 9.5}));
  EXPECT_EQ(first.at("input_deg_at_points").size(), 4u);
  EXPECT_NEAR(first.at("input_deg_at_points")[3].get<double>(), 105, 1e-12);
  EXPECT_EQ(first.at("theta_deg_at_points")[0], 0.0);
  EXPECT_EQ(first.at("poses").size(), 4u);
  EXPECT_EQ(first.at("poses")[2].at("theta_deg"), first.at("theta_deg_at_points")[2]);
  EXPECT_TRUE(first.at("full_turn").is_boolean());
  EXPECT_TRUE(first.contains("circuit_order"));
  EXPECT_LT(first.at("position_error").get<double>(), 1e-9);
  EXPECT_LT(first.at("timing_error_deg").get<double>(), 1e-9);
  const auto& cognate = first.at("cognate");
  const auto length = [](const nlohmann::json& link) {
    const auto &c = link.at("center_point"), &m = link.at("circle_point");
    return std::hypot(c[0].get<double>() - m[0].get<double>(), c[1].get<double>() - m[1].get<double>());
  };
  EXPECT_NEAR(length(cognate.at("input")) / length(first.at("input")), cognate.at("size_ratio").get<double>(), 1e-9);
  const auto& lengths = first.at("lengths");
  EXPECT_NEAR(std::hypot(first.at("input").at("circle_point")[0].get<double>(),
                         first.at("input").at("circle_point")[1].get<double>() - 9.5),
              lengths.at("point_to_input").get<double>(), 1e-9);
}

TEST(PathProblemFile, AResultOfFivePositionsListsTheCranks) {
  const auto result = result_of("stirrer_timed_five", 40);
  EXPECT_TRUE(result.at("curve").is_null());
  EXPECT_EQ(result.at("dyads").size(), 4u);
  EXPECT_EQ(result.at("pairs").size(), 12u);
  ASSERT_EQ(result.at("cranks").size(), 4u);
  const auto wanted = testing::path_case("stirrer_timed_five").json.at("cranks");
  int found = 0;
  for (const auto& crank : result.at("cranks"))
    for (const auto& other : wanted)
      found += std::abs(crank.at("crank_length").get<double>() - other.at("crank_length").get<double>()) < 1e-9 &&
               std::abs(crank.at("point_arm").get<double>() - other.at("point_arm").get<double>()) < 1e-9;
  EXPECT_EQ(found, 4);
}

}  // namespace
}  // namespace linkwright::path_problem_file_test
