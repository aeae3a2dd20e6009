#include "linkwright/files/six_bar_file.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sstream>

#include "drawing/dxf_drawing.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/drawing/svg_drawing.hpp"
#include "linkwright/files/result_file.hpp"
#include "support/file_support.hpp"

namespace linkwright::six_bar_file_test {
namespace {

Problem example(const std::string& name) {
  auto problem = read_problem(testing::text_of(std::filesystem::path(LINKWRIGHT_EXAMPLES_DIR) / (name + ".json")));
  EXPECT_TRUE(problem.ok());
  return *problem;
}

/// examples/loader_bucket_chain.json on a small map.
struct Solved {
  Problem problem = example("loader_bucket_chain");
  Answer answer;
  Solved() {
    problem.options.region_samples = 60;
    problem.options.best = 2;
    auto found = solve(problem);
    EXPECT_TRUE(found.ok());
    answer = std::move(*found);
    EXPECT_EQ(six_bars().size(), 2u);
  }
  [[nodiscard]] const std::vector<SixBarSolution>& six_bars() const { return std::get<SixBarAnswer>(answer).linkages; }
};
const Solved& solved() {
  static const Solved once;
  return once;
}

StoredSixBar stored(std::size_t index = 0) {
  const auto linkages = read_any_result_linkages(write_result(solved().problem, solved().answer, false));
  EXPECT_TRUE(linkages.ok());
  return std::get<StoredSixBar>(linkages.value().at(index));
}

bool same_hinges(const SixBar& one, const SixBar& other) {
  for (std::size_t joint = 0; joint < SixBar::joint_count; ++joint)
    if (one.joints[joint].point != other.joints[joint].point || one.joints[joint].bodies != other.joints[joint].bodies)
      return false;
  return true;
}

/// A crank of 1 among long links.
StoredSixBar crank() {
  StoredSixBar made;
  made.row = *six_bar_row({BodyPair{0, 2}, BodyPair{0, 3}});
  made.six_bar = SixBar::of({Point{0, 0}, Point{1, 0}, Point{3, 2}}, made.row.added, {Point{5, 0}, Point{4, 3}},
                            {Point{6, -4}, Point{8, 3}});
  return made;
}

std::vector<std::vector<std::string>> cells(const std::string& table) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    rows.emplace_back();
    std::istringstream row(line + ",");
    for (std::string cell; std::getline(row, cell, ',');) rows.back().push_back(cell);
  }
  return rows;
}

TEST(SixBarFile, ResultReadsBackBitIdentical) {
  for (std::size_t i = 0; i < 2; ++i) {
    const StoredSixBar read = stored(i);
    const SixBarSolution& found = solved().six_bars()[i];
    EXPECT_TRUE(same_hinges(read.six_bar, found.member.six_bar));
    EXPECT_EQ(read.row.topology, SixBarTopology::watt_1);
    EXPECT_EQ(read.title, solved().problem.title);
    EXPECT_EQ(read.length_unit, "mm");
    EXPECT_EQ(read.poses.size(), 4u);
    EXPECT_EQ(read.poses[1].pose.angle, std::get<SixBarTask>(solved().problem.task).poses[1].pose.angle);
    EXPECT_EQ(read.assembly_mode, (std::array{1, 1, 1, 1}));
  }
}

TEST(SixBarFile, ResultSaysWhatWasFound) {
  const auto result = nlohmann::json::parse(write_result(solved().problem, solved().answer, true));
  EXPECT_TRUE(result["curve"].is_null());
  EXPECT_FALSE(result.contains("search"));
  EXPECT_EQ(result["region"]["samples"], 15);
  EXPECT_EQ(result["region"]["axes"][0]["name"], "link 4 between 0 and 2, coordinate on its curve");
  EXPECT_EQ(result["region"]["counts"]["defect_free"], findings(solved().answer).counts.defect_free);
  EXPECT_TRUE(result["region"].contains("type"));
  const auto& linkage = result["linkages"][0];
  const SixBarSolution& found = solved().six_bars()[0];
  EXPECT_EQ(linkage["topology"], "watt_1");
  EXPECT_EQ(linkage["added"][1]["between"], "1-3");
  EXPECT_EQ(linkage["added"][1]["coordinate"].get<double>(), found.member.coordinates[1]);
  EXPECT_EQ(linkage["lengths"].size(), 10u);
  EXPECT_EQ(linkage["lengths"]["1:a-b"].get<double>(), found.lengths[1].length);
  EXPECT_EQ(linkage["joints"]["z5"][0].get<double>(), found.member.six_bar.at(SixBar::z5).real());
  EXPECT_EQ(linkage["verified_by_driving"], true);
  EXPECT_NEAR(linkage["min_transmission_angle_deg"].get<double>(), degrees(found.rating.min_transmission_angle()),
              1e-12);
  const auto& dyads = linkage["min_transmission_angles_of_dyads_deg"];
  EXPECT_NEAR(std::min(dyads[0].get<double>(), dyads[1].get<double>()), linkage["min_transmission_angle_deg"], 1e-9);
}

