#include "linkwright/io/result_file.hpp"

#include <cmath>
#include <cstring>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io_support.hpp"
#include "linkwright/core/angle.hpp"

namespace linkwright {
namespace {

using testing::motion;

using nlohmann::json;
using ::testing::HasSubstr;
using testing::solved_tailgate;
using testing::tailgate;

const json& tailgate_result() {
  static const json result = json::parse(write_result(tailgate(), solved_tailgate(), true));
  return result;
}

std::vector<std::uint8_t> decoded(const std::string& text) {
  constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<std::uint8_t> bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    if (c == '=') break;
    bits = bits << 6 | static_cast<std::uint32_t>(alphabet.find(c));
    count += 6;
    if (count >= 8) bytes.push_back(static_cast<std::uint8_t>(bits >> (count -= 8)));
  }
  return bytes;
}

std::vector<float> decoded_floats(const std::string& text) {
  const std::vector<std::uint8_t> bytes = decoded(text);
  std::vector<float> numbers(bytes.size() / 4);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    std::uint32_t bits = 0;
    for (int k = 3; k >= 0; --k) bits = bits << 8 | bytes[4 * i + static_cast<std::size_t>(k)];
    std::memcpy(&numbers[i], &bits, sizeof bits);
  }
  return numbers;
}

TEST(ResultFile, SaysWhatWasFound) {
  const json& result = tailgate_result();
  EXPECT_EQ(result["linkwright"], 1);
  EXPECT_EQ(result["status"], "solved");
  EXPECT_EQ(result["pattern"], "P-P-P-P");
  EXPECT_EQ(result["curve"]["kind"], "two_branches");
  EXPECT_EQ(result["curve"]["branches"].size(), 2u);
  EXPECT_EQ(result["curve"]["samples"]["coordinate"].size(), 96u);
  EXPECT_EQ(result["curve"]["samples"]["circle_homogeneous"].size(), 96u);
  EXPECT_EQ(result["region"]["samples"], 96);
  EXPECT_EQ(result["region"]["counts"]["pairs"], 96 * 95);
  EXPECT_EQ(result["region"]["counts"]["defect_free"].get<std::int64_t>(), solved_tailgate().counts.defect_free);
  EXPECT_EQ(result["linkages"].size(), solved_tailgate().linkages.size());
}

TEST(ResultFile, EchoesTheProblemWithItsDefaults) {
  const json& problem = tailgate_result()["problem"];
  EXPECT_EQ(problem["task"]["poses"][3], (json{{"x", -220}, {"y", 450}, {"theta_deg", -82}}));
  EXPECT_EQ(problem["requirements"]["max_length"], 450);
  EXPECT_EQ(problem["requirements"]["no_defects"], true);
  EXPECT_EQ(problem["options"]["region_samples"], 96);
  Problem no_limit = tailgate();
  no_limit.requirements.max_length.reset();
  const json echo = json::parse(write_result(no_limit, testing::solution_of(no_limit), false))["problem"];
  EXPECT_NEAR(echo["requirements"]["max_length"].get<double>(), 3711.9, 0.1);
  EXPECT_TRUE(read_problem(echo.dump()).ok());
}

TEST(ResultFile, NumbersReadBackBitIdentical) {
  const Solution& solution = solved_tailgate();
  const json& result = tailgate_result();
  EXPECT_EQ(result["condition"].get<double>(), solution.given.conditions.condition());
  for (std::size_t i = 0; i < solution.samples.size(); ++i) {
    const json& circle = result["curve"]["samples"]["circle_homogeneous"][i];
    EXPECT_EQ(circle[0].get<double>(), solution.samples[i].circle.w);
    EXPECT_EQ(circle[1].get<double>(), solution.samples[i].circle.x);
    EXPECT_EQ(circle[2].get<double>(), solution.samples[i].circle.y);
    EXPECT_EQ(result["region"]["input_coordinate"][i].get<double>(), solution.region.input_dyads()[i].coordinate);
  }
}

TEST(ResultFile, ArraysAreTheRegionRowByRow) {
  const json& region = tailgate_result()["region"];
  const RegionMap& map = solved_tailgate().region;
  const auto types = decoded(region["type"]), defects = decoded(region["defects"]);
  ASSERT_EQ(types.size(), map.rows() * map.columns());
  EXPECT_TRUE(std::equal(types.begin(), types.end(), map.types().begin()));
  EXPECT_TRUE(std::equal(defects.begin(), defects.end(), map.defects().begin()));
  const auto gamma = decoded_floats(region["properties"]["min_transmission_angle_deg"]);
  const auto sweep = decoded_floats(region["properties"]["driver_sweep_deg"]);
  ASSERT_EQ(gamma.size(), types.size());
  for (std::size_t row = 0; row < map.rows(); ++row) {
    for (std::size_t column = 0; column < map.columns(); ++column) {
      const std::size_t cell = map.index(row, column);
      EXPECT_EQ(gamma[cell], static_cast<float>(degrees(map.min_transmission_angle(cell))));
      EXPECT_EQ(sweep[cell], static_cast<float>(degrees(map.driver_sweep(row, column))));
    }
  }
  for (const char* property : {"min_transmission_angle_full_turn_deg", "link_ratio", "longest_link"}) {
    EXPECT_EQ(decoded_floats(region["properties"][property]).size(), types.size()) << property;
  }
}

