// The session asked about every kind of task: what the page is told agrees with what solve() says.

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <span>

#include "linkwright/core/angle.hpp"
#include "linkwright/files/problem_file.hpp"
#include "linkwright/files/six_bar_file.hpp"
#include "linkwright/synthesis/solve.hpp"
#include "mechanism/transmission_angle.hpp"
#include "session.hpp"

namespace linkwright::wasm::session_kinds_test {
namespace {

using nlohmann::json;

constexpr std::string_view three_poses =
    R"({"linkwright": 1, "task": {"kind": "motion", "mechanism": "four_bar", "poses": [{"x": 0, "y": 0, "theta_deg": 0},
    {"x": 50, "y": 30, "theta_deg": 30}, {"x": 60, "y": 90, "theta_deg": 80}], "given": {"side_lengths": [80, 60]}}})";
constexpr std::string_view five_poses =
    R"({"linkwright": 1, "task": {"kind": "motion", "mechanism": "four_bar", "poses": [
    {"x": 10, "y": 9, "theta_deg": 5}, {"x": 9, "y": 30, "theta_deg": 35}, {"x": 18, "y": 32, "theta_deg": 5},
    {"x": 22, "y": 25, "theta_deg": -45}, {"x": 13, "y": 22, "theta_deg": -70}]}})";
constexpr std::string_view square =
    R"({"linkwright": 1, "task": {"kind": "function", "mechanism": "four_bar", "function": {"expression": "x^2",
    "x": [0, 1], "input_range_deg": [0, 90], "output_range_deg": [0, 90], "points": 4}}})";
constexpr std::string_view loader =
    R"({"linkwright": 1, "task": {"kind": "motion", "mechanism": "six_bar", "poses": [{"x": 0, "y": 0, "theta_deg": 0},
    {"x": 0, "y": 300, "theta_deg": 40}, {"x": 200, "y": 1000, "theta_deg": 45}, {"x": 400, "y": 1500, "theta_deg": -30}],
    "chain": {"a": [-2160.6, 1069.8], "b": [288.6, 1029.9], "d": [-19.3, 251.8]}, "added": ["0-2", "1-3"]}})";

std::int64_t meeting_requirements(std::string_view text) {
  const auto problem = read_problem(text);
  const auto answer = solve(*problem);
  return findings(*answer).meeting_requirements;
}

/// A session that holds a problem, and its map.
struct Explored {
  explicit Explored(std::string_view text, int samples = 400) {
    EXPECT_TRUE(session.set_problem(text)) << session.mistakes();
    request.samples = samples;
    reply = session.explore(request);
    task = json::parse(reply.task);
  }
  [[nodiscard]] std::span<const double> input_tau() const { return reply.map->region.input_coordinates(); }
  [[nodiscard]] std::span<const double> output_tau() const { return reply.map->region.output_coordinates(); }
  [[nodiscard]] json linkage(double input, double output) {
    return json::parse(session.linkage({input, output}).linkage);
  }
  /// A cell that meets everything.
  [[nodiscard]] std::array<double, 2> passing() const {
    const auto& fails = reply.map->fails;
    const auto found = static_cast<std::size_t>(std::find(fails.begin(), fails.end(), 0) - fails.begin());
    const std::size_t columns = output_tau().size();
    return {input_tau()[found / columns], output_tau()[found % columns]};
  }
  PageSession session;
  MapRequest request;
  ExploreReply reply;
  json task;
};

void expect_linkage_without_defects(Explored& explored, std::size_t width) {
  ASSERT_NE(explored.reply.map, nullptr);
  ASSERT_GT(explored.reply.map->census.meeting, 0);
  const auto [input, output] = explored.passing();
  const LinkageReply reply = explored.session.linkage({input, output});
  const json linkage = json::parse(reply.linkage);
  EXPECT_EQ(linkage["fails"], 0);
  EXPECT_FALSE(linkage["record"]["defects"]["branch"].get<bool>());
  ASSERT_FALSE(linkage["travel"].is_null());
  EXPECT_EQ(reply.states.size() % width, 0u);
  for (const json& tick : linkage["travel"]["ticks"]) EXPECT_TRUE(tick["reached"].get<bool>());
  EXPECT_TRUE(json::parse(explored.session.verify({input, output}))["verified"].get<bool>());
}

constexpr std::string_view spherical_square =
    R"({"linkwright": 1, "task": {"kind": "function", "mechanism": "spherical_four_bar", "ground_angle_deg": 70,
    "function": {"expression": "x^2", "x": [0, 1], "input_range_deg": [0, 60], "output_range_deg": [0, 80]}}})";

