#include "linkwright/function/wanted_function.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "linkwright/core/angle.hpp"
#include "support/random_function.hpp"

namespace linkwright::wanted_function_test {
namespace {

WantedFunction four_pairs() {
  WantedFunction task;
  task.pairs = {{0, 0, {}}, {0.3, 0.2, {}}, {0.7, 0.8, {}}, {1.1, 1.3, {}}};
  return task;
}

WantedFunction squares() { return testing::named_task("x^2", {0, 1}, 60, 90); }

std::string codes(const WantedFunction& task) {
  std::string text;
  for (const Error& e : mistakes_in(task)) text += (text.empty() ? "" : " ") + e.code + "@" + e.place.substr(5);
  return text;
}

TEST(WantedFunction, FourOrFivePositionsOfAnyPatternAreFine) {
  WantedFunction task = four_pairs();
  EXPECT_EQ(codes(task), "");
  task.pairs.push_back({1.5, 1.4, {}});
  EXPECT_EQ(codes(task), "");
  task.pairs.push_back({1.6, 1.5, {}});
  EXPECT_EQ(codes(task), "too_many_pairs@pairs");
  task.pairs.resize(2);
  EXPECT_EQ(codes(task), "too_few_pairs@pairs");
  task.pairs[1].derivatives = {{1, 2}, {0, 0}};
  EXPECT_EQ(codes(task), "");
  EXPECT_EQ(pattern(task.pairs), "P-PPP");
  task.pairs.clear();
  EXPECT_EQ(codes(task), "too_few_pairs@pairs");
}

TEST(WantedFunction, NumbersAreFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  WantedFunction task = four_pairs();
  task.pairs[2].output = nan;
  task.pairs[1].derivatives = {{nan, 1}};
  EXPECT_EQ(codes(task), "number_range@pairs[1].derivatives[0].input number_range@pairs[2].output_deg");
}

TEST(WantedFunction, TheInputMovesWhereRatesAreGiven) {
  WantedFunction task = four_pairs();
  task.pairs[1].derivatives = {{0, 0}};
  EXPECT_EQ(codes(task), "zero_rates@pairs[1].derivatives[0]");
  task.pairs[1].derivatives = {{0, 1}};
  EXPECT_EQ(codes(task), "input_at_rest@pairs[1].derivatives[0].input");
  task.pairs[1].derivatives = {{1, 0}};
  EXPECT_EQ(codes(task), "") << "a dwell";
}

TEST(WantedFunction, AnInputAngleComesOnceAndTheOutputMoves) {
  WantedFunction task = four_pairs();
  task.pairs[3].input = task.pairs[1].input + two_pi;
  EXPECT_EQ(codes(task), "repeated_input@pairs[3].input_deg");
  task = four_pairs();
  for (AnglePair& pair : task.pairs) pair.output = 0.4;
  EXPECT_EQ(codes(task), "constant_output@pairs");
  task.pairs[0].derivatives = {{1, 0.5}};
  EXPECT_EQ(codes(task), "") << "it moves through";
}

TEST(WantedFunction, PairsComeFromTheFunction) {
  const WantedFunction task = squares();
  EXPECT_EQ(codes(task), "");
  ASSERT_EQ(task.pairs.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    const double x = 0.5 - 0.5 * std::cos((2 * static_cast<double>(i) + 1) * pi / 8);
    EXPECT_NEAR(task.pairs[i].input, radians(60) * x, 1e-15);
    EXPECT_NEAR(task.pairs[i].output, radians(90) * x * x, 1e-15);
  }
  WantedFunction wrong = task;
  wrong.function->expression = "x^x";
  EXPECT_EQ(codes(wrong), "unknown_expression@function.expression");
  wrong.pairs.clear();
  EXPECT_EQ(codes(wrong), "unknown_expression@function.expression") << "and nothing of the pairs that it would give";
}

TEST(WantedFunction, AFreeNumberChangesThePairs) {
  WantedFunction task = squares();
  task.pairs[1].derivatives = {{1, 3}};
  task.free = FreeParameter{};
  WantedFunction fixed = wanted_at(task, 2);
  auto pairs = fixed.pairs;
  for (std::size_t j = 0; j < 4; ++j) {
    EXPECT_EQ(pairs[j].input, task.pairs[j].input);
    EXPECT_NEAR(pairs[j].output - pairs[0].output, 2 * (task.pairs[j].output - task.pairs[0].output), 1e-15);
  }
  EXPECT_EQ(pairs[1].derivatives[0].output, 6);
  EXPECT_FALSE(fixed.free);
  const ScaledFunction stretched(*fixed.function);
  for (const AnglePair& pair : pairs) EXPECT_NEAR(stretched.output_at(pair.input), pair.output, 1e-15);
  task.free = FreeParameter{FreeParameter::Kind::pair_output, {0, 1}, 2};
  pairs = wanted_at(task, 0.75).pairs;
  EXPECT_EQ(pairs[2].output, 0.75);
  EXPECT_EQ(pairs[2].input, task.pairs[2].input);
}

TEST(WantedFunction, AFreeNumberIsChecked) {
  WantedFunction task = four_pairs();
  task.free = FreeParameter{FreeParameter::Kind::output_scale, {0, 2}};
  EXPECT_EQ(codes(task), "scale_range@free.range");
  task.free->range = {2, 1};
  EXPECT_EQ(codes(task), "range_order@free.range");
  task.free = FreeParameter{FreeParameter::Kind::pair_output, {0, 1}, 4};
  EXPECT_EQ(codes(task), "no_such_pair@free.pair");
  task = four_pairs();
  task.pairs[0].derivatives = {{1, 1}};
  task.free = FreeParameter{};
  EXPECT_EQ(codes(task), "free_number_of_five@free");
}

TEST(FreeParameter, IsSpacedOverItsRange) {
  const FreeParameter scale;
  EXPECT_DOUBLE_EQ(scale.at(0), 0.5);
  EXPECT_DOUBLE_EQ(scale.at(0.5), 1) << "by its logarithm";
  EXPECT_DOUBLE_EQ(scale.at(1), 2);
  const FreeParameter output{FreeParameter::Kind::pair_output, {-1, 3}};
  EXPECT_DOUBLE_EQ(output.at(0.25), 0);
  for (const FreeParameter& free : {scale, output})
    for (const double t : {0.0, 0.3, 1.0}) EXPECT_NEAR(free.place_of(free.at(t)), t, 1e-15);
}

TEST(AnglePair, CountsItsDerivativesAsPositions) {
  const std::vector<AnglePair> pairs = {{0, 0, {}}, {1, 2, {{1, 2}, {0, 1}}}, {2, 3, {{1, 1}}}};
  EXPECT_EQ(position_count(pairs), 6);
  EXPECT_EQ(pattern(pairs), "P-PPP-PP");
  EXPECT_NE(pairs[0], pairs[2]);
}

}  // namespace
}  // namespace linkwright::wanted_function_test
