#include "linkwright/sweep/kept_columns.hpp"

#include <filesystem>
#include <gtest/gtest.h>
#include <set>

#include "linkwright/files/problem_file.hpp"
#include "linkwright/synthesis/solve.hpp"
#include "sweep/linkage_records.hpp"

namespace linkwright {
namespace kept_columns_test {
namespace {

// A number in the result file's first linkage that nobody keeps by its name would be a slip of the catalogue.
void expect_members(const std::string& example) {
  auto problem = read_problem_file(std::filesystem::path(LINKWRIGHT_EXAMPLES_DIR) / (example + ".json"));
  ASSERT_TRUE(problem.ok()) << example;
  problem->options.region_samples = std::min(problem->options.region_samples, 100);
  auto answer = solve(*problem);
  ASSERT_TRUE(answer.ok()) << example;
  const auto records = linkage_records(std::move(*answer));
  ASSERT_FALSE(records.empty()) << example;
  for (const KeptColumn& kept : keepable_columns(*problem)) {
    if (!kept.by_default || kept.column.name.starts_with("tolerance.")) continue;
    EXPECT_NE(member_at(records[0], kept.column.name), nullptr) << example << " " << kept.column.name;
  }
}

TEST(KeptColumns, NameMembersOfLinkagesOfAllKinds) {
  for (const std::string example : {"tailgate", "log_generator", "loader_bucket_chain", "folding_wing",
                                    "universal_joint_like", "straight_stage", "tailgate_as_made"})
    expect_members(example);
}

TEST(KeptColumns, AreNamedOnceAndDescribed) {
  for (const std::string example : {"tailgate_as_made", "flow_meter_as_made", "loader_bucket", "straight_search"}) {
    const auto problem = read_problem_file(std::filesystem::path(LINKWRIGHT_EXAMPLES_DIR) / (example + ".json"));
    std::set<std::string> names;
    for (const KeptColumn& kept : keepable_columns(*problem)) {
      EXPECT_TRUE(names.insert(kept.column.name).second) << kept.column.name;
      EXPECT_FALSE(kept.column.description.empty());
    }
  }
}

TEST(KeptColumns, OfAMemberThatIsNotThereIsNothing) {
  const auto record = nlohmann::json::parse(R"({"a": {"b": [1, {"c": 2}]}})");
  EXPECT_EQ(*member_at(record, "a.b[1].c"), 2);
  for (const char* name : {"x", "a.x", "a.b[2]", "a[0]", "a.b.c"}) EXPECT_EQ(member_at(record, name), nullptr) << name;
}

}  // namespace
}  // namespace kept_columns_test
}  // namespace linkwright