std::size_t outlines(const std::string& picture) {
  std::size_t count = 0;
  for (auto at = picture.find("stroke-opacity=\"0.45\""); at != std::string::npos;
       at = picture.find("stroke-opacity=\"0.45\"", at + 1))
    ++count;
  return count;
}

/// A link 5 that depends on link 4: another axis, and another way to find its positions.
TEST(SixBarFile, ASixBarAtAPickedPlaceSaysWhatItFails) {
  Problem problem = solved().problem;
  const auto chain = ChainFamily::of(std::get<SixBarTask>(problem.task));
  problem.options.at = chain->point_of(solved().six_bars()[0].member);
  const auto there = nlohmann::json::parse(write_result(problem, testing::answer_of(problem), false));
  ASSERT_EQ(there["linkages"].size(), 1u) << there["reason"];
  EXPECT_EQ(there["linkages"][0]["meets_requirements"], true);
  problem.requirements.max_length = 1e-3;
  problem.requirements.min_length = 0;
  const auto too_long = nlohmann::json::parse(write_result(problem, testing::answer_of(problem), false));
  EXPECT_EQ(too_long["linkages"][0]["fails"], nlohmann::json::array({"max_length"}));
}

TEST(SixBarFile, ALinkOnALinkIsWrittenAndDrawn) {
  for (const BodyPair fifth : {BodyPair{4, 3}, BodyPair{3, 4}}) {
    Problem problem = solved().problem;
    std::get<SixBarTask>(problem.task).added = {BodyPair{0, 2}, fifth};
    problem.requirements = {};
    problem.requirements.no_defects = false;
    problem.options.region_samples = 32;
    problem.options.best = 1;
    const auto solution = solve(problem);
    ASSERT_TRUE(solution.ok());
    ASSERT_EQ(linkage_count(*solution), 1u);
    const std::string result = write_result(problem, *solution, false);
    const auto axis = nlohmann::json::parse(result)["region"]["axes"][1];
    EXPECT_EQ(axis["quantity"], "curve_share");
    EXPECT_EQ(axis["branches"][0]["to"], 1.0);
    EXPECT_NE(draw_answer(problem, *solution).find("Link 5: share of its curve"), std::string::npos);
    const auto linkages = read_any_result_linkages(result);
    ASSERT_TRUE(linkages.ok());
    EXPECT_EQ(outlines(draw_linkage(std::get<StoredSixBar>(linkages->front()))), 3u);
  }
}

TEST(SixBarFile, SearchIsReportedEvenWithoutAFind) {
  Problem problem = example("loader_bucket");
  problem.options.effort = 100;
  const auto solution = solve(problem);
  ASSERT_TRUE(solution.ok());
  const auto result = nlohmann::json::parse(write_result(problem, *solution, true));
  EXPECT_TRUE(result["region"].is_null());
  EXPECT_EQ(result["search"]["chains_tried"], 100);
  EXPECT_EQ(result["search"]["effort"], 100);
  EXPECT_EQ(result["search"]["interrupted"], false);
  EXPECT_TRUE(result["linkages"].empty());
  const std::string picture = draw_answer(problem, *solution);
  EXPECT_NE(picture.find("Nothing found"), std::string::npos);
  EXPECT_EQ(picture.find("nan"), std::string::npos);
}

TEST(SixBarFile, LinkageReadsBackBitIdentical) {
  StoredSixBar without_record = stored();
  without_record.record.clear();
  for (const StoredSixBar& linkage : {stored(), without_record, crank()}) {
    const std::string text = write_linkage(linkage);
    const auto read = read_any_linkage(text);
    ASSERT_TRUE(read.ok()) << text;
    const auto& again = std::get<StoredSixBar>(*read);
    EXPECT_TRUE(same_hinges(again.six_bar, linkage.six_bar));
    EXPECT_EQ(again.title, linkage.title);
    EXPECT_EQ(again.assembly_mode, linkage.assembly_mode);
    EXPECT_EQ(again.poses.size(), linkage.poses.size());
    const auto twice = read_any_linkage(write_linkage(again));
    ASSERT_TRUE(twice.ok());
    EXPECT_EQ(write_linkage(std::get<StoredSixBar>(*twice)), write_linkage(again));
  }
}

