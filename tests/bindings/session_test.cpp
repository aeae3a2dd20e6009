#include "session.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sstream>

#include "linkwright/core/angle.hpp"
#include "linkwright/files/linkage_file.hpp"

namespace linkwright::wasm::session_test {
namespace {

using nlohmann::json;

std::string tailgate() {
  std::ifstream file(LINKWRIGHT_EXAMPLES_DIR "/tailgate.json");
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

class SessionTest : public ::testing::Test {
 protected:
  SessionTest() { EXPECT_TRUE(session.set_problem(tailgate())); }
  PageSession session;
};

TEST_F(SessionTest, ExploresTheWholeTask) {
  const ExploreReply reply = session.explore({});
  const json task = json::parse(reply.task), census = json::parse(reply.census);
  EXPECT_EQ(task["status"], "solved");
  EXPECT_TRUE(task["reason"].is_null());
  EXPECT_EQ(task["curves"]["kind"], "two_branches");
  EXPECT_EQ(task["requirements"]["max_length"], 450);
  EXPECT_EQ(census["pairs"], 159'600);
  EXPECT_EQ(census["meeting"], 25'608);
  EXPECT_EQ(census["left"]["min_yield"], 25'608);
  EXPECT_EQ(reply.input_curves->coordinate.size() * 3, reply.input_curves->fixed.size());
  EXPECT_TRUE(std::is_sorted(reply.input_curves->coordinate.begin(), reply.input_curves->coordinate.end()));
  ASSERT_EQ(reply.map->fails.size(), 160'000u);
  EXPECT_EQ(std::count(reply.map->fails.begin(), reply.map->fails.end(), 0), 25'608);
}

// Acceptance walk-through 8.
TEST_F(SessionTest, WithoutARequirementItsNumberIsAdded) {
  const json before = json::parse(session.explore({}).census);
  ASSERT_TRUE(session.set_problem(with(tailgate(), R"("max_link_ratio": 8)", R"("max_link_ratio": null)")));
  const json after = json::parse(session.explore({}).census);
  EXPECT_EQ(after["meeting"].get<int>(), before["meeting"].get<int>() + before["only"]["max_link_ratio"].get<int>());
}

// Acceptance walk-through 7.
TEST_F(SessionTest, SaysWhichValueWouldLeaveSomething) {
  const std::string strict =
      with(tailgate(), "\"min_transmission_angle_deg\": 30", "\"min_transmission_angle_deg\": 89");
  ASSERT_TRUE(session.set_problem(strict));
  const json census = json::parse(session.explore({}).census);
  EXPECT_EQ(census["meeting"], 0);
  const json relax = census["relax"][0];
  EXPECT_EQ(relax["requirement"], "min_transmission_angle_deg");
  ASSERT_TRUE(session.set_problem(
      with(strict, "\"min_transmission_angle_deg\": 89", "\"min_transmission_angle_deg\": " + relax["value"].dump())));
  EXPECT_EQ(json::parse(session.explore({}).census)["meeting"], relax["leaves"]);
}

TEST_F(SessionTest, PropertiesAndRidgesFollowTheRequest) {
  MapRequest request;
  request.samples = 60;
  request.property = measures::longest_link.key;
  const ExploreReply reply = session.explore(request);
  const auto& map = *reply.map;
  for (std::size_t row = 0; row < 60; ++row) {
    float best = 0;
    for (std::size_t column = 0; column < 60; ++column) {
      const std::size_t cell = map.region.index(row, column);
      if (map.fails[cell] == 0 && (best == 0 || map.values[cell] < best)) best = map.values[cell];
    }
    EXPECT_EQ(map.ridges.input.value[row], best);
  }
}

TEST_F(SessionTest, AWindowIsAPartOfTheMap) {
  MapRequest request;
  request.samples = 50;
  request.input = {0.5, 0.75};
  request.output = {0, 0.5};
  const ExploreReply reply = session.explore(request);
  ASSERT_EQ(reply.map->region.input_coordinates().size(), 50u);
  for (const double tau : reply.map->region.input_coordinates()) EXPECT_TRUE(tau >= 1 && tau < 2);
  for (const double tau : reply.map->region.output_coordinates()) EXPECT_TRUE(tau >= 0 && tau < 1);
}

// Acceptance walk-through 4.
TEST_F(SessionTest, TellsEverythingOfOneLinkage) {
  const LinkageReply reply = session.linkage({1.3125, 1.1125});
  const json told = json::parse(reply.linkage), found = told["record"];
  EXPECT_EQ(found["type"], "triple_rocker_output");
  EXPECT_NEAR(found["min_transmission_angle_deg"], 73.5, 0.05);
  EXPECT_NEAR(found["link_ratio"], 4.7, 0.05);
  EXPECT_NEAR(found["lengths"]["ground"], 65.03, 0.005);
  EXPECT_NEAR(found["lengths"]["input"], 211.05, 0.005);
  EXPECT_NEAR(found["lengths"]["coupler"], 53.92, 0.005);
  EXPECT_NEAR(found["lengths"]["output"], 255.90, 0.005);
  EXPECT_EQ(told["fails"], 0);
  EXPECT_TRUE(told["reason"].is_null());
  EXPECT_LT(found["residual"], 1e-9);
  ASSERT_EQ(reply.states.size() % state_width, 0u);
  for (const auto& tick : told["travel"]["ticks"]) EXPECT_TRUE(tick["reached"]);
  const auto last = told["travel"]["ticks"][3]["state"].get<std::size_t>();
  EXPECT_EQ(reply.states[last * state_width + 5], -220);
  EXPECT_EQ(reply.states[last * state_width + 6], 450);
  EXPECT_NEAR(reply.states[last * state_width + 7], -82, 1e-12);
}

TEST_F(SessionTest, TheCardAgreesWithEveryCellOfTheMap) {
  MapRequest request;
  request.samples = 40;
  const ExploreReply reply = session.explore(request);
  const auto coordinates = reply.map->region.input_coordinates();
  const std::vector<double> tau(coordinates.begin(), coordinates.end());
  const std::vector<FailureBits> fails = reply.map->fails;
  const std::vector<std::uint8_t> types(reply.map->region.types().begin(), reply.map->region.types().end());
  for (std::size_t row = 0; row < 40; ++row)
    for (std::size_t column = 0; column < 40; ++column) {
      const json found = json::parse(session.linkage({tau[row], tau[column]}).linkage);
      EXPECT_EQ(found["fails"], fails[row * 40 + column]) << tau[row] << " " << tau[column];
      const json& record = found["record"];
      const std::string_view type = linkage_type_names[types[row * 40 + column]];
      EXPECT_EQ(record.is_null(), type == "degenerate");
      if (!record.is_null()) {
        EXPECT_EQ(record["type"], type);
      }
      EXPECT_EQ(found["reason"].is_null(),
                !record.is_null() && record["defects"]["order"] == false && record["defects"]["branch"] == false);
    }
}

TEST_F(SessionTest, ASliderIsSaidToBeOne) {
  const json task = json::parse(session.explore({}).task);
  for (const auto& mark : task["specials"]) {
    if (mark["kind"] != "center_at_infinity" && mark["kind"] != "circle_at_infinity") continue;
    const json found = json::parse(session.linkage({mark["tau"][0], 1.1125}).linkage);
    EXPECT_TRUE(found["record"].is_null());
    EXPECT_EQ(found["reason"]["code"], mark["kind"] == "center_at_infinity" ? "slider_fixed" : "slider_moving");
    EXPECT_TRUE(found["travel"].is_null());
    EXPECT_FALSE(found["input"]["center_homogeneous"].is_null());
    EXPECT_EQ(found["fails"], all_failures);
  }
}

TEST_F(SessionTest, TheLivePartAgreesWithTheCard) {
  const LiveLinks live = session.live({1.3125, 1.1125});
  const LinkPolygon curves = *session.explore({}).input_curves;
  ASSERT_EQ(live.input.size(), curves.coordinate.size());
  ASSERT_EQ(live.output.size(), curves.coordinate.size());
  EXPECT_GT(std::count(live.input.begin(), live.input.end(), 0), 3);
  for (std::size_t i = 0; i < curves.coordinate.size(); i += 7) {
    EXPECT_EQ(json::parse(session.linkage({curves.coordinate[i], 1.1125}).linkage)["fails"], live.input[i]);
    EXPECT_EQ(json::parse(session.linkage({1.3125, curves.coordinate[i]}).linkage)["fails"], live.output[i]);
  }
}

TEST_F(SessionTest, RefusesInTheWordsOfTheCommandLine) {
  EXPECT_FALSE(session.set_problem(with(tailgate(), "\"x\": -125", "\"x\": 1e10")));
  const json mistakes = json::parse(session.mistakes());
  ASSERT_EQ(mistakes.size(), 1u);
  EXPECT_EQ(mistakes[0]["code"], "number_range");
  EXPECT_EQ(mistakes[0]["values"], json({{"name", "x"}, {"most", "1 000 000 000"}}));
  EXPECT_EQ(mistakes[0]["place"], "task.poses[1].x");
  EXPECT_EQ(session.read("{"), "");
  EXPECT_NE(json::parse(session.mistakes())[0]["message"].get<std::string>().find("breaks off"), std::string::npos);
  EXPECT_EQ(json::parse(session.read(tailgate()))["title"], "Tailgate hinge");
}

TEST_F(SessionTest, ADegenerateTaskHasAReasonAndNoMap) {
  ASSERT_TRUE(session.set_problem(R"({"linkwright": 1, "task": {"kind": "motion", "mechanism": "four_bar", "poses": [
    {"x": 2, "y": 0, "theta_deg": 0}, {"x": 0, "y": 2, "theta_deg": 0}, {"x": -2, "y": 0, "theta_deg": 0},
    {"x": 0, "y": -2, "theta_deg": 0}]}})"));
  const ExploreReply reply = session.explore({});
  const json task = json::parse(reply.task);
  EXPECT_EQ(task["status"], "degenerate");
  EXPECT_EQ(task["reason"]["code"], "translations_on_circle");
  EXPECT_EQ(reply.map, nullptr);
  EXPECT_EQ(session.linkage({0.5, 0.7}).linkage, "");
}

TEST_F(SessionTest, FindsImprovesVerifiesAndTraces) {
  const json best = json::parse(session.best(3))["linkages"];
  ASSERT_EQ(best.size(), 3u);
  EXPECT_GE(best[0]["record"]["min_transmission_angle_deg"], best[2]["record"]["min_transmission_angle_deg"]);
  const json better = json::parse(session.improve({1.3125, 1.1125}));
  EXPECT_TRUE(better["improved"]);
  EXPECT_TRUE(json::parse(session.verify({better["tau"][0], better["tau"][1]}))["verified"]);
  const std::vector<Point> path = session.trace({1.3125, 1.1125}, {0, 0});
  const std::vector<double> states = session.linkage({1.3125, 1.1125}).states;
  ASSERT_EQ(path.size(), states.size() / state_width);
  EXPECT_EQ(path[0].real(), states[5]) << "the body's origin is traced by the poses themselves";
}

TEST_F(SessionTest, WritesEveryFormat) {
  EXPECT_NE(session.exported({1.3125, 1.1125}, "svg").find("<svg"), std::string::npos);
  EXPECT_NE(session.exported({1.3125, 1.1125}, "dxf").find("COUPLER_CURVE"), std::string::npos);
  const std::string table = session.exported({1.3125, 1.1125}, "csv");
  EXPECT_GT(std::count(table.begin(), table.end(), '\n'), 361);
  EXPECT_TRUE(read_linkage(session.exported({1.3125, 1.1125}, "json")).ok());
  EXPECT_EQ(json::parse(session.exported({1.3125, 1.1125}, "result"))["linkages"].size(), 1u);
}

TEST_F(SessionTest, TellsOfALinkageAsPlatesAndPins) {
  WantedSizes sizes;
  sizes.clearance = 0.4;
  const json plan = json::parse(session.machine({1.3125, 1.1125}, sizes).plan);
  EXPECT_EQ(plan["sizes"]["clearance"], 0.4);
  EXPECT_EQ(plan["sizes"]["radius"], 0);
  ASSERT_EQ(plan["layers"].size(), 4u);
  EXPECT_EQ(plan["layers"][0], json({{"body", "ground"}, {"layer", 0}}));
  for (const json& crossing : plan["crossings"]) {
    EXPECT_NE(crossing.contains("pin"), crossing.contains("other"));
    EXPECT_LE(crossing["from_deg"], crossing["to_deg"]);
  }
  sizes.pin = 100;
  sizes.width = 20;
  EXPECT_EQ(json::parse(session.machine({1.3125, 1.1125}, sizes).plan)["mistakes"][0]["code"], "pin_too_wide");
}

TEST_F(SessionTest, GivesTheBytesOfPlatesAndPins) {
  const auto bytes = [&](std::string_view format, double clearance) {
    WantedSizes sizes;
    sizes.clearance = clearance;
    return session.machine_file({1.3125, 1.1125}, format, sizes).value();
  };
  const std::string stl = bytes("stl", 0.4);
  std::uint32_t triangles = 0;
  std::memcpy(&triangles, stl.data() + 80, sizeof triangles);
  EXPECT_EQ(stl.size(), 84 + 50u * triangles);
  EXPECT_EQ(bytes("3mf", 0.4).substr(0, 2), "PK");
  EXPECT_NE(bytes("3mf", 0.4), bytes("3mf", 0.1));
  EXPECT_NE(bytes("plates", 0.4).find("CIRCLE"), std::string::npos);
  WantedSizes negative;
  negative.width = -1;
  EXPECT_EQ(session.machine_file({1.3125, 1.1125}, "stl", negative).errors().front().code, "size_out_of_range");
}

}  // namespace
}  // namespace linkwright::wasm::session_test
