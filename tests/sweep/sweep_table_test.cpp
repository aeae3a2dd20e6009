#include "linkwright/sweep/sweep_table.hpp"

#include <filesystem>
#include <gtest/gtest.h>
#include <set>

#include "linkwright/files/problem_file.hpp"
#include "linkwright/synthesis/solve.hpp"
#include "sweep/linkage_records.hpp"

namespace linkwright {

namespace sweep_table_test {
namespace {

SweepColumns columns() {
  return {{{count_column("sample", ""), number_column("x", "mm", "")},
           {flag_column("ok", "")},
           {text_column("word", 4, "")}}};
}

SweepRows rows() {
  SweepRows rows(columns());
  rows.of(SweepTable::samples).put(std::int64_t{7});
  rows.of(SweepTable::samples).put(2.5);
  rows.of(SweepTable::linkages).put(std::uint8_t{1});
  rows.of(SweepTable::failures).put("abüc", 4);
  return rows;
}

TEST(SweepTable, RowsComeBackFromTheirBytes) {
  SweepRows back(columns());
  ASSERT_TRUE(back.from_bytes(rows().to_bytes(), columns()));
  EXPECT_EQ(back, rows());
  EXPECT_EQ(back.of(SweepTable::samples).rows(), 1u);
}

TEST(SweepTable, TextIsCutBetweenCharacters) {
  EXPECT_EQ(rows().of(SweepTable::failures).bytes(0), "abü");
  SweepRows shorter(columns());
  shorter.of(SweepTable::failures).put("abcü", 4);
  EXPECT_EQ(shorter.of(SweepTable::failures).bytes(0), std::string("abc\0", 4));
}

TEST(SweepTable, BytesOfOtherColumnsAreRefused) {
  const std::string bytes = rows().to_bytes();
  SweepRows back(columns());
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_FALSE(back.from_bytes(bytes.substr(0, size), columns())) << size;
  EXPECT_FALSE(back.from_bytes(bytes + "x", columns()));
  EXPECT_FALSE(back.from_bytes(std::string(64, '\xff'), columns()));
}

TEST(SweepTable, RowsGrowByOthers) {
  SweepRows both = rows();
  both.append(rows());
  EXPECT_EQ(both.of(SweepTable::samples).rows(), 2u);
  EXPECT_EQ(both.of(SweepTable::samples).bytes(1).size(), 2 * sizeof(double));
}

}  // namespace
}  // namespace sweep_table_test

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
