#include "linkwright/sweep/sweep_plan.hpp"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sweep_support.hpp"

namespace linkwright {
namespace sweep_plan_test {
namespace {

using sweep_support::plan_of;
using sweep_support::sweep_text;
using testing::HasSubstr;

const std::string reach = R"([{"at": "/task/function/output_range_deg/1", "from": -60, "to": -30)";

/// "code at place" of all mistakes of the text.
std::vector<std::string> mistakes(const std::string& text) {
  const auto plan = SweepPlan::read(text, {});
  std::vector<std::string> told;
  if (!plan)
    for (const Error& error : plan.errors()) told.push_back(error.code + " at " + error.place);
  return told;
}

TEST(SweepPlan, AGridIsTheProductOfItsValuesTheLastOneFirst) {
  const auto plan = plan_of(sweep_text(R"({"method": "grid"})", reach + R"(, "count": 3},
      {"name": "gamma", "at": "/requirements/min_transmission_angle_deg", "values": [10, 20, 25, 30]}])"));
  EXPECT_EQ(plan.samples(), 12);
  EXPECT_EQ(plan.values(0), (std::vector<double>{-60, 10}));
  EXPECT_EQ(plan.values(3), (std::vector<double>{-60, 30}));
  EXPECT_EQ(plan.values(6), (std::vector<double>{-45, 25}));
  EXPECT_EQ(plan.values(11), (std::vector<double>{-30, 30}));
}

TEST(SweepPlan, AListIsItsRows) {
  const auto plan = plan_of(sweep_text(R"({"method": "list", "rows": [[-30], [-45.5]]})",
                                       R"([{"at": "/task/function/output_range_deg/1"}])"));
  EXPECT_EQ(plan.samples(), 2);
  EXPECT_EQ(plan.values(1), (std::vector<double>{-45.5}));
  EXPECT_EQ(plan.variables()[0].name, "task.function.output_range_deg[1]");
}

TEST(SweepPlan, NumbersOfTheProblemFollowWhatVaries) {
  const auto plan = plan_of(sweep_text(R"({"method": "random", "samples": 5})", R"([{"name": "size", "from": 2, "to": 3,
      "at": ["/requirements/max_length", {"at": "/task/ground_pivots/output/0", "scale": 20, "offset": 1}]}])"));
  for (std::int64_t i = 0; i < 5; ++i) {
    const double value = plan.values(i)[0];
    const auto problem = nlohmann::json::parse(plan.problem_text(i));
    EXPECT_EQ(problem["requirements"]["max_length"].get<double>(), value);
    EXPECT_EQ(problem["task"]["ground_pivots"]["output"][0].get<double>(), 20 * value + 1);
    EXPECT_EQ(problem["options"]["best"], 1);
  }
}

TEST(SweepPlan, LogarithmicAndWholeRangesReachTheirEnds) {
  const SweepVariable decade{.name = "",
                             .unit = "",
                             .numbers = {},
                             .from = 1,
                             .to = 100,
                             .logarithmic = true,
                             .whole = false,
                             .count = 3,
                             .values = {}};
  EXPECT_DOUBLE_EQ(decade.on_grid(1), 10);
  EXPECT_EQ(decade.on_grid(2), 100);
  const SweepVariable die{.name = "",
                          .unit = "",
                          .numbers = {},
                          .from = 1,
                          .to = 6,
                          .logarithmic = false,
                          .whole = true,
                          .count = 0,
                          .values = {}};
  EXPECT_EQ(die.at(0), 1);
  EXPECT_EQ(die.at(0.99), 6);
  EXPECT_EQ(die.at(0.5), 4);
}

TEST(SweepPlan, BlocksDependOnTheNumberOfSamplesAlone) {
  const auto of = [](const std::string& samples) {
    return plan_of(sweep_text(R"({"method": "random", "samples": )" + samples + "}", reach + "}]"));
  };
  EXPECT_EQ(of("40").block_samples(), 1);
  EXPECT_EQ(of("100000").block_samples(), 24);
  EXPECT_EQ(of("10000000").blocks(), 156250);
  EXPECT_LE(of("9007199254740992").blocks(), std::int64_t{1} << 22);
}

TEST(SweepPlan, ItsTextsMakeTheSamePlan) {
  const auto plan = sweep_support::small_plan();
  auto sweep = nlohmann::json::parse(plan.sweep_text());
  sweep["problem"] = nlohmann::json::parse(plan.base_text());
  const auto again = plan_of(sweep.dump());
  EXPECT_EQ(again.base_text(), plan.base_text());
  EXPECT_EQ(again.problem_text(17), plan.problem_text(17));
}

TEST(SweepPlan, TheFileOfItsProblemIsNamedFromItsFolder) {
  const auto plan = read_sweep_file(LINKWRIGHT_EXAMPLES_DIR "/sweeps/tailgate_pose.json");
  ASSERT_TRUE(plan.ok());
  EXPECT_EQ(plan->samples(), 81);
  EXPECT_EQ(plan->problem(0)->title, "Tailgate hinge");
}

TEST(SweepPlan, MistakesSayWhereTheyAre) {
  const auto wrong = [](const std::string& sampling, const std::string& vary, const std::string& keep = "") {
    return testing::PrintToString(mistakes(sweep_text(sampling, vary, keep)));
  };
  const std::string grid = R"({"method": "grid"})";
  EXPECT_THAT(wrong(grid, R"([{"at": "/task/nowhere", "from": 0, "to": 1, "count": 2}])"),
              HasSubstr("nothing_there at vary[0].at"));
  EXPECT_THAT(wrong(grid, R"([{"at": "/task/kind", "from": 0, "to": 1, "count": 2}])"),
              HasSubstr("no_number_there at vary[0].at"));
  EXPECT_THAT(wrong(grid, R"([{"at": "task", "from": 0, "to": 1, "count": 2}])"),
              HasSubstr("no_pointer at vary[0].at"));
  EXPECT_THAT(wrong(grid, R"([{"at": "/task/function/x/01", "from": 0, "to": 1, "count": 2}])"),
              HasSubstr("at vary[0]"));
  EXPECT_THAT(wrong(grid, R"([{"at": "/task/function/x/-", "from": 0, "to": 1, "count": 2}])"),
              HasSubstr("at vary[0]"));
  EXPECT_THAT(wrong(grid, reach + R"(, "count": 0}])"), HasSubstr("grid_count at vary[0].count"));
  EXPECT_THAT(wrong(grid, reach + R"(, "count": 2.5}])"), HasSubstr("grid_count at vary[0].count"));
  EXPECT_THAT(wrong(grid, reach + R"(, "count": 1e99}])"), testing::Not(HasSubstr("large_grid")));
  EXPECT_THAT(wrong(grid, reach + R"(, "count": 1000000000},
      {"at": "/requirements/max_length", "from": 1, "to": 2, "count": 1000000000}])"),
              HasSubstr("large_grid at vary"));
  EXPECT_THAT(wrong(R"({"method": "sobol", "samples": 1e16})", reach + "}]"),
              HasSubstr("sample_count at sampling.samples"));
  EXPECT_THAT(wrong(R"({"method": "sobol", "samples": 2.5})", reach + "}]"), HasSubstr("sample_count"));
  EXPECT_THAT(wrong(R"({"method": "sobol", "samples": 2, "seed": -1})", reach + "}]"),
              HasSubstr("sweep_seed at sampling.seed"));
  EXPECT_THAT(wrong(R"({"method": "grid", "samples": 2})", reach + R"(, "count": 2}])"),
              HasSubstr("not_of_this_sampling"));
  EXPECT_THAT(wrong(R"({"method": "list", "rows": [[1, 2]]})", R"([{"at": "/requirements/max_length"}])"),
              HasSubstr("short_row at sampling.rows[0]"));
  EXPECT_THAT(wrong(R"({"method": "list", "rows": []})", R"([{"at": "/requirements/max_length"}])"),
              HasSubstr("no_rows"));
  EXPECT_THAT(wrong(grid, "[]"), HasSubstr("nothing_varies at vary"));
  EXPECT_THAT(wrong(grid, reach + R"(, "count": 2, "spacing": "logarithmic"}])"),
              HasSubstr("logarithm_of_zero at vary[0]"));
  EXPECT_THAT(wrong(grid, reach + R"(, "count": 2}, {"at": "/task/function/output_range_deg/1", "values": [1]}])"),
              HasSubstr("varied_twice at vary[1].at"));
  EXPECT_THAT(wrong(grid, reach + R"(, "count": 2, "name": "a/b"}])"), HasSubstr("column_name at vary[0].name"));
  EXPECT_THAT(wrong(grid, reach + R"(, "count": 2, "name": "status"}])"), HasSubstr("repeated_column at vary"));
  EXPECT_THAT(wrong(grid, reach + R"(, "count": 2}])", R"({"columns": ["length.ground"]})"),
              HasSubstr("unknown_column at keep.columns[0]"));
  EXPECT_THAT(wrong(grid, reach + R"(, "count": 2}])", R"({"linkages": 1001})"),
              HasSubstr("kept_linkages at keep.linkages"));
  EXPECT_THAT(
      testing::PrintToString(mistakes(R"({"linkwright": 1, "problem": "no_such.json", "sampling": {"method": "grid"},
      "vary": []})")),
      HasSubstr("unreadable_file at problem"));
  EXPECT_THAT(testing::PrintToString(mistakes(R"({"linkwright": 1, "problem": {"linkwright": 1}, "sampling": {"method":
      "grid"}, "vary": [{"at": "/a", "from": 0, "to": 1, "count": 1}]})")),
              HasSubstr("at problem.task"));
}

