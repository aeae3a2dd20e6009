#include "linkwright/planar/function_task.hpp"

#include <gtest/gtest.h>
#include <limits>

namespace linkwright::function_task_test {
namespace {

FunctionTask four_pairs() {
  FunctionTask task;
  task.pairs = {{0, 0, {}}, {0.3, 0.2, {}}, {0.7, 0.8, {}}, {1.1, 1.3, {}}};
  return task;
}

std::string codes(const FunctionTask& task) {
  std::string text;
  for (const Error& e : mistakes_in(task)) text += (text.empty() ? "" : " ") + e.code + "@" + e.place.substr(5);
  return text;
}

TEST(FunctionTask, GroundPivotsAreTwoFinitePoints) {
  FunctionTask task = four_pairs();
  EXPECT_EQ(codes(task), "");
  task.input_pivot = task.output_pivot = {3, 4};
  EXPECT_EQ(codes(task), "same_pivots@ground_pivots");
  task.input_pivot = {0, std::numeric_limits<double>::infinity()};
  EXPECT_EQ(codes(task), "number_range@ground_pivots.input[1]");
}

TEST(FunctionTask, TheMistakesOfTheFunctionAreItsOwn) {
  FunctionTask task = four_pairs();
  task.pairs.pop_back();
  task.output_pivot = task.input_pivot;
  EXPECT_EQ(codes(task), "too_few_pairs@pairs same_pivots@ground_pivots");
}

TEST(FunctionTask, KeepsItsPivotsWhenItsParameterIsFixed) {
  FunctionTask task = four_pairs();
  task.input_pivot = {2, 3};
  task.free = FreeParameter{FreeParameter::Kind::pair_output, {0, 1}, 2};
  const FunctionTask fixed = task_at(task, 0.75);
  EXPECT_EQ(fixed.pairs[2].output, 0.75);
  EXPECT_EQ(fixed.input_pivot, task.input_pivot);
  EXPECT_FALSE(fixed.free);
}

}  // namespace
}  // namespace linkwright::function_task_test
