#include "linkwright/files/result_file.hpp"

#include <cmath>
#include <cstring>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <map>
#include <nlohmann/json.hpp>

#include "linkwright/core/angle.hpp"
#include "support/file_support.hpp"

namespace linkwright::result_file_test {
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

TEST(ResultFile, SaysWhatALinkageAtAPickedPlaceFails) {
  Problem problem = tailgate();
  const auto result_at = [&](MapPoint place) {
    problem.options.at = place;
    return json::parse(write_result(problem, testing::answer_of(problem), false));
  };
  const json& best = tailgate_result()["linkages"][0];
  EXPECT_FALSE(best.contains("meets_requirements"));
  const MapPoint place = {best["input"]["coordinate"], best["output"]["coordinate"]};
  const json there = result_at(place);
  ASSERT_EQ(there["linkages"].size(), 1u);
  EXPECT_EQ(there["linkages"][0]["meets_requirements"], true);
  EXPECT_FALSE(there["linkages"][0].contains("fails"));
  EXPECT_EQ(there["linkages"][0]["lengths"], best["lengths"]);
  EXPECT_EQ(there["problem"]["options"]["at"], json::array({place.input, place.output}));
  problem.requirements.max_length = 1;
  const json too_long = result_at(place);
  ASSERT_EQ(too_long["linkages"].size(), 1u);
  EXPECT_EQ(too_long["status"], "solved");
  EXPECT_EQ(too_long["linkages"][0]["meets_requirements"], false);
  EXPECT_EQ(too_long["linkages"][0]["fails"], json::array({"max_length"}));
  EXPECT_EQ(result_at({-1, 0})["linkages"].size(), 0u);
  EXPECT_EQ(result_at({-1, 0})["status"], "no_solution");
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
  EXPECT_EQ(result["region"]["counts"]["defect_free"].get<std::int64_t>(),
            testing::four_bars(solved_tailgate()).counts.defect_free);
  EXPECT_EQ(result["linkages"].size(), testing::four_bars(solved_tailgate()).linkages.size());
}

TEST(ResultFile, EchoesTheProblemWithItsDefaults) {
  const json& problem = tailgate_result()["problem"];
  EXPECT_EQ(problem["task"]["poses"][3], (json{{"x", -220}, {"y", 450}, {"theta_deg", -82}}));
  EXPECT_EQ(problem["requirements"]["max_length"], 450);
  EXPECT_EQ(problem["requirements"]["no_defects"], true);
  EXPECT_EQ(problem["options"]["region_samples"], 96);
  Problem no_limit = tailgate();
  no_limit.requirements.max_length.reset();
  const json echo = json::parse(write_result(no_limit, testing::answer_of(no_limit), false))["problem"];
  EXPECT_NEAR(echo["requirements"]["max_length"].get<double>(), 3711.9, 0.1);
  EXPECT_TRUE(read_problem(echo.dump()).ok());
}

TEST(ResultFile, NumbersReadBackBitIdentical) {
  const FourBarAnswer& answer = testing::four_bars(solved_tailgate());
  const json& result = tailgate_result();
  EXPECT_EQ(result["condition"].get<double>(), answer.given.conditions.condition());
  for (std::size_t i = 0; i < answer.samples.size(); ++i) {
    const json& circle = result["curve"]["samples"]["circle_homogeneous"][i];
    EXPECT_EQ(circle[0].get<double>(), answer.samples[i].circle.w);
    EXPECT_EQ(circle[1].get<double>(), answer.samples[i].circle.x);
    EXPECT_EQ(circle[2].get<double>(), answer.samples[i].circle.y);
    EXPECT_EQ(result["region"]["input_coordinate"][i].get<double>(), answer.region.input_coordinates()[i]);
  }
}

TEST(ResultFile, ArraysAreTheRegionRowByRow) {
  const json& region = tailgate_result()["region"];
  const RegionMap& map = testing::four_bars(solved_tailgate()).region;
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
  const std::string text = write_result(problem, testing::answer_of(problem), true);
  EXPECT_EQ(text.find("nan"), std::string::npos);
  EXPECT_EQ(text.find("inf,"), std::string::npos);
  EXPECT_TRUE(json::parse(text)["curve"].contains("branches"));
}

TEST(ResultFile, ExplainsNothingAndNamesRelaxations) {
  Problem problem = tailgate();
  problem.requirements.min_transmission_angle = radians(89);
  const json result = json::parse(write_result(problem, testing::answer_of(problem), false));
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
    const json result = json::parse(write_result(problem, testing::answer_of(problem), true));
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
  ASSERT_EQ(linkages->size(), testing::four_bars(solved_tailgate()).linkages.size());
  for (std::size_t i = 0; i < linkages->size(); ++i) {
    const StoredLinkage& linkage = linkages.value()[i];
    const FourBar& wanted = testing::four_bars(solved_tailgate()).linkages[i].four_bar;
    EXPECT_EQ(linkage.title, "Tailgate hinge");
    EXPECT_EQ(linkage.length_unit, "mm");
    ASSERT_EQ(linkage.poses.size(), 4u);
    EXPECT_EQ(linkage.poses[2].pose.angle, motion(tailgate()).poses[2].pose.angle);
    EXPECT_LT(std::abs(linkage.four_bar.input_fixed - wanted.input_fixed), 1e-9);
    EXPECT_LT(std::abs(linkage.four_bar.output_moving - wanted.output_moving), 1e-9);
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
  const std::string text = write_result(problem, testing::answer_of(problem), true);
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

const json& result_of(const testing::Solved& solved) {
  static std::map<const testing::Solved*, json> results;
  const auto [place, is_new] = results.try_emplace(&solved);
  if (is_new) place->second = json::parse(write_result(solved.problem, solved.answer, true));
  return place->second;
}

TEST(ResultFile, OfThreePositionsHasNoCurveButDirections) {
  const testing::Solved& latch = testing::three_positions();
  const json& result = result_of(latch);
  EXPECT_TRUE(result["curve"].is_null());
  EXPECT_EQ(result["pattern"], "P-P-P");
  EXPECT_EQ(result["dyads"].size() + result["pairs"].size() + result["freed"].size(), 0u);
  ASSERT_EQ(result["region"]["axes"].size(), 2u);
  for (const auto side : {Side::input, Side::output}) {
    const bool is_input = side == Side::input;
    const json& axis = result["region"]["axes"][is_input ? 0 : 1];
    EXPECT_EQ(axis["quantity"], "side_direction");
    EXPECT_EQ(axis["unit"], "deg");
    EXPECT_EQ(axis["branches"][1], (json{{"name", "sheet_2"}, {"from", 1}, {"to", 2}}));
    const json& coordinates = result["region"][is_input ? "input_coordinate" : "output_coordinate"];
    ASSERT_EQ(axis["values"].size(), coordinates.size());
    for (std::size_t i = 0; i < coordinates.size(); ++i)
      EXPECT_EQ(axis["values"][i].get<double>(),
                testing::four_bars(latch.answer).given.family->axis_value(side, coordinates[i].get<double>()));
  }
  ASSERT_GT(result["linkages"].size(), 0u);
  for (const json& linkage : result["linkages"]) {
    EXPECT_NEAR(linkage["lengths"]["input"].get<double>(), 18, 1e-9);
    EXPECT_NEAR(linkage["lengths"]["output"].get<double>(), 24, 1e-9);
    EXPECT_FALSE(linkage.contains("poses")) << "they are the task's";
    EXPECT_FALSE(linkage.contains("reason"));
  }
}

TEST(ResultFile, OfThreePositionsAtAnAngleHasLengths) {
  const Problem problem = testing::problem_from(R"({"linkwright": 1, "length_unit": "in", "options":
    {"region_samples": 40, "best": 2}, "task": {"kind": "motion", "mechanism": "four_bar", "poses": [
    {"x": 0, "y": 0, "theta_deg": 0}, {"x": 50, "y": 30, "theta_deg": 30}, {"x": 60, "y": 90, "theta_deg": 80}],
    "given": {"side_angle_deg": 60, "directed": true, "input_length": 80}}})");
  const json result = json::parse(write_result(problem, testing::answer_of(problem), false));
  const json& axis = result["region"]["axes"][1];
  EXPECT_EQ(axis["quantity"], "side_length");
  EXPECT_EQ(axis["unit"], "in");
  EXPECT_EQ(axis["values"].size(), 40u);
  EXPECT_TRUE(result["curve"].is_null());
}

TEST(ResultFile, OfAnInstantCentreHasItsCurve) {
  const Problem airtight = testing::example("airtight_hatch.json", 40);
  const json result = json::parse(write_result(airtight, testing::answer_of(airtight), false));
  EXPECT_EQ(result["pattern"], "P-P-P");
  EXPECT_TRUE(result["curve"]["kind"].is_string());
  EXPECT_EQ(result["region"]["axes"][0]["quantity"], "curve_coordinate");
  EXPECT_FALSE(result["region"]["axes"][0].contains("values"));
}

TEST(ResultFile, OfFivePositionsHasItsDyadsAndEveryPair) {
  const testing::Solved& gear = testing::five_positions();
  const json& result = result_of(gear);
  EXPECT_TRUE(result["curve"].is_null());
  ASSERT_EQ(result["dyads"].size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    const json& dyad = result["dyads"][i];
    const BurmesterPoint& point = testing::four_bars(gear.answer).given.points[i];
    EXPECT_EQ(dyad["multiplicity"], 1);
    EXPECT_EQ(dyad["condition"].get<double>(), point.condition);
    EXPECT_EQ(dyad["residual"].get<double>(), point.residual);
    EXPECT_EQ(dyad["coordinate"].get<double>(), static_cast<double>(i) + 0.5);
    EXPECT_EQ(dyad["circle_homogeneous"][0].get<double>(),
              testing::four_bars(gear.answer).given.frame().to_user(point.dyad).circle.w);
  }
  ASSERT_EQ(result["pairs"].size(), 6u);
  EXPECT_EQ(result["region"]["samples"], 4);
  EXPECT_EQ(result["region"]["axes"][0]["quantity"], "burmester_point");
  EXPECT_EQ(result["region"]["axes"][1]["branches"].size(), 4u);
  EXPECT_EQ(decoded(result["region"]["type"]).size(), 16u);
  int with_defect = 0;
  for (const json& pair : result["pairs"]) {
    EXPECT_TRUE(pair["verified_by_driving"].get<bool>());
    const bool has_defect = pair["defects"]["branch"].get<bool>() || pair["defects"]["order"].get<bool>();
    EXPECT_EQ(pair.contains("reason"), has_defect);
    with_defect += has_defect ? 1 : 0;
    if (has_defect) {
      EXPECT_THAT(pair["reason"].get<std::string>(), HasSubstr("defect: "));
    }
  }
  EXPECT_GT(with_defect, 0);
  EXPECT_EQ(result["freed"].size(), 0u) << "there are linkages";
}

TEST(ResultFile, OfFivePositionsWithoutAnswerNamesTheWaysOut) {
  const testing::Solved& none = testing::five_without_answer();
  const json& result = result_of(none);
  EXPECT_EQ(result["linkages"].size(), 0u);
  ASSERT_EQ(result["freed"].size(), 5u);
  double last = 0;
  int open = 0;
  for (const json& way : result["freed"]) {
    const int pose = way["pose"];
    EXPECT_GE(pose, 1);
    EXPECT_LE(pose, 5);
    EXPECT_NE(way["linkage"].is_null(), way["reason"].is_null());
    EXPECT_EQ(way["linkage"].is_null(), way["miss"].is_null());
    if (way["linkage"].is_null()) continue;
    ++open;
    const double distance = way["miss"]["distance"], angle = radians(way["miss"]["angle_deg"].get<double>());
    const double combined = way["miss"]["combined"], size = result["characteristic_length"];
    EXPECT_NEAR(combined, std::hypot(distance, size * angle), 1e-9 * combined);
    EXPECT_GE(combined, last);
    last = combined;
    // The linkage brings along the poses that it passes, and reads back with them.
    json poses = result["problem"]["task"]["poses"];
    poses.erase(static_cast<std::size_t>(pose - 1));
    EXPECT_EQ(way["linkage"]["poses"], poses);
    const auto read = read_linkage(way["linkage"].dump());
    ASSERT_TRUE(read.ok());
    EXPECT_EQ(read->poses.size(), 4u);
  }
  EXPECT_GT(open, 0);
}

TEST(ResultFile, OfAFreedPositionSaysWhatIsMissed) {
  Problem problem = testing::five_without_answer().problem;
  motion(problem).relaxed = 0;
  problem.options.region_samples = 80;
  const Answer answer = testing::answer_of(problem);
  const std::string text = write_result(problem, answer, false);
  const json result = json::parse(text);
  EXPECT_EQ(result["problem"]["task"]["freed_pose"], 1);
  EXPECT_TRUE(result["curve"]["kind"].is_string());
  ASSERT_GT(result["linkages"].size(), 0u);
  EXPECT_EQ(result["linkages"][0]["miss"]["distance"].get<double>(),
            testing::four_bars(answer).linkages[0].pose_error->distance);
  const auto linkages = read_result_linkages(text);
  ASSERT_TRUE(linkages.ok());
  ASSERT_EQ(linkages.value()[0].poses.size(), 4u) << "not the freed one, though the problem has it";
  EXPECT_EQ(linkages.value()[0].poses[0].pose.origin, motion(problem).poses[1].pose.origin);
}

TEST(ResultFile, OfAFunctionTellsItsErrors) {
  const testing::Solved& sine = testing::function();
  const json& result = result_of(sine);
  EXPECT_TRUE(result["curve"]["kind"].is_string());
  EXPECT_EQ(result["region"]["axes"][1]["quantity"], "nothing");
  EXPECT_EQ(result["region"]["output_coordinate"].size(), 1u);
  ASSERT_GT(result["linkages"].size(), 0u);
  for (std::size_t i = 0; i < result["linkages"].size(); ++i) {
    const json& linkage = result["linkages"][i];
    const FunctionError& error = *testing::four_bars(sine.answer).linkages[i].function;
    EXPECT_TRUE(linkage["verified_by_driving"].get<bool>());
    EXPECT_LT(linkage["precision_error_deg"].get<double>(), 1e-9);
    EXPECT_EQ(linkage["errors_at_pairs_deg"].size(), 4u);
    const double largest = linkage["max_structural_error_deg"];
    EXPECT_EQ(largest, degrees(*error.max_structural_error));
    const json& curve = linkage["error_curve"];
    ASSERT_EQ(curve["input_deg"].size(), error.samples.size());
    for (std::size_t k = 0; k < error.samples.size(); ++k) {
      EXPECT_EQ(curve["wanted_output_deg"][k].get<double>(), degrees(error.samples[k].wanted));
      EXPECT_LE(std::abs(curve["error_deg"][k].get<double>()), largest * (1 + 1e-9));
    }
    EXPECT_EQ(linkage["unreached_deg"], json::array());
  }
}

TEST(ResultFile, OfAFunctionSaysWhatIsNotReached) {
  const Problem square = testing::problem_from(R"({"linkwright": 1, "options": {"region_samples": 100}, "task":
    {"kind": "function", "mechanism": "four_bar", "function": {"expression": "x^2", "x": [0, 1],
    "input_range_deg": [0, 90], "output_range_deg": [0, 90], "points": 4}}})");
  const std::string text = write_result(square, testing::answer_of(square), true);
  EXPECT_EQ(text.find("nan"), std::string::npos);
  int short_of_it = 0;
  const json result = json::parse(text);
  for (const json& linkage : result["linkages"]) {
    const json& errors = linkage["error_curve"]["error_deg"];
    const bool has_gap = std::any_of(errors.begin(), errors.end(), [](const json& e) { return e.is_null(); });
    EXPECT_EQ(has_gap, !linkage["unreached_deg"].empty());
    short_of_it += has_gap ? 1 : 0;
  }
  EXPECT_GT(short_of_it, 0);
}

TEST(ResultFile, OfPairsAloneHasNoStructuralError) {
  const Problem pairs = testing::problem_from(R"({"linkwright": 1, "options": {"region_samples": 24}, "task":
    {"kind": "function", "mechanism": "four_bar", "pairs": [{"input_deg": 0, "output_deg": 0},
    {"input_deg": 30, "output_deg": 10}, {"input_deg": 50, "output_deg": 30}, {"input_deg": 70, "output_deg": 70}],
    "free": {"number": "pair_output", "pair": 3, "range": [25, 35]}}})");
  const json result = json::parse(write_result(pairs, testing::answer_of(pairs), false));
  EXPECT_EQ(result["region"]["axes"][1]["quantity"], "pair_output");
  ASSERT_GT(result["linkages"].size(), 0u);
  for (const json& linkage : result["linkages"]) {
    EXPECT_TRUE(linkage["max_structural_error_deg"].is_null());
    EXPECT_FALSE(linkage.contains("error_curve"));
    EXPECT_LT(linkage["precision_error_deg"].get<double>(), 1e-6);
    EXPECT_GE(linkage["free_value"].get<double>(), 25);
    EXPECT_LE(linkage["free_value"].get<double>(), 35);
  }
}

