#include "linkwright/files/analysis_file.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "linkwright/core/angle.hpp"

namespace linkwright::analysis_file_test {
namespace {

using nlohmann::json;

StoredLinkage of_lengths(const char* text) {
  const auto linkage = read_linkage(text);
  EXPECT_TRUE(linkage.ok());
  return linkage.value();
}

TEST(AnalysisFile, OfACrankRocker) {
  const auto analysis = analyze(of_lengths(R"({"lengths": {"ground": 4, "input": 2, "coupler": 3, "output": 3.5}})"));
  EXPECT_EQ(analysis.type, LinkageType::crank_rocker);
  const json text = json::parse(write_analysis(analysis));
  EXPECT_EQ(text["type"], "crank_rocker");
  EXPECT_TRUE(text["input_is_crank"].get<bool>());
  EXPECT_TRUE(text["dead_points"].empty());
  EXPECT_TRUE(text["change_point"].is_null());
  // extremes of the diagonal, ground ± input, by the cosine rule
  EXPECT_NEAR(text["min_transmission_angle_full_turn_deg"].get<double>(),
              degrees(std::acos((9 + 12.25 - 4) / (2 * 3 * 3.5))), 1e-9);
  EXPECT_EQ(text["motion"]["input_angle_deg"].size(), 361u);
}

TEST(AnalysisFile, OfATripleRockerHasItsDeadPoints) {
  const auto analysis = analyze(of_lengths(R"({"lengths": {"ground": 4, "input": 5, "coupler": 3, "output": 3}})"));
  const json text = json::parse(write_analysis(analysis));
  EXPECT_EQ(text["type"], "triple_rocker_input");
  EXPECT_FALSE(text["dead_points"].empty());
  EXPECT_TRUE(text["min_transmission_angle_full_turn_deg"].is_null());
  EXPECT_TRUE(text["motion"]["output_rate"][0].is_null());  // unbounded at the dead point
}

TEST(AnalysisFile, NamesChangePoints) {
  const auto analysis = analyze(of_lengths(R"({"lengths": {"ground": 4, "input": 2, "coupler": 4, "output": 2}})"));
  EXPECT_EQ(json::parse(write_analysis(analysis))["change_point"], "parallelogram_or_kite");
}

TEST(AnalysisFile, LooksAtAnInstantWhereTheInputCanBe) {
  const auto linkage = of_lengths(R"({"lengths": {"ground": 4, "input": 5, "coupler": 3, "output": 3}})");
  const auto as_it_lies = instant_of(linkage, {});
  ASSERT_TRUE(as_it_lies.ok());
  EXPECT_EQ(as_it_lies->four_bar.input_moving, linkage.four_bar.input_moving);
  const auto refused = instant_of(linkage, {{}, radians(180), 0});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.errors().front().place, "input_deg");
  EXPECT_NE(refused.errors().front().message.find("the input rocks from"), std::string::npos);
}

}  // namespace
}  // namespace linkwright::analysis_file_test