TEST(SweepPlan, KeepsAsManyLinkagesOfEachSample) {
  const auto refused = SweepPlan::read(
      sweep_support::sweep_text(R"({"method": "list", "rows": [[5]]})", R"([{"at": "/options/best"}])"), {});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.errors()[0].code, "kept_linkages");
}

TEST(SweepPlan, HasAsManyValuesAsItIsTold) {
  const SweepPlan plan = sweep_support::plan_of(sweep_support::sweep_text(
      R"({"method": "grid"})", R"([{"at": "/requirements/max_length", "from": 1, "to": 2, "count": 1e10}])"));
  EXPECT_EQ(plan.samples(), 10'000'000'000);
}

TEST(SweepPlan, HasLogarithmsWhoseEndsAreFartherApartThanADoubleHolds) {
  const SweepPlan plan = sweep_support::plan_of(sweep_support::sweep_text(
      R"({"method": "grid"})",
      R"([{"at": "/requirements/max_length", "from": 1e-200, "to": 1e200, "count": 5, "spacing": "logarithmic"}])"));
  for (int k = 0; k < 5; ++k) EXPECT_NEAR(std::log10(plan.values(k)[0]), -200 + 100 * k, 1e-10);
}

TEST(SweepPlan, MakesNoProblemOfANumberThatOverflows) {
  const SweepPlan plan = sweep_support::plan_of(sweep_support::sweep_text(
      R"({"method": "grid"})",
      R"([{"at": {"at": "/requirements/max_length", "scale": 1e300}, "from": 1, "to": 1e300, "count": 2}])"));
  EXPECT_TRUE(plan.problem(0).ok());
  ASSERT_FALSE(plan.problem(1).ok());
  EXPECT_EQ(plan.problem(1).errors()[0].code, "number_overflows");
}

}  // namespace
}  // namespace sweep_plan_test
}  // namespace linkwright
