#include "linkwright/files/instant_file.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "linkwright/files/analysis_file.hpp"
#include "linkwright/files/problem_file.hpp"

namespace linkwright::instant_file_test {
namespace {

using nlohmann::json;

json instant_of(const FourBar& bars, const InstantQuestion& question = {}) {
  StoredLinkage linkage;
  linkage.four_bar = bars;
  LinkageAnalysis analysis = analyze(linkage);
  analysis.instant = LinkageInstant{bars, analyze_instant(bars, question)};
  return json::parse(write_analysis(analysis));
}

TEST(InstantFile, StandsBesideTheAnalysisOnlyWhereItIsAskedFor) {
  const FourBar bars{{0, 0}, {1, 1.2}, {4, 0.3}, {3.5, 3}};
  const json file = instant_of(bars, {.point = Point{2, 4}, .input_acceleration = 0});
  EXPECT_NEAR(file["configuration"]["input_angle_deg"].get<double>(), 45.9053, 1e-4);
  const json& instant = file["instant"];
  EXPECT_EQ(instant["kind"], "turning");
  EXPECT_EQ(instant["burmester_points"].size(), 2U);
  EXPECT_EQ(instant["point"]["contact_points"], 2);
  const auto radius = instant["inflection_circle"]["radius"].get<double>();
  EXPECT_DOUBLE_EQ(2 * radius, instant["inflection_diameter"].get<double>());
  StoredLinkage linkage;
  linkage.four_bar = bars;
  EXPECT_FALSE(json::parse(write_analysis(analyze(linkage))).contains("instant"));
}

TEST(InstantFile, TellsOfTranslationsByLines) {
  const json instant = instant_of({{0, 0}, {0, 1}, {3, 4}, {3, 1.5}})["instant"];
  EXPECT_EQ(instant["kind"], "translating");
  EXPECT_TRUE(instant["pole"].is_null() && instant["inflection_diameter"].is_null() && instant["ball_point"].is_null());
  EXPECT_NEAR(instant["inflection_circle"]["line"]["point"][0].get<double>(), 3 / 1.4, 1e-14);
  EXPECT_NEAR(std::abs(instant["inflection_circle"]["line"]["direction_deg"].get<double>()), 90, 1e-12);
  EXPECT_TRUE(instant["cubic"]["hyperbola"]["product"].is_number());
  EXPECT_EQ(instant["notes"][0]["code"], "parallel_side_links");
}

TEST(InstantFile, SaysWhyThereIsNone) {
  const json instant = instant_of({{0, 0}, {1, 0}, {4, 0}, {3, 0}})["instant"];
  EXPECT_EQ(instant.size(), 1U);
  EXPECT_NE(instant["degenerate"].get<std::string>().find("one line"), std::string::npos);
}

constexpr auto wheel =
    R"({"linkwright": 1, "title": "Wheel on a rail", "task": {"kind": "motion", "mechanism": "four_bar",
  "poses": [{"x": 0, "y": 1, "theta_deg": 0, "derivatives": [{"x": -1, "y": 0, "theta": 1}, {"x": 0, "y": 0, "theta": 0},
  {"x": 0, "y": 0, "theta": 0}]}]}})";

TEST(InstantFile, IsThatOfAPrescribedMotion) {
  const auto problem = read_problem(wheel);
  ASSERT_TRUE(problem.ok());
  const auto instant = prescribed_instant(*problem, Point{0, 2});
  ASSERT_TRUE(instant.ok());
  const json file = json::parse(write_instant(*instant));
  EXPECT_EQ(file["title"], "Wheel on a rail");
  EXPECT_EQ(file["instant"]["inflection_diameter"], 1);
  EXPECT_TRUE(file["instant"]["invariants"]["a4"].is_null());
  EXPECT_NEAR(file["instant"]["point"]["radius_of_curvature"].get<double>(), 4, 1e-14);  // of a cycloid at its top
  EXPECT_EQ(file["pose"]["derivatives"].size(), 3U);
}

TEST(InstantFile, RefusesOtherProblems) {
  const auto problem = read_problem_file(std::filesystem::path(LINKWRIGHT_EXAMPLES_DIR) / "tailgate.json");
  ASSERT_TRUE(problem.ok());
  const auto instant = prescribed_instant(*problem, std::nullopt);
  ASSERT_FALSE(instant.ok());
  EXPECT_EQ(instant.errors().front().code, "no_prescribed_instant");
}

}  // namespace
}  // namespace linkwright::instant_file_test
