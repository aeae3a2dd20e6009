#include "files/listed_problem.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "linkwright/core/angle.hpp"
#include "linkwright/files/result_file.hpp"
#include "linkwright/synthesis/solve.hpp"
#include "support/file_support.hpp"

namespace linkwright::listed_problem_test {
namespace {

using nlohmann::json;

class EachKindOfResult : public ::testing::TestWithParam<const char*> {};

TEST_P(EachKindOfResult, IsAskedAgainAtThePlaceOfALinkage) {
  Problem problem = testing::example(std::string(GetParam()) + ".json", 160);
  problem.options.effort = 4000;
  problem.options.best = 3;
  const auto answer = solve(problem);
  const std::string result = write_result(problem, *answer, false);
  const json listed = json::parse(result)["linkages"];
  ASSERT_FALSE(listed.empty());
  for (std::size_t i = 0; i < listed.size(); ++i) {
    const auto asked = read_listed_problem(result, static_cast<int>(i) + 1);
    ASSERT_TRUE(asked.ok()) << asked.errors().front().message;
    const Problem& again = asked->problem;
    const auto found = solve(again);
    ASSERT_TRUE(found.ok()) << found.errors().front().message;
    json same;
    const json there_is = json::parse(write_result(again, *found, false));
    for (const json& there : there_is["linkages"])
      if (!there.contains("layer") || there["layer"] == asked->layer) same = there;
    ASSERT_FALSE(same.is_null());
    EXPECT_EQ(same["type"], listed[i]["type"]);
    // A search lays the stroke where the strip runs, a map half of it either way of the point: what is judged over it
    // differs.
    const auto angle = [](const json& linkage) {
      return linkage["min_transmission_angle_deg"].is_number() ? linkage["min_transmission_angle_deg"].get<double>()
                                                               : 0;
    };
    if (!listed[i].contains("task")) {
      EXPECT_NEAR(angle(same), angle(listed[i]), 1e-6);
    }
    const char* lengths = listed[i].contains("lengths") ? "lengths" : "angles_deg";
    for (const auto& [name, length] : listed[i][lengths].items())
      EXPECT_NEAR(same[lengths][name].get<double>(), length.get<double>(), 1e-9 * length.get<double>()) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(Examples, EachKindOfResult,
                         ::testing::Values("tailgate", "latch", "nose_gear", "hood_hinge", "sine_generator",
                                           "flow_meter", "folding_wing", "universal_joint_like", "loader_bucket",
                                           "loader_bucket_chain", "straight_luffing_crane", "straight_stage",
                                           "straight_search", "film_claw", "dough_mixer", "windscreen_wiper",
                                           "thread_take_up", "walking_leg_path", "packaging_feeder",
                                           "garage_door_point"));

TEST(ListedProblem, KeepsAPivotThatWasSearchedFor) {
  Problem problem = testing::example("dough_mixer.json", 60);
  std::get<PathTask>(problem.task).pivots = {};
  std::get<PathTask>(problem.task).box = problem.options.box = Box{-100, 200, -50, 300};
  problem.options.effort = 2000;
  const auto answer = solve(problem);
  ASSERT_TRUE(answer.ok());
  const std::string result = write_result(problem, *answer, false);
  const json first = json::parse(result)["linkages"].at(0);
  const auto asked = read_listed_problem(result, 1);
  ASSERT_TRUE(asked.ok()) << asked.errors().front().message;
  EXPECT_FALSE(asked->problem.options.box);
  const auto again = solve(asked->problem);
  ASSERT_TRUE(again.ok()) << again.errors().front().message;
  EXPECT_EQ(json::parse(write_result(asked->problem, *again, false))["linkages"].at(0)["lengths"], first["lengths"]);
}

TEST(ListedProblem, RefusesWhatIsNoResultAndNumbersBeyond) {
  const testing::Solved& sine = testing::function();
  const std::string result = write_result(sine.problem, sine.answer, false);
  EXPECT_EQ(read_listed_problem(result, 0).errors().front().place, "--linkage");
  EXPECT_EQ(read_listed_problem(result, 1000).errors().front().code, "no_such_linkage");
  for (const char* text :
       {"", "[]", "{}", R"({"problem": 3, "linkages": []})", R"({"problem": {"task": 1}, "linkages": {}})",
        R"({"linkwright": 1, "task": {}})", R"({"problem": {"task": {}, "options": 5}, "linkages": [{}]})",
        R"({"problem": {"task": {}, "options": [1]}, "linkages": [{}]})",
        R"({"problem": {"task": "x", "options": {}}, "linkages": [{}]})"})
    EXPECT_FALSE(read_listed_problem(text, 1).ok()) << text;
  json bare = json::parse(result);
  bare["linkages"][0] = {{"lengths", {{"ground", 1}, {"input", 1}, {"coupler", 1}, {"output", 1}}}};
  EXPECT_EQ(read_listed_problem(bare.dump(), 1).errors().front().code, "no_place");
  bare["linkages"][0] = 7;
  EXPECT_EQ(read_listed_problem(bare.dump(), 1).errors().front().code, "no_place");
}

}  // namespace
}  // namespace linkwright::listed_problem_test