TEST(SixBarFile, BodiesMayBeNamedInEitherOrder) {
  const auto read = read_any_linkage(R"({"mechanism": "six_bar", "chain": {"a": [0, 0], "b": [1, 0], "d": [3, 2]},
    "added": [{"between": "2-0", "points": [[4, 3], [5, 0]]}, {"between": "0-3", "points": [[6, -4], [8, 3]]}]})");
  ASSERT_TRUE(read.ok());
  EXPECT_TRUE(same_hinges(std::get<StoredSixBar>(*read).six_bar, crank().six_bar));
}

TEST(SixBarFile, MistakesSayWhereAndWhat) {
  struct Bad {
    std::string chain, added, place, words;
  };
  const std::string chain = R"({"a": [0, 0], "b": [1, 0], "d": [3, 2]})";
  const std::string first = R"({"between": "0-2", "points": [[5, 0], [4, 3]]})";
  const std::string second = R"({"between": "0-3", "points": [[6, -4], [8, 3]]})";
  const std::vector<Bad> table = {
      {"null", first + "," + second, "chain", "object"},
      {R"({"a": [0, 0], "b": [1, 0]})", first + "," + second, "chain.d", "missing"},
      {chain, first, "added", "1 added links"},
      {chain, "3, 4", "added[0]", "object"},
      {chain, first + R"(, {"between": "7-9", "points": [[6, -4], [8, 3]]})", "added[1].between",
       "names no two bodies"},
      {chain, first + R"(, {"between": "0\n3\u001b[31m", "points": [[6, -4], [8, 3]]})", "added[1].between",
       "names no two bodies"},
      {chain, first + R"(, {"between": "0-3", "points": [[6, -4]]})", "added[1].points", "1 hinges"},
      {chain, first + R"(, {"between": "0-3", "points": [[6, -4], [6, -4]]})", "", "coincide"},
      {chain, first + R"(, {"between": "0-3", "points": [[6, -4], [6e13, 3]]})", "", "lie between"},
      {chain, first + R"(, {"between": "2-3", "points": [[6, -4], [8, 3]]})", "", "do not make a six-bar"},
  };
  for (const Bad& bad : table) {
    const auto read =
        read_any_linkage(R"({"mechanism": "six_bar", "chain": )" + bad.chain + R"(, "added": [)" + bad.added + "]}");
    ASSERT_FALSE(read.ok()) << bad.words;
    EXPECT_EQ(read.errors()[0].place, bad.place) << read.errors()[0].message;
    EXPECT_NE(read.errors()[0].message.find(bad.words), std::string::npos) << read.errors()[0].message;
    EXPECT_EQ(read.errors()[0].message.find_first_of("\n\x1b"), std::string::npos) << "one line, text only";
  }
}

TEST(SixBarFile, ReadersOfFourBarsRefuseIt) {
  const auto linkage = read_linkage(write_linkage(crank()));
  ASSERT_FALSE(linkage.ok());
  EXPECT_EQ(linkage.errors()[0].code, "not_a_four_bar");
  EXPECT_FALSE(read_result_linkages(write_result(solved().problem, solved().answer, false)).ok());
}

TEST(SixBarFile, TableFollowsTheTravel) {
  const StoredSixBar linkage = stored();
  const auto rows = cells(motion_table(tabulated_motion(linkage.six_bar, framed_poses(linkage))));
  ASSERT_GT(rows.size(), 60u);
  constexpr std::size_t position = 19;
  EXPECT_EQ(rows[0].size(), 22u);
  EXPECT_EQ(rows[0][position], "position");
  EXPECT_EQ(rows[0].back(), "orientation_error_deg");
  std::string met;
  double before = -1;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    ASSERT_EQ(rows[i].size(), 22u);
    const auto number = [&](std::size_t column) { return std::stod(rows[i][column]); };
    EXPECT_GT(number(0), before);
    EXPECT_LE(number(0) - std::max(before, 0.0), 1.0001);
    before = number(0);
    for (const SixBarLength& length : linkage.six_bar.lengths()) {
      const auto at = [&](std::size_t joint) { return Point{number(1 + 2 * joint), number(2 + 2 * joint)}; };
      EXPECT_NEAR(std::abs(at(length.joints[1]) - at(length.joints[0])) / length.length, 1, 1e-9);
    }
    met += rows[i][position];
    if (rows[i][position].empty()) continue;
    const Pose& pose = linkage.poses[std::stoul(rows[i][position]) - 1].pose;
    EXPECT_LT(number(position + 1), 1e-9 * (1 + std::abs(pose.origin)));
    EXPECT_NEAR(number(15), pose.origin.real(), 1e-6);
    EXPECT_NEAR(number(16), pose.origin.imag(), 1e-6);
    EXPECT_NEAR(number(17), degrees(pose.angle), 1e-9);
  }
  EXPECT_EQ(met, "1234");
  EXPECT_NEAR(before, degrees(solved().six_bars()[0].rating.drive.sweep), 1e-6);
}

