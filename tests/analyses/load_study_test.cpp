#include "linkwright/analyses/load_study.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <sstream>

#include "linkwright/core/angle.hpp"
#include "linkwright/files/problem_file.hpp"
#include "linkwright/files/result_file.hpp"
#include "support/file_support.hpp"
#include "support/load_cases.hpp"

namespace linkwright::load_study_test {
namespace {

const std::string& result_text() {
  static const std::string text = [] {
    const Problem problem = testing::example("tailgate_struts.json", 80);
    return write_result(problem, testing::answer_of(problem), false);
  }();
  return text;
}

std::string code_of(const Result<LoadStudy>& study) { return study ? "" : study.errors().front().code; }

TEST(LoadStudy, TellsALinkageOfAResult) {
  const LoadStudy study = listed_loads(result_text(), 1).value();
  EXPECT_EQ(study.title, "Tailgate with two struts, linkage 1");
  ASSERT_EQ(study.report.cases.size(), 4U);
  ASSERT_EQ(study.curves.size(), 4U);
  EXPECT_EQ(study.curves.front().size(), 3U * 24 + 1);
  EXPECT_EQ(study.report.cases[3].name, "cold, uphill, snow");
}

TEST(LoadStudy, TellsOneCaseAlone) {
  const LoadStudy study = listed_loads(result_text(), 1, {"hot"}).value();
  ASSERT_EQ(study.report.cases.size(), 1U);
  EXPECT_EQ(study.report.cases.front().name, "hot");
}

TEST(LoadStudy, SaysWhatIsMissing) {
  EXPECT_EQ(code_of(listed_loads(result_text(), 1, {"warm"})), "unknown_case");
  const Problem plain = testing::example("tailgate.json", 40);
  const std::string result = write_result(plain, testing::answer_of(plain), false);
  EXPECT_EQ(code_of(listed_loads(result, 1)), "no_loads_in_result");
}

// From two positions a crank gets to one another both ways round: the direction of travel says which.
TEST(LoadStudy, GoesTheWayThatTheDirectionOfTravelSays) {
  const Problem problem = testing::problem_from(R"({"linkwright": 1, "length_unit": "mm",
    "task": {"kind": "motion", "mechanism": "four_bar", "poses": [
      {"x": -4.42, "y": 5.85, "theta_deg": -174.8, "derivatives": [{"x": 19.6, "y": -22.2, "theta": 0.944},
                                                                   {"x": -18.4, "y": -2.6, "theta": 0.59}]},
      {"x": -6.65, "y": -6.83, "theta_deg": -78.77}]},
    "requirements": {"types": ["crank_rocker"]},
    "loads": {"body": {"mass": 2, "center": [1, 2]}, "handle": {"point": [3, 0]}},
    "options": {"region_samples": 80, "best": 20}})");
  const Answer answer = testing::answer_of(problem);
  const auto result = nlohmann::json::parse(write_result(problem, answer, false));
  int clockwise = 0;
  for (std::size_t k = 0; k < result["linkages"].size(); ++k) {
    const double sweep = result["linkages"][k]["driver_sweep_deg"];
    EXPECT_NEAR(degrees(load_study(problem, answer, k).curves.front().back().at.driver_turn), sweep, 1e-6) << k;
    clockwise += result["linkages"][k]["drive"] == "cw";
  }
  EXPECT_GT(clockwise, 0);
}

// A climb ends at the limit of pins by the stations of the map, and a thousandth beyond it by the largest force.
TEST(LoadStudy, FindsWhatKeepsALimitThatAClimbEndsBeyond) {
  const Problem problem = testing::problem_from(testing::load_file("pins_at_the_limit").dump());
  const Answer answer = testing::answer_of(problem);
  const Findings& found = findings(answer);
  EXPECT_EQ(found.status, SolutionStatus::solved) << found.reason.message;
  ASSERT_EQ(found.loads.size(), 1U);
  const double limit = problem.requirements.max_pin_force;
  const double force = found.loads.front()->worst_of(ReadOut::max_pin_force)->value;
  EXPECT_LE(force, limit);
  EXPECT_GT(force, 0.99 * limit);
}

// A case's name may have commas and quotes: it stands between quotes, and its row has as many columns as the head.
TEST(LoadStudy, WritesATable) {
  const std::string table = load_table(listed_loads(result_text(), 1).value());
  std::istringstream lines(table);
  std::string head, line;
  std::getline(lines, head);
  EXPECT_EQ(head.substr(0, 50), "case,driver_turn_deg,body_turn_deg,path,open_N,clo");
  const auto commas = [](const std::string& text) { return std::count(text.begin(), text.end(), ','); };
  std::size_t rows = 0;
  for (; std::getline(lines, line); ++rows) {
    const bool is_quoted = line.front() == '"';
    EXPECT_EQ(commas(line), commas(head) + (is_quoted ? 2 : 0)) << line;
  }
  EXPECT_EQ(rows, 4U * 73);
}

TEST(LoadStudy, IsDrawnWithEachCase) {
  const std::string drawn = draw_loads(listed_loads(result_text(), 1).value());
  for (const char* words : {"room", "cold, uphill, snow", "Force of the hand", "within their stroke", "loads"})
    EXPECT_NE(drawn.find(words), std::string::npos) << words;
  EXPECT_EQ(drawn.find("nan"), std::string::npos);
}

}  // namespace
}  // namespace linkwright::load_study_test