TEST(SessionOfASphericalFunction, TellsTheFunctionAndWhatALinkageMakesOfIt) {
  Explored explored(spherical_square);
  EXPECT_EQ(explored.task["axes"]["output"]["quantity"], "nothing");
  EXPECT_FALSE(explored.task["symmetric"].get<bool>());
  EXPECT_EQ(explored.task["function"]["pairs"].size(), 4u);
  EXPECT_NE(explored.reply.output_curves, nullptr);
  EXPECT_EQ(explored.reply.map->census.meeting, meeting_requirements(spherical_square));
  expect_linkage_without_defects(explored, spherical_state_width);
  const auto [input, output] = explored.passing();
  const json linkage = explored.linkage(input, output);
  EXPECT_LT(linkage["record"]["precision_error_deg"].get<double>(), 1e-7);
  EXPECT_TRUE(linkage["record"]["max_structural_error_deg"].is_number());
}

TEST(SessionOfThreePoses, HasAMapOverTwoDirections) {
  Explored explored(three_poses);
  EXPECT_EQ(explored.task["axes"]["input"]["quantity"], "side_direction");
  EXPECT_FALSE(explored.task["symmetric"].get<bool>());
  EXPECT_EQ(explored.task["axes"]["input"]["branches"].size(), 2u);
  EXPECT_GT(explored.task["axes"]["output"]["ticks"].size(), 4u);
  EXPECT_NE(explored.reply.output_curves, nullptr);
  EXPECT_EQ(json::parse(explored.reply.census)["meeting"], meeting_requirements(three_poses));
  expect_linkage_without_defects(explored, state_width);
}

TEST(SessionOfFivePoses, HasABoard) {
  Explored explored(five_poses);
  EXPECT_EQ(explored.input_tau().size(), 4u);
  EXPECT_EQ(explored.reply.map->fails.size(), 16u);
  EXPECT_EQ(explored.reply.input_curves->coordinate.size(), 4u);
  EXPECT_EQ(explored.task["axes"]["input"]["quantity"], "burmester_point");
  EXPECT_EQ(json::parse(explored.reply.census)["pairs"], 12);
  expect_linkage_without_defects(explored, state_width);
}

TEST(SessionOfFivePoses, FreesOneOfThem) {
  json problem = json::parse(five_poses);
  problem["task"]["freed_pose"] = 3;
  Explored explored(problem.dump(), 100);
  explored.request.property = "pose_miss";
  explored.reply = explored.session.explore(explored.request);
  const auto& values = explored.reply.map->values;
  const auto& fails = explored.reply.map->fails;
  for (std::size_t cell = 0; cell < values.size(); ++cell)
    EXPECT_TRUE(fails[cell] == 0 ? values[cell] > 0 : values[cell] == 0);
  const auto [input, output] = explored.passing();
  const json linkage = explored.linkage(input, output);
  ASSERT_FALSE(linkage["record"]["miss"].is_null());
  const double distance = linkage["record"]["miss"]["distance"], angle = linkage["record"]["miss"]["angle_deg"];
  EXPECT_GT(std::hypot(distance, angle), 0);
  std::vector<int> positions;
  for (const json& tick : linkage["travel"]["ticks"]) positions.push_back(tick["position"]);
  EXPECT_EQ(positions, (std::vector<int>{1, 2, 4, 5}));
}

TEST(SessionOfFivePoses, CountsThePosesOfADefectAsTheTaskDoes) {
  json problem = json::parse(five_poses);
  problem["task"]["freed_pose"] = 2;
  Explored explored(problem.dump(), 60);
  const auto& map = explored.reply.map->region;
  int seen = 0;
  for (std::size_t row = 0; row < map.rows(); ++row)
    for (std::size_t column = 0; column < map.columns() && seen < 20; ++column) {
      if (map.defects()[map.index(row, column)] == 0) continue;
      const json reason = explored.linkage(explored.input_tau()[row], explored.output_tau()[column])["reason"];
      if (reason.is_null() || reason["code"] != "order_defect") continue;
      std::string order = reason["values"]["order"];
      std::sort(order.begin(), order.end());
      EXPECT_EQ(order, "---1345");
      ++seen;
    }
  EXPECT_GT(seen, 0);
}

