#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>
#include <string>

#include "analyses/loads/spring_schema.hpp"
#include "files/fields/field_schema.hpp"
#include "support/file_support.hpp"
#include "sweep/sweep_schema.hpp"

namespace linkwright::schema_test {
namespace {

using Json = OrderedJson;

const std::string root = std::string(LINKWRIGHT_SCHEMA_DIR) + "/..";

Json rules_of(const std::string& files) {
  return Json::parse(testing::text_of(root + "/src/files/fields/" + files + "_rules.json"));
}

/// The file is what was generated; with LINKWRIGHT_GENERATE in the environment it becomes that.
void expect_generated(const std::string& path, const std::string& text) {
  if (std::getenv("LINKWRIGHT_GENERATE") != nullptr) std::ofstream(root + path) << text;
  EXPECT_EQ(testing::text_of(root + path), text) << "run LINKWRIGHT_GENERATE=1 build/release/bin/tests_files";
}

void expect_all_referred_to(const Json& schema) {
  const std::string text = schema.dump();
  for (const auto& [name, definition] : schema.at("$defs").items())
    EXPECT_NE(text.find("\"#/$defs/" + name + "\""), std::string::npos) << name;
}

TEST(ProblemSchema, IsWhatTheFieldsSayAndTheRulesBetweenThem) {
  expect_generated("/schema/problem.schema.json", readable(problem_schema(rules_of("problem"))) + "\n");
}

TEST(ResultSchema, IsWhatTheFieldsSayAndTheRulesBetweenThem) {
  expect_generated("/schema/result.schema.json", readable(result_schema(rules_of("result"))) + "\n");
}

TEST(AnalysisSchema, IsWhatTheFieldsSayAndTheRulesBetweenThem) {
  expect_generated("/schema/analysis.schema.json", readable(analysis_schema(rules_of("analysis"))) + "\n");
}

TEST(SweepSchema, IsWhatTheFieldsSayAndTheRulesBetweenThem) {
  expect_generated("/schema/sweep.schema.json", readable(sweep_schema(rules_of("sweep"))) + "\n");
}

TEST(SpringSchema, IsWhatTheFieldsSayAndTheRulesBetweenThem) {
  expect_generated("/schema/spring_boxes.schema.json", readable(spring_boxes_schema(rules_of("spring_boxes"))) + "\n");
  expect_generated("/schema/spring_catalogue.schema.json",
                   readable(spring_catalogue_schema(rules_of("spring_catalogue"))) + "\n");
}

// A rule of a definition that has another name would make one that nothing refers to.
TEST(ProblemSchema, HasNoDefinitionThatNothingRefersTo) { expect_all_referred_to(problem_schema(rules_of("problem"))); }
TEST(ResultSchema, HasNoDefinitionThatNothingRefersTo) { expect_all_referred_to(result_schema(rules_of("result"))); }
TEST(SweepSchema, HasNoDefinitionThatNothingRefersTo) { expect_all_referred_to(sweep_schema(rules_of("sweep"))); }
TEST(AnalysisSchema, HasNoDefinitionThatNothingRefersTo) {
  expect_all_referred_to(analysis_schema(rules_of("analysis")));
}

TEST(SpringSchema, HasNoDefinitionThatNothingRefersTo) {
  expect_all_referred_to(spring_boxes_schema(rules_of("spring_boxes")));
  expect_all_referred_to(spring_catalogue_schema(rules_of("spring_catalogue")));
}

TEST(ProblemSchema, IsInTheTypesOfThePage) {
  expect_generated(
      "/web/src/contract/problem.ts",
      "// What problem files hold: generated from the fields of the engine (docs/architecture.md), not written.\n" +
          typescript(problem_schema(), "Problem"));
}

TEST(ResultSchema, IsInTheTypesOfThePage) {
  expect_generated(
      "/web/src/contract/result.ts",
      "// What result files hold: generated from the fields of the engine (docs/architecture.md), not written.\n"
      "import type {Box, Chain, Orientation, Pose, Problem, StraightLineTask} from \"./problem\";\n\n" +
          typescript(result_schema(), "ResultFile"));
}

}  // namespace
}  // namespace linkwright::schema_test