TEST(ResultFile, HasNoArraysUnlessAskedTo) {
  const json region = json::parse(write_result(tailgate(), solved_tailgate(), false))["region"];
  EXPECT_FALSE(region.contains("type"));
  EXPECT_FALSE(region.contains("properties"));
  EXPECT_TRUE(region.contains("counts"));
}

TEST(ResultFile, LinkagesAreCompleteAndConsistent) {
  for (const json& linkage : tailgate_result()["linkages"]) {
    const json &input = linkage["input"], &output = linkage["output"];
    const auto point = [](const json& pair) { return Point{pair[0].get<double>(), pair[1].get<double>()}; };
    EXPECT_NEAR(std::abs(point(input["center_point"]) - point(input["circle_point"])), linkage["lengths"]["input"],
                1e-9);
    EXPECT_NEAR(std::abs(point(input["center_point"]) - point(output["center_point"])), linkage["lengths"]["ground"],
                1e-9);
    EXPECT_LT(linkage["residual"].get<double>(), 1e-9);
    EXPECT_TRUE(linkage["verified_by_driving"].get<bool>());
    EXPECT_EQ(linkage["defects"], (json{{"order", false}, {"branch", false}, {"circuit", false}}));
    EXPECT_GE(linkage["min_transmission_angle_deg"].get<double>(), 30 - 1e-9);
    EXPECT_TRUE(linkage["drive"].is_string());
    EXPECT_TRUE(linkage["swapped"].contains("type"));
  }
}

TEST(ResultFile, PivotsAtInfinityAreNull) {
  Problem problem = testing::problem_of({{0, 0, 0}, {1, 1, 0}, {2, 1, 0}, {3, 2, 100}});
  problem.requirements = {.no_defects = false, .max_link_ratio = Requirements::unlimited};
  const std::string text = write_result(problem, testing::solution_of(problem), true);
  EXPECT_EQ(text.find("nan"), std::string::npos);
  EXPECT_EQ(text.find("inf,"), std::string::npos);
  EXPECT_TRUE(json::parse(text)["curve"].contains("branches"));
}

TEST(ResultFile, ExplainsNothingAndNamesRelaxations) {
  Problem problem = tailgate();
  problem.requirements.min_transmission_angle = radians(89);
  const json result = json::parse(write_result(problem, testing::solution_of(problem), false));
  EXPECT_EQ(result["linkages"].size(), 0u);
  EXPECT_FALSE(result["reason"].get<std::string>().empty());
  ASSERT_GT(result["relax"].size(), 0u);
  const auto found = std::find_if(result["relax"].begin(), result["relax"].end(), [](const json& entry) {
    return entry["requirement"] == "min_transmission_angle_deg";
  });
  ASSERT_NE(found, result["relax"].end());
  if (!(*found)["value"].is_null()) {
    EXPECT_LT((*found)["value"].get<double>(), 89);  // degrees, as in the file
    EXPECT_GT((*found)["value"].get<double>(), 30);
  }
}

TEST(ResultFile, OfATaskWithoutCurveIsWhole) {
  for (const Problem& problem : {testing::problem_of({{0, 0, 0}, {1, 1, 0}, {2, 5, 0}, {3, 2, 0}}),
                                 testing::problem_of({{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0.6, 0.8, 0}})}) {
    const json result = json::parse(write_result(problem, testing::solution_of(problem), true));
    EXPECT_NE(result["status"], "solved");
    EXPECT_EQ(result["linkages"].size(), 0u);
    EXPECT_FALSE(result["reason"].get<std::string>().empty());
  }
}

TEST(ResultFile, TextGoesOutInPieces) {
  std::string text;
  std::size_t largest = 0;
  write_result(
      [&](std::string_view piece) {
        text += piece;
        largest = std::max(largest, piece.size());
      },
      tailgate(), solved_tailgate(), true);
  EXPECT_EQ(text, write_result(tailgate(), solved_tailgate(), true));
  EXPECT_LT(largest, std::size_t{1} << 18);
}