TEST(SixBarFile, WithoutPosesTheTableIsTheWholeMotion) {
  const SixBarMotion motion = tabulated_motion(crank().six_bar, framed_poses(crank()));
  EXPECT_TRUE(motion.full_turn);
  EXPECT_GE(motion.states.size(), 361u);
  EXPECT_EQ(motion.states.front().place.body.origin, crank().six_bar.at(SixBar::d));
}

TEST(SixBarFile, AnalysisKnowsTravelAndRange) {
  const StoredSixBarAnalysis analysis = analyze(stored());
  const SixBarRating& rating = solved().six_bars()[0].rating;
  EXPECT_NEAR(std::asin(analysis.travel.min_sine), rating.min_transmission_angle(), radians(0.005));
  EXPECT_LE(analysis.motion.states.front().place.turn, 0);
  EXPECT_GE(analysis.motion.states.back().place.turn, rating.drive.sweep);
  const auto json = nlohmann::json::parse(write_analysis(analysis));
  EXPECT_EQ(json["type"], name(rating.shape.type));
  EXPECT_EQ(json["driver_is_crank"], false);
  EXPECT_EQ(json["motion"]["z5"].size(), analysis.motion.states.size());
  EXPECT_EQ(json["motion"]["position"][0], nullptr);
  const auto alone = nlohmann::json::parse(write_analysis(analyze(crank())));
  EXPECT_EQ(alone["driver_is_crank"], true);
  EXPECT_TRUE(alone["min_transmission_angle_deg"].is_null());
  EXPECT_GT(alone["min_transmission_angle_whole_motion_deg"].get<double>(), 1);
}

TEST(SixBarFile, DrawsBodiesPositionsAndNames) {
  const std::string solution = draw_answer(solved().problem, solved().answer);
  for (const std::string& picture : {solution, draw_linkage(stored()), draw_linkage(crank())}) {
    for (const char* name :
         {">a</text>", ">b</text>", ">d</text>", ">c4</text>", ">z4</text>", ">c5</text>", ">z5</text>"})
      EXPECT_NE(picture.find(name), std::string::npos) << name;
    EXPECT_EQ(picture.find("nan"), std::string::npos);
    EXPECT_LT(picture.size(), 300'000u);
  }
  EXPECT_NE(solution.find("every point is one six-bar"), std::string::npos);
  EXPECT_NE(solution.find("Watt I by 0-2 and 1-3"), std::string::npos);
}

TEST(SixBarFile, PositionsThatItDoesNotReachAreNotDrawn) {
  StoredSixBar lost = stored();
  EXPECT_EQ(outlines(draw_linkage(lost)), 3u);
  lost.poses[2].pose.origin += 1;
  EXPECT_EQ(outlines(draw_linkage(lost)), 2u);
  lost.poses.pop_back();
  EXPECT_EQ(outlines(draw_linkage(lost)), 0u);
}

TEST(SixBarFile, DxfHasALayerABody) {
  const std::string dxf = draw_dxf(stored());
  for (const char* layer : {"GROUND", "BODY_1", "BODY_2", "BODY_3", "BODY_4", "BODY_5", "POSITIONS", "BODY_PATH"})
    EXPECT_NE(dxf.find(layer), std::string::npos) << layer;
  EXPECT_EQ(dxf.find("nan"), std::string::npos);
}

}  // namespace
}  // namespace linkwright::six_bar_file_test