TEST(SessionOfAFunction, HasARibbon) {
  Explored explored(square);
  EXPECT_EQ(explored.output_tau().size(), 1u);
  EXPECT_EQ(explored.task["axes"]["output"]["quantity"], "nothing");
  EXPECT_GT(explored.reply.input_curves->coordinate.size(), 100u);
  EXPECT_EQ(json::parse(explored.reply.census)["meeting"], meeting_requirements(square));
  expect_linkage_without_defects(explored, state_width);
  const auto [input, output] = explored.passing();
  const LiveLinks live = explored.session.live({input, output});
  EXPECT_EQ(live.input.size(), explored.reply.input_curves->coordinate.size());
  EXPECT_EQ(live.output.size(), explored.reply.output_curves->coordinate.size());
  EXPECT_EQ(explored.reply.output_curves->coordinate, explored.reply.input_curves->coordinate);
}

TEST(SessionOfAFunction, TellsWhatIsWantedAndWhatIsGenerated) {
  json problem = json::parse(square);
  problem["options"]["objective"] = "structural_error";
  Explored explored(problem.dump());
  const json wanted = explored.task["function"];
  ASSERT_EQ(wanted["pairs"].size(), 4u);
  EXPECT_GT(wanted["curve"].size(), 50u);
  explored.request.property = "max_structural_error_deg";
  explored.reply = explored.session.explore(explored.request);
  const auto& values = explored.reply.map->values;
  const json best = json::parse(explored.session.best(1))["linkages"][0];
  const json generated = explored.linkage(best["tau"][0], best["tau"][1]);
  const json& record = generated["record"];
  const double error = record["max_structural_error_deg"];
  for (const float value : values) {
    if (value > 0) {
      EXPECT_LE(error, value * (1 + 1e-3));
    }
  }
  EXPECT_TRUE(generated["reaches_pairs"].get<bool>());
  EXPECT_TRUE(record["unreached_deg"].empty());
  for (std::size_t j = 0; j < 4; ++j) {
    EXPECT_NEAR(generated["pairs_deg"][j][0], wanted["pairs"][j][0], 1e-12);
    EXPECT_LT(std::abs(record["errors_at_pairs_deg"][j].get<double>()), 1e-6);
  }
  double worst = 0;
  for (const double there : record["error_curve"]["error_deg"]) worst = std::max(worst, std::abs(there));
  EXPECT_NEAR(worst, error, 0.01 * error);
}

TEST(SessionOfAFunction, ImprovesItsObjective) {
  json problem = json::parse(square);
  problem["options"]["objective"] = "structural_error";
  Explored explored(problem.dump());
  const std::array<double, 2> place = explored.passing();
  const auto error_at = [&](double tau) {
    const json record = explored.linkage(tau, place[1])["record"];
    return record["max_structural_error_deg"].get<double>();
  };
  const json improved = json::parse(explored.session.improve({place[0], place[1]}));
  if (improved["improved"].get<bool>()) {
    EXPECT_LT(error_at(improved["tau"][0]), error_at(place[0]));
  }
}

TEST(SessionOfAFunction, WithoutANameKnowsItsPairsOnly) {
  const json problem = json::parse(R"({"linkwright": 1, "task": {"kind": "function", "mechanism": "four_bar", "pairs": [
      {"input_deg": 0, "output_deg": 0}, {"input_deg": 20, "output_deg": 12}, {"input_deg": 40, "output_deg": 31},
      {"input_deg": 60, "output_deg": 60}], "free": {"number": "output_scale", "range": [0.5, 2]}}})");
  Explored explored(problem.dump(), 60);
  EXPECT_TRUE(explored.task["function"]["curve"].empty());
  EXPECT_EQ(explored.task["axes"]["output"]["quantity"], "output_scale");
  const auto [input, output] = explored.passing();
  const json generated = explored.linkage(input, output);
  EXPECT_TRUE(generated["record"]["max_structural_error_deg"].is_null());
  EXPECT_FALSE(generated["record"].contains("error_curve"));
  EXPECT_NE(generated["pairs_deg"][3][1].get<double>(), 60.0);  // as scaled
  EXPECT_FALSE(explored.session.exported({input, output}, "csv").empty());
}

