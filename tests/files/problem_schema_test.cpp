#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>
#include <string>

#include "files/fields/field_schema.hpp"
#include "support/file_support.hpp"

namespace linkwright::problem_schema_test {
namespace {

const std::string root = std::string(LINKWRIGHT_SCHEMA_DIR) + "/..";

/// The file is what was generated; with LINKWRIGHT_GENERATE in the environment it becomes that.
void expect_generated(const std::string& path, const std::string& text) {
  if (std::getenv("LINKWRIGHT_GENERATE") != nullptr) std::ofstream(root + path) << text;
  EXPECT_EQ(testing::text_of(root + path), text) << "run LINKWRIGHT_GENERATE=1 build/release/bin/tests_files";
}

TEST(ProblemSchema, IsWhatTheFieldsSayAndTheRulesBetweenThem) {
  const auto rules = FieldSchema::Json::parse(testing::text_of(root + "/src/files/fields/problem_rules.json"));
  expect_generated("/schema/problem.schema.json", readable(problem_schema(rules)) + "\n");
}

// A rule of a definition that has another name would make one that nothing refers to.
TEST(ProblemSchema, HasNoDefinitionThatNothingRefersTo) {
  const auto rules = FieldSchema::Json::parse(testing::text_of(root + "/src/files/fields/problem_rules.json"));
  const auto schema = problem_schema(rules);
  const std::string text = schema.dump();
  for (const auto& [name, definition] : schema.at("$defs").items())
    EXPECT_NE(text.find("\"#/$defs/" + name + "\""), std::string::npos) << name;
}

TEST(ProblemSchema, IsInTheTypesOfThePage) {
  expect_generated(
      "/web/src/engine/problem.ts",
      "// What problem files hold: generated from the fields of the engine (docs/architecture.md), not written.\n" +
          typescript(problem_schema(), "Problem"));
}

}  // namespace
}  // namespace linkwright::problem_schema_test
