#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "linkwright/analyses/tolerance_study.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/files/problem_file.hpp"
#include "linkwright/files/result_file.hpp"
#include "linkwright/synthesis/solve.hpp"
#include "support/file_support.hpp"

namespace linkwright::tolerance_file_test {
namespace {

using nlohmann::json;

Problem tailgate_with(const std::string& tolerances) {
  json file = json::parse(write_problem(testing::example("tailgate.json", 80)));
  file["tolerances"] = json::parse(tolerances);
  file["options"]["best"] = 2;
  const auto read = read_problem(file.dump());
  EXPECT_TRUE(read.ok()) << (read.ok() ? "" : read.errors().front().message);
  return read.value();
}

TEST(ToleranceFile, ReadsWhatItWrites) {
  for (const char* text :
       {R"({"length": 0.5})", R"({"length": 0.5, "clearance": 0.05, "driver_deg": 0.1, "limit": {"position": 2}})",
        R"({"length": {"input": 0.1, "coupler": 0.2, "output": 0.3, "ground_pivots": 0.4, "point": 0.5},
            "distribution": "uniform", "turning_length": 123, "limit": {"angle_deg": 0.3}, "cost": {"exponent": 2},
            "samples": 5000, "seed": 7})",
        R"({"clearance": 0.05, "distribution": "truncated_normal", "limit": null, "cost": null})"}) {
    const Problem problem = tailgate_with(text);
    const auto again = read_problem(write_problem(problem));
    ASSERT_TRUE(again.ok()) << text;
    EXPECT_EQ(again->options.tolerances, problem.options.tolerances) << text;
  }
}

TEST(ToleranceFile, HasTheMembersOfTheContract) {
  const Problem problem = tailgate_with(R"({"length": 0.5, "limit": {"position": 2}, "cost": {"exponent": 1}})");
  const auto answer = solve(problem);
  const json result = json::parse(write_result(problem, *answer, true));
  EXPECT_TRUE(result["region"]["properties"].contains("tolerance_error"));
  EXPECT_EQ(result["problem"]["tolerances"]["turning_length"], result["characteristic_length"]) << "as used";
  for (const json& linkage : result["linkages"]) {
    const json& told = linkage["tolerance"];
    EXPECT_EQ(told["unit"], "length");
    EXPECT_EQ(told["samples"], 100'000);
    EXPECT_NEAR(told["error_sampled"].get<double>(), told["error"].get<double>(), 0.01 * told["error"].get<double>());
    EXPECT_LE(told["yield_interval"][0], told["yield"]);
    EXPECT_GE(told["yield_interval"][1], told["yield"]);
    double shares = 0;
    for (const json& share : told["sensitivities"]) shares += share["share"].get<double>();
    EXPECT_NEAR(shares, 1, 1e-12);
    EXPECT_EQ(told["allocation"].size(), told["sensitivities"].size());
  }
}

TEST(ToleranceFile, AStudyIsWhatTheResultSays) {
  const Problem problem = tailgate_with(R"({"length": 0.5, "seed": 5})");
  const auto answer = solve(problem);
  const json result = json::parse(write_result(problem, *answer, false));
  const json study = json::parse(write_tolerance_study(tolerance_study(problem, *answer, 1)));
  EXPECT_EQ(study["tolerance"], result["linkages"][1]["tolerance"]);
  EXPECT_EQ(study["tolerances"]["seed"], 5);
}

struct Bad {
  const char *tolerances, *place;
};
class BadTolerances : public ::testing::TestWithParam<Bad> {};

TEST_P(BadTolerances, AreToldWithTheirPlace) {
  json file = json::parse(write_problem(testing::example("tailgate.json", 80)));
  file["tolerances"] = json::parse(GetParam().tolerances);
  const auto read = read_problem(file.dump());
  ASSERT_FALSE(read.ok()) << GetParam().tolerances;
  EXPECT_EQ(read.errors().front().place, GetParam().place) << read.errors().front().message;
}

INSTANTIATE_TEST_SUITE_P(
    Files, BadTolerances,
    ::testing::Values(Bad{R"({})", "tolerances"}, Bad{R"(3)", "tolerances"},
                      Bad{R"({"length": -1})", "tolerances.length"}, Bad{R"({"length": "0.1"})", "tolerances.length"},
                      Bad{R"({"length": {"inputs": 1}})", "tolerances.length.inputs"},
                      Bad{R"({"length": {"input": -1}})", "tolerances.length.input"},
                      Bad{R"({"length": 0.1, "lenght": 1})", "tolerances.lenght"},
                      Bad{R"({"length": 0.1, "limit": {}})", "tolerances.limit"},
                      Bad{R"({"length": 0.1, "limit": {"position": 1, "angle_deg": 1}})", "tolerances.limit"},
                      Bad{R"({"length": 0.1, "limit": {"position": 0}})", "tolerances.limit.position"},
                      Bad{R"({"length": 0.1, "limit": {"deviation": 1}})", "tolerances.limit"},
                      Bad{R"({"length": 0.1, "samples": 10})", "tolerances.samples"},
                      Bad{R"({"length": 0.1, "seed": -1})", "tolerances.seed"},
                      Bad{R"({"length": 0.1, "cost": {"exponent": 0}})", "tolerances.cost.exponent"},
                      Bad{R"({"length": 0.1, "distribution": "gauss"})", "tolerances.distribution"},
                      Bad{R"({"link_angle_deg": 0.1})", "tolerances.link_angle_deg"}));

struct BadWish {
  const char *requirements, *options, *tolerances, *place;
};
class BadWishes : public ::testing::TestWithParam<BadWish> {};

TEST_P(BadWishes, NeedWhatTheyAreAbout) {
  json file = json::parse(write_problem(testing::example("tailgate.json", 80)));
  file["requirements"].update(json::parse(GetParam().requirements));
  file["options"].update(json::parse(GetParam().options));
  if (*GetParam().tolerances != '\0') file["tolerances"] = json::parse(GetParam().tolerances);
  const auto read = read_problem(file.dump());
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(read.errors().front().place, GetParam().place) << read.errors().front().message;
}

INSTANTIATE_TEST_SUITE_P(
    Files, BadWishes,
    ::testing::Values(BadWish{R"({"max_tolerance_error": 1})", "{}", "", "requirements.max_tolerance_error"},
                      BadWish{R"({"min_yield": 0.9})", "{}", R"({"length": 1})", "requirements.min_yield"},
                      BadWish{R"({"min_yield": 90})", "{}", R"({"length": 1, "limit": {"position": 1}})",
                              "requirements.min_yield"},
                      BadWish{"{}", R"({"objective": "yield"})", R"({"length": 1})", "options.objective"},
                      BadWish{"{}", R"({"objective": "tolerance_error"})", "", "options.objective"},
                      BadWish{"{}", R"({"pareto": ["size", "tolerance_error"]})", "", "options.pareto"},
                      BadWish{"{}", R"({"pareto": ["size"]})", "", "options.pareto"},
                      BadWish{"{}", R"({"pareto": ["size", "stroke"]})", "", "options.pareto"},
                      BadWish{"{}", R"({"pareto": ["size", "size"]})", "", "options.pareto"}));

}  // namespace
}  // namespace linkwright::tolerance_file_test
