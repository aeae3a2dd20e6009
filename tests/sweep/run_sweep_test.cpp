#include "linkwright/sweep/run_sweep.hpp"

#include <cstring>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

#include "linkwright/synthesis/solve.hpp"
#include "sweep_file.hpp"
#include "sweep_support.hpp"

namespace linkwright {

namespace run_sweep_test {
namespace {

using sweep_support::ScratchFolder;
using sweep_support::small_plan;
namespace fs = std::filesystem;

std::string bytes_of(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

/// At most so many of the blocks that remain, as if the run ended then.
class FewBlocks : public BlockSource {
 public:
  FewBlocks(const SweepPlan& plan, const JournalScan& done, int most) : remaining_(plan, done), left_(most) {}
  std::optional<std::int64_t> next() override { return left_-- > 0 ? remaining_.next() : std::nullopt; }

 private:
  RemainingBlocks remaining_;
  int left_;
};

void run_part(const fs::path& output, const SweepPlan& plan, int process, int blocks, int threads) {
  auto folder = SweepFolder::open(output, plan, SweepStart::resume);
  ASSERT_TRUE(folder.ok());
  FewBlocks source(plan, *folder->scan(plan), blocks);
  auto journal = BlockJournal::open(folder->path(), plan, process);
  EXPECT_FALSE(run_sweep(plan, source, *journal, {threads, nullptr, {}}));
}

TEST(RunSweep, TheFileIsTheSameForAnyThreadsAndParts) {
  if (missing_sweep_files()) GTEST_SKIP() << missing_sweep_files()->message;
  const ScratchFolder scratch;
  const SweepPlan plan = small_plan();
  const fs::path whole = scratch.path() / "whole.h5", parts = scratch.path() / "parts.h5";
  run_part(whole, plan, 0, 1000, 1);
  auto folder = *SweepFolder::open(whole, plan, SweepStart::resume);
  ASSERT_FALSE(write_sweep_file(whole, plan, folder));
  EXPECT_FALSE(fs::exists(SweepFolder::beside(whole)));

  for (int process = 0; process < 5; ++process) run_part(parts, plan, process, 11, 1 + process);
  auto other = *SweepFolder::open(parts, plan, SweepStart::resume);
  ASSERT_FALSE(write_sweep_file(parts, plan, other));
  EXPECT_EQ(bytes_of(whole), bytes_of(parts));
}

TEST(RunSweep, ABlockThatIsMissingIsNoFile) {
  if (missing_sweep_files()) GTEST_SKIP() << missing_sweep_files()->message;
  const ScratchFolder scratch;
  const fs::path output = scratch.path() / "out.h5";
  run_part(output, small_plan(), 0, 39, 2);
  auto folder = *SweepFolder::open(output, small_plan(), SweepStart::resume);
  EXPECT_EQ(write_sweep_file(output, small_plan(), folder)->code, "missing_block");
  EXPECT_FALSE(fs::exists(output));
  EXPECT_TRUE(fs::exists(folder.path()));
}

TEST(RunSweep, ATableSaysWhatIsInIt) {
  if (missing_sweep_files()) GTEST_SKIP() << missing_sweep_files()->message;
  const ScratchFolder scratch;
  const SweepPlan plan = small_plan();
  const fs::path output = scratch.path() / "out.h5";
  run_part(output, plan, 0, 1000, 2);
  auto folder = *SweepFolder::open(output, plan, SweepStart::resume);
  ASSERT_FALSE(write_sweep_file(output, plan, folder));
  const auto summary = summarize_sweep_file(output);
  ASSERT_TRUE(summary.ok());
  EXPECT_EQ(summary->head.samples, 40);
  EXPECT_EQ(summary->head.problem, plan.base_text());
  for (std::size_t t = 0; t < plan.columns().size(); ++t) {
    ASSERT_EQ(summary->tables[t].size(), plan.columns()[t].size());
    for (std::size_t k = 0; k < plan.columns()[t].size(); ++k) {
      EXPECT_EQ(summary->tables[t][k].column.name, plan.columns()[t][k].name);
      EXPECT_EQ(summary->tables[t][k].column.unit, plan.columns()[t][k].unit);
    }
  }
  EXPECT_EQ(summary->tables[0][0].high, 39);
}

// Whatever bytes are changed, reading ends with a summary or a mistake.
TEST(RunSweep, ADamagedTableIsReadOrRefused) {
  if (missing_sweep_files()) GTEST_SKIP() << missing_sweep_files()->message;
  const ScratchFolder scratch;
  const fs::path output = scratch.path() / "out.h5", damaged = scratch.path() / "damaged.h5";
  run_part(output, small_plan(), 0, 1000, 2);
  auto folder = *SweepFolder::open(output, small_plan(), SweepStart::resume);
  ASSERT_FALSE(write_sweep_file(output, small_plan(), folder));
  const std::string bytes = bytes_of(output);
  for (const std::size_t size :
       {std::size_t{0}, std::size_t{7}, std::size_t{100}, bytes.size() / 2, bytes.size() - 1}) {
    std::ofstream(damaged, std::ios::binary) << bytes.substr(0, size);
    EXPECT_FALSE(summarize_sweep_file(damaged).ok()) << size;
  }
  std::ofstream(damaged) << "{}";
  EXPECT_EQ(summarize_sweep_file(damaged).errors()[0].code, "no_sweep_table");
  EXPECT_EQ(summarize_sweep_file(scratch.path()).errors()[0].code, "no_sweep_table");
  EXPECT_EQ(summarize_sweep_file(scratch.path() / "none").errors()[0].code, "unreadable_file");
}

TEST(RunSweep, WhatRemainsIsFoundByNumber) {
  const SweepPlan plan = small_plan();
  JournalScan done;
  for (const std::int64_t block : {0, 1, 7, 20, 39}) done.blocks.push_back({block, 0, 0});
  RemainingBlocks remaining(plan, done);
  const RemainingBlocks elsewhere(plan, remaining.runs());
  EXPECT_EQ(remaining.samples(), 35);
  EXPECT_EQ(elsewhere.samples(), 35);
  EXPECT_EQ(remaining.at(0), 2);
  EXPECT_EQ(remaining.at(5), 8);
  EXPECT_EQ(remaining.at(34), 38);
  for (const std::int64_t outside : {std::int64_t{-1}, std::int64_t{35}, std::int64_t{1} << 62})
    EXPECT_FALSE(remaining.at(outside)) << outside;
  for (std::int64_t k = 0; k < 35; ++k) EXPECT_EQ(remaining.next(), elsewhere.at(k));
  EXPECT_FALSE(remaining.next());
}

TEST(RunSweep, CancelledItKeepsWholeBlocksOnly) {
  const ScratchFolder scratch;
  const SweepPlan plan = small_plan();
  auto folder = *SweepFolder::open(scratch.path() / "out.h5", plan, SweepStart::fresh);
  auto journal = BlockJournal::open(folder.path(), plan, 0);
  RemainingBlocks source(plan, JournalScan{});
  std::atomic<bool> cancelled = false;
  std::int64_t kept = 0;
  const SweepRunOptions options{2, &cancelled, [&](std::int64_t samples) { cancelled = (kept += samples) >= 7; }};
  EXPECT_FALSE(run_sweep(plan, source, *journal, options));
  const auto scan = folder.scan(plan);
  EXPECT_EQ(static_cast<std::int64_t>(scan->blocks.size()), kept);
  EXPECT_LT(kept, 40);
  EXPECT_EQ(RemainingBlocks(plan, *scan).samples(), 40 - kept);
}

}  // namespace
}  // namespace run_sweep_test

namespace sweep_block_test {
namespace {

using sweep_support::small_plan;

std::size_t column(const SweepPlan& plan, SweepTable table, std::string_view name) {
  const auto& columns = plan.columns()[static_cast<std::size_t>(table)];
  for (std::size_t k = 0; k < columns.size(); ++k)
    if (columns[k].name == name) return k;
  ADD_FAILURE() << name;
  return 0;
}

template <class Number>
Number number(const SweepRows& rows, SweepTable table, std::size_t column, std::size_t row) {
  Number value;
  std::memcpy(&value, rows.of(table).bytes(column).data() + row * sizeof value, sizeof value);
  return value;
}

TEST(SweepBlock, AllSamplesAtOnceAreAllBlocksOneByOne) {
  const SweepPlan plan = small_plan();
  SweepRows one_by_one(plan.columns());
  for (std::int64_t block = 0; block < plan.blocks(); ++block) one_by_one.append(*sweep_block(plan, block));
  EXPECT_EQ(one_by_one, *sweep_samples(plan, 0, plan.samples()));
}

TEST(SweepBlock, NumbersAreThoseOfSolve) {
  const SweepPlan plan = small_plan();
  const auto rows = sweep_samples(plan, 0, plan.samples());
  const auto table = SweepTable::linkages;
  std::size_t row = 0;
  for (std::int64_t i = 0; i < plan.samples(); ++i) {
    const auto problem = plan.problem(i);
    if (!problem) continue;
    const auto answer = solve(*problem);
    for (const FourBarSolution& found : std::get<FunctionAnswer>(*answer).linkages) {
      EXPECT_EQ(number<std::int64_t>(*rows, table, 0, row), i);
      EXPECT_EQ(number<double>(*rows, table, column(plan, table, "lengths.coupler"), row), found.lengths.coupler);
      EXPECT_EQ(number<double>(*rows, table, column(plan, table, "lengths.ground"), row), found.lengths.ground);
      ++row;
    }
  }
  EXPECT_EQ(rows->of(table).rows(), row);
  EXPECT_GE(row, 5u);
}

TEST(SweepBlock, WhatMakesNoProblemIsARowWithItsReason) {
  const SweepPlan plan = small_plan();
  const auto rows = sweep_samples(plan, 0, 1);  // the largest length is below 0 there
  EXPECT_EQ(rows->of(SweepTable::samples).rows(), 1u);
  EXPECT_EQ(rows->of(SweepTable::samples).bytes(column(plan, SweepTable::samples, "status")).substr(0, 7), "invalid");
  EXPECT_EQ(rows->of(SweepTable::linkages).rows(), 0u);
  ASSERT_GE(rows->of(SweepTable::failures).rows(), 1u);
  EXPECT_TRUE(rows->of(SweepTable::failures).bytes(2).starts_with("requirements.max_length"));
}

TEST(SweepBlock, CancelledThereIsNone) {
  const std::atomic<bool> cancelled = true;
  EXPECT_FALSE(sweep_block(small_plan(), 5, &cancelled));
}

}  // namespace
}  // namespace sweep_block_test

}  // namespace linkwright
