#include "function/function_columns.hpp"

#include <array>
#include <gtest/gtest.h>

namespace linkwright::function_columns_test {
namespace {

// A curve that has two branches where the last output is beyond 1.
struct FakeCurve {
  bool has_oval = false;
  [[nodiscard]] std::vector<CurveBranch> branches() const {
    return has_oval ? std::vector<CurveBranch>{{"odd", 0, 1}, {"oval", 1, 2}} : std::vector<CurveBranch>{{"odd", 0, 1}};
  }
  [[nodiscard]] double coordinate_length() const { return has_oval ? 2 : 1; }
};
struct FakeCouplers {
  std::shared_ptr<const FakeCurve> curve;
  std::vector<int> points;
};
using Columns = FunctionColumns<FakeCouplers>;

FakeCouplers couplers_of(const std::vector<AnglePair>& pairs) {
  return {std::make_shared<const FakeCurve>(FakeCurve{pairs.back().output > 1}), {}};
}

Columns columns_of(const WantedFunction& wanted) {
  return {wanted, std::make_shared<const FakeCouplers>(couplers_of(wanted.pairs)), couplers_of};
}

WantedFunction four_pairs() { return {{{0, 0, {}}, {0.3, 0.2, {}}, {0.7, 0.5, {}}, {1.1, 0.8, {}}}, {}, {}}; }

TEST(FunctionColumns, AreAllTheSameWithoutAFreeParameter) {
  const WantedFunction wanted = four_pairs();
  const Columns columns = columns_of(wanted);
  EXPECT_EQ(columns.at(0.1).couplers, columns.at(0.9).couplers);
  EXPECT_EQ(columns.pairs_at(0.7), wanted.pairs);
  EXPECT_EQ(columns.coupler_axis().coordinate_length(), 1);
  EXPECT_EQ(axis_of(wanted.free).quantity, AxisQuantity::nothing);
}

TEST(FunctionColumns, FollowTheFreeParameter) {
  WantedFunction wanted = four_pairs();
  wanted.free = FreeParameter{};
  const Columns columns = columns_of(wanted);
  EXPECT_NEAR(columns.pairs_at(0.75).back().output, 0.8 * std::sqrt(2.0), 1e-15);
  EXPECT_EQ(columns.coupler_axis().coordinate_length(), 2) << "as many branches as there are anywhere";
  EXPECT_EQ(columns.recent_at(0.3).couplers, columns.recent_at(0.3).couplers) << "found once";
  EXPECT_NE(columns.at(0.3).couplers, columns.at(0.3).couplers);
  constexpr std::array<double, 3> places = {0, 0.5, 0.9};
  const auto all = columns.along(places, 2);
  ASSERT_EQ(all.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(all[k].pairs, columns.pairs_at(places[k]));
}

TEST(FunctionColumns, OfFivePairsHaveABranchToEachPoint) {
  const WantedFunction wanted = four_pairs();
  const Columns columns(wanted, std::make_shared<const FakeCouplers>(FakeCouplers{nullptr, {1, 2, 3}}), couplers_of);
  EXPECT_EQ(columns.coupler_axis().quantity, AxisQuantity::burmester_point);
  EXPECT_EQ(columns.coupler_axis().coordinate_length(), 3);
}

TEST(FunctionColumns, TheErrorIsThatOfTheStretchedFunction) {
  WantedFunction wanted;
  wanted.function = NamedFunction{.expression = "x", .x = {{0, 1}}, .input_range = {0, 1}, .output_range = {0, 1}};
  wanted.pairs = precision_pairs(*wanted.function);
  wanted.free = FreeParameter{};
  const Columns columns = columns_of(wanted);
  EXPECT_TRUE(columns.has_function());
  const AngleRange turn{-4, 4};
  const auto doubled = [&](const AnglePair& first) {
    return GeneratedFunction([](double input) { return std::optional(2 * input); }, {0, 0}, {&turn, 1}, first);
  };
  EXPECT_LT(columns.error_of(doubled, 0.999999999, {}).precision_error, 1e-8);
  EXPECT_GT(columns.error_of(doubled, 0.5, {}).precision_error, 0.1);
}

TEST(FunctionColumns, AnAxisReadsInPeoplesUnits) {
  FreeParameter free{FreeParameter::Kind::pair_output, {0, 3}, 1};
  EXPECT_EQ(axis_of(free).quantity, AxisQuantity::pair_output);
  EXPECT_NEAR(axis_value_of(free, 0.5), degrees(1.5), 1e-12);
  free = {};
  EXPECT_NEAR(axis_value_of(free, 0.5), 1, 1e-15);
  EXPECT_EQ(axis_value_of(std::nullopt, 0.5), 0.5);
}

}  // namespace
}  // namespace linkwright::function_columns_test
