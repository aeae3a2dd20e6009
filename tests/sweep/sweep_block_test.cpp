#include "linkwright/sweep/sweep_block.hpp"

#include <cstring>
#include <gtest/gtest.h>

#include "linkwright/synthesis/solve.hpp"
#include "sweep_support.hpp"

namespace linkwright {
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