TEST(SessionOfASixBar, HasAMapOverBothAddedLinks) {
  Explored explored(loader, 80);
  EXPECT_EQ(explored.reply.map->fails.size(), 400u);
  EXPECT_FALSE(explored.task["symmetric"].get<bool>());
  EXPECT_FALSE(explored.reply.input_curves->coordinate.empty());
  expect_linkage_without_defects(explored, six_bar_state_width);
  const auto [input, output] = explored.passing();
  const json linkage = explored.linkage(input, output);
  const json& record = linkage["record"];
  EXPECT_EQ(record["mechanism"], "six_bar");
  EXPECT_EQ(record["joints"].size(), 7u);
  EXPECT_EQ(record["lengths"].size(), 10u);
  EXPECT_EQ(record["added"][0]["points"][0], record["joints"]["c4"]);
  EXPECT_EQ(linkage["bodies"].size(), 6u);
  const LiveLinks live = explored.session.live({input, output});
  EXPECT_EQ(live.input.size(), explored.reply.input_curves->coordinate.size());
  EXPECT_GT(explored.session.trace({input, output}, {0, 0}).size(), 20u);
}

TEST(SessionOfASixBar, ImprovesTheOneInHand) {
  Explored explored(loader, 80);
  const auto [input, output] = explored.passing();
  const json better = json::parse(explored.session.improve({input, output}));
  ASSERT_TRUE(better["improved"]);
  const auto angle = [&](double first, double second) {
    return explored.linkage(first, second)["record"]["min_transmission_angle_deg"].get<double>();
  };
  EXPECT_GT(angle(better["tau"][0], better["tau"][1]), angle(input, output));
}

TEST(SessionOfASixBar, WritesEveryFormat) {
  Explored explored(loader, 80);
  const std::array<double, 2> place = explored.passing();
  const auto written = [&](std::string_view format) { return explored.session.exported({place[0], place[1]}, format); };
  EXPECT_NE(written("svg").find("<svg"), std::string::npos);
  EXPECT_NE(written("dxf").find("BODY_PATH"), std::string::npos);
  const std::string table = written("csv");
  EXPECT_GT(std::count(table.begin(), table.end(), '\n'), 20);
  const auto six_bar = read_any_linkage(written("json"));
  ASSERT_TRUE(six_bar.ok());
  const json result = json::parse(written("result"));
  EXPECT_EQ(result["linkages"][0]["added"][0]["coordinate"], place[0]);
  EXPECT_TRUE(result["linkages"][0]["verified_by_driving"]);
  const Point z5 = std::get<StoredSixBar>(*six_bar).six_bar.at(SixBar::z5);
  EXPECT_EQ(result["linkages"][0]["joints"]["z5"], json({z5.real(), z5.imag()}));
}

TEST(SessionOfASixBar, WithoutAChainAsksForOne) {
  json problem = json::parse(loader);
  problem["task"].erase("chain");
  problem["options"] = {{"box", {{"x", {-2600, 400}}, {"y", {0, 2400}}}}, {"effort", 400}, {"seed", 13}};
  PageSession session;
  ASSERT_TRUE(session.set_problem(problem.dump())) << session.mistakes();
  const ExploreReply reply = session.explore({});
  EXPECT_EQ(reply.map, nullptr);
  EXPECT_EQ(json::parse(reply.task)["reason"]["code"], "chain_wanted");
  const json best = json::parse(session.best(3));
  ASSERT_FALSE(best["linkages"].empty());
  for (const json& found : best["linkages"]) {
    problem["task"]["chain"] = found["chain"];
    PageSession chained;
    ASSERT_TRUE(chained.set_problem(problem.dump())) << chained.mistakes();
    const json linkage = json::parse(chained.linkage({found["tau"][0], found["tau"][1]}).linkage);
    EXPECT_NEAR(linkage["record"]["min_transmission_angle_deg"], found["record"]["min_transmission_angle_deg"], 0.5);
  }
}

TEST(SessionOfAStraightLine, HasALayerToEachLinkageOfAPlaceAndMeasuresWhatIsThere) {
  Explored explored(
      R"({"linkwright": 1, "task": {"kind": "straight_line", "mechanism": "four_bar", "case": "six_point",
      "line": {"point": [3, 2], "direction_deg": 30}, "pole_distance": 100}, "options": {"deviation": 0.01}})",
      60);
  EXPECT_EQ(explored.task["status"], "solved");
  EXPECT_EQ(explored.task["axes"]["input"]["branches"].size(), 3);
  EXPECT_EQ(explored.task["axes"]["input"]["quantity"], "point_ray");
  const auto [input, output] = explored.passing();
  const auto found = explored.linkage(input, output);
  const json& line = found["record"];
  EXPECT_EQ(found["fails"], 0);
  EXPECT_EQ(line["contact_points"], 6);
  EXPECT_EQ(line["deviation"], 0.01);
  EXPECT_NEAR(line["pivots"]["point"][0].get<double>(), 3, 1e-9);
  for (const json& at : found["profile"]) {
    if (at[0] < line["usable"]["from_s"] || at[0] > line["usable"]["to_s"]) continue;
    EXPECT_LE(std::abs(at[1].get<double>()), 0.01 * (1 + 1e-9));
  }
  EXPECT_TRUE(json::parse(explored.session.verify({input, output}))["verified"].get<bool>());
}