TEST(ResultFile, LinkagesReadBackBitIdentical) {
  const auto linkages = read_result_linkages(write_result(tailgate(), solved_tailgate(), true));
  ASSERT_TRUE(linkages.ok());
  ASSERT_EQ(linkages->size(), solved_tailgate().linkages.size());
  for (std::size_t i = 0; i < linkages->size(); ++i) {
    const StoredLinkage& linkage = linkages.value()[i];
    const FourBar& wanted = solved_tailgate().linkages[i].four_bar;
    EXPECT_EQ(linkage.title, "Tailgate hinge");
    EXPECT_EQ(linkage.length_unit, "mm");
    ASSERT_EQ(linkage.poses.size(), 4u);
    EXPECT_EQ(linkage.poses[2].pose.angle, motion(tailgate()).poses[2].pose.angle);
    EXPECT_LT(std::abs(linkage.four_bar.input_center - wanted.input_center), 1e-9);
    EXPECT_LT(std::abs(linkage.four_bar.output_circle - wanted.output_circle), 1e-9);
  }
}

TEST(ResultFile, OfMixedPositionsSaysHowWellTheDerivativesAreMet) {
  const json result = json::parse(write_result(testing::hood_hinge(), testing::solved_hood_hinge(), false));
  EXPECT_EQ(result["pattern"], "PP-P-P");
  EXPECT_EQ(result["problem"]["task"]["poses"][0]["derivatives"],
            json::parse(R"([{"x": 0, "y": 1, "theta": -0.004}])"));
  EXPECT_EQ(result["problem"]["requirements"]["respect_direction"], true);
  ASSERT_GT(result["linkages"].size(), 0u);
  for (const json& linkage : result["linkages"]) {
    EXPECT_LT(linkage["residual_derivatives"].get<double>(), 1e-14);
    EXPECT_TRUE(linkage["verified_by_driving"].get<bool>());
  }
  for (const json& linkage : tailgate_result()["linkages"]) EXPECT_FALSE(linkage.contains("residual_derivatives"));
}

TEST(ResultFile, OfASinglePoseIsWhole) {
  Problem problem = testing::problem_of({{1, 2, 30}});
  motion(problem).poses[0].derivatives = {{{1, 0}, 0.8}, {{0.6, 1}, 0.2}, {{0, 1.2}, -0.3}};
  const std::string text = write_result(problem, testing::solution_of(problem), true);
  EXPECT_EQ(text.find("nan"), std::string::npos);
  const json result = json::parse(text);
  EXPECT_EQ(result["pattern"], "PPPP");
  ASSERT_GT(result["linkages"].size(), 0u);
  EXPECT_EQ(result["linkages"][0]["driver_sweep_deg"], 0);
  EXPECT_TRUE(result["linkages"][0]["min_transmission_angle_deg"].is_number());
  EXPECT_TRUE(result["linkages"][0]["drive"].is_string());
  const auto linkages = read_result_linkages(text);
  ASSERT_TRUE(linkages.ok());
  ASSERT_EQ(linkages.value()[0].poses.size(), 1u);
  EXPECT_EQ(linkages.value()[0].poses[0].derivatives.size(), 3u);
}

TEST(ResultFile, LinkagesOfMixedPositionsKeepTheirDerivatives) {
  const auto linkages = read_result_linkages(write_result(testing::hood_hinge(), testing::solved_hood_hinge(), false));
  ASSERT_TRUE(linkages.ok());
  for (const StoredLinkage& linkage : linkages.value()) {
    ASSERT_EQ(linkage.poses.size(), 3u);
    ASSERT_EQ(linkage.poses[0].derivatives.size(), 1u);
    EXPECT_EQ(linkage.poses[0].derivatives[0].origin, Point(0, 1));
    EXPECT_EQ(linkage.poses[0].derivatives[0].angle, -0.004);
    EXPECT_TRUE(linkage.poses[1].derivatives.empty());
  }
}

TEST(ResultFile, RefusesWhatIsNone) {
  const std::pair<std::string, std::string> refused[] = {
      {"", "empty"},
      {"[]", "an object"},
      {"{}", "missing"},
      {R"({"linkages": 3})", "a list of linkages"},
      {R"({"linkages": [{"input": {"center_point": null}}]})", "infinity"},
      {R"({"linkwright": 9, "linkages": []})", "newer Linkwright"},
      {write_problem(tailgate()), "problem file"},
      {R"({"linkages": [], "problem": {"task": {"poses": [1, 2, 3, 4, 5, 6]}}})", "at most 5 poses"},
  };
  for (const auto& [text, reason] : refused) {
    const auto linkages = read_result_linkages(text);
    ASSERT_FALSE(linkages.ok()) << text;
    EXPECT_THAT(linkages.errors()[0].message, HasSubstr(reason));
  }
}

}  // namespace
}  // namespace linkwright