TEST(ResultFile, LinkagesOfFunctionsKeepTheirCouplersPoses) {
  const testing::Solved& sine = testing::function();
  const auto linkages = read_result_linkages(write_result(sine.problem, sine.answer, false));
  ASSERT_TRUE(linkages.ok());
  ASSERT_EQ(linkages->size(), testing::four_bars(sine.answer).linkages.size());
  for (std::size_t i = 0; i < linkages->size(); ++i) {
    const FourBarSolution& found = testing::four_bars(sine.answer).linkages[i];
    const auto poses = testing::four_bars(sine.answer)
                           .given.family->user_poses({found.input.coordinate, found.output.coordinate}, found.four_bar);
    ASSERT_EQ(linkages.value()[i].poses.size(), poses.size());
    for (std::size_t k = 0; k < poses.size(); ++k) {
      EXPECT_EQ(linkages.value()[i].poses[k].pose.origin, poses[k].pose.origin);
      EXPECT_DOUBLE_EQ(linkages.value()[i].poses[k].pose.angle, poses[k].pose.angle) << "through degrees";
    }
  }
}

TEST(ResultFile, OfFivePrecisionPointsListsEveryLinkage) {
  const Problem log = testing::example("log_generator.json", 40);
  const json result = json::parse(write_result(log, testing::answer_of(log), true));
  EXPECT_TRUE(result["curve"].is_null());
  EXPECT_EQ(result["dyads"].size(), 0u);
  EXPECT_EQ(result["pairs"].size(), result["region"]["input_coordinate"].size());
  ASSERT_GT(result["pairs"].size(), 0u);
  EXPECT_TRUE(result["pairs"][0].contains("precision_error_deg"));
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
      {R"({"linkages": [{"mechanism": "slider_crank"}]})", "this is a \"slider_crank\""},
      {R"({"linkages": [{"input": {"center_point": [0, 0], "circle_point": [0, 2]}, "output":
        {"center_point": [4, 0], "circle_point": [3, 3.5]}, "poses": [1, 2, 3, 4, 5, 6]}]})",
       "at most 5 poses"},
      {R"({"linkages": [], "problem": {"task": {"poses": [1, 2, 3, 4, 5, 6]}}})", "at most 5 poses"},
  };
  for (const auto& [text, reason] : refused) {
    const auto linkages = read_result_linkages(text);
    ASSERT_FALSE(linkages.ok()) << text;
    EXPECT_THAT(linkages.errors()[0].message, HasSubstr(reason));
  }
}

}  // namespace
}  // namespace linkwright::result_file_test