TEST(SessionOfAStraightLine, TellsWhatEitherDriverCan) {
  Explored explored(
      R"({"linkwright": 1, "task": {"kind": "straight_line", "mechanism": "four_bar", "case": "four_point_pivots",
      "line": {"point": [0, 120], "direction_deg": 0}, "ground_pivots": {"input": [0, 0], "output": [90, 20]}}})",
      24);
  int cranks = 0, other_drivers = 0, locked = 0;
  double farthest = 0;
  for (const double input : explored.input_tau())
    for (const double output : explored.output_tau()) {
      const json found = explored.linkage(input, output);
      if (!found["reason"].is_null()) continue;
      farthest = std::max(farthest, found["record"]["residual"].get<double>());
      const json &turning = found["driven"]["min_transmission_angle_full_turn_deg"], &swapped = found["swapped"];
      if (!turning.is_null()) {
        const json& lengths = found["record"]["lengths"];
        const auto [ground, crank, coupler, rocker] =
            std::array<double, 4>{lengths["ground"], lengths["input"], lengths["coupler"], lengths["output"]};
        EXPECT_NEAR(turning, degrees(least_transmission_angle_full_turn({ground, crank, coupler, rocker})), 1e-9);
        ++cranks;
      }
      const json& angle = swapped["min_transmission_angle_deg"];
      (angle.is_null() ? locked : other_drivers) += 1;
      EXPECT_EQ(angle.is_null(), swapped["defects"]["branch"].get<bool>());
      if (!angle.is_null()) {
        EXPECT_GT(angle, 0);
      }
    }
  EXPECT_GT(farthest, 0) << "what rounding leaves";
  EXPECT_LT(farthest, 1e-9);
  EXPECT_GT(cranks, 10);
  EXPECT_GT(other_drivers, 10);
  EXPECT_GT(locked, 10);
}

TEST(SessionOfAStraightLine, SearchesAllCasesAndTellsTheMapOfEachLinkage) {
  PageSession session;
  ASSERT_TRUE(session.set_problem(
      R"({"linkwright": 1, "task": {"kind": "straight_line", "mechanism": "four_bar", "case": "search",
      "line": {"point": [0, 0], "direction_deg": 0}, "stroke": 100, "deviation": 0.5}, "options": {"effort": 10000}})"));
  const auto best = json::parse(session.best(3));
  ASSERT_GE(best["linkages"].size(), 1U);
  for (const json& found : best["linkages"]) {
    json own = {{"linkwright", 1}, {"task", found["record"]["task"]}};
    own["options"] = {{"deviation", 0.5}, {"measure", "strip"}};
    if (!found["window"].is_null()) own["options"]["window"] = found["window"];
    PageSession there;
    ASSERT_TRUE(there.set_problem(own.dump())) << there.mistakes();
    const auto linkage = json::parse(there.linkage({found["tau"][0], found["tau"][1]}).linkage);
    EXPECT_NEAR(linkage["record"]["usable_strip"]["length"].get<double>(), 100, 0.01);
  }
}

TEST(SessionOfAStraightLine, ServesNoOtherMeasure) {
  constexpr std::string_view text =
      R"({"linkwright": 1, "task": {"kind": "straight_line", "mechanism": "four_bar", "case": "five_point",
      "line": {"point": [0, 0], "direction_deg": 0}, "pole_distance": 100, "point_ray_deg": 60},
      "options": {"deviation": WIDTH}})";
  const auto with_width = [&](std::string_view width) {
    std::string problem(text);
    return problem.replace(problem.find("WIDTH"), 5, width);
  };
  Explored explored(with_width("1"), 60);
  const auto [input, output] = explored.passing();
  const auto usable = [&, u = input, v = output](std::string_view width) {
    EXPECT_TRUE(explored.session.set_problem(with_width(width)));
    const auto found = explored.linkage(u, v);
    return found["record"]["usable"]["length"].get<double>();
  };
  EXPECT_LT(usable("0.01"), usable("1"));
}

}  // namespace
}  // namespace linkwright::wasm::session_kinds_test
