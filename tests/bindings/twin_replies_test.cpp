// What the engine says to the page, call by call, from this compiler; web/tests/twin.test.ts asks WebAssembly's the
// same.

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "session.hpp"
#include "support/file_support.hpp"

namespace linkwright::wasm::twin_replies_test {
namespace {

using nlohmann::json;
using std::filesystem::path;

constexpr int samples = 24;
constexpr MapPoint anywhere = {0.31, 0.62};

json map_json(const ExploreReply& reply) {
  if (reply.map == nullptr) return nullptr;
  const ColouredMap& map = *reply.map;
  return {{"census", reply.census},
          {"input_tau", map.region.input_coordinates()},
          {"output_tau", map.region.output_coordinates()},
          {"type", map.region.types()},
          {"defects", map.region.defects()},
          {"fails", map.fails},
          {"value", map.values},
          {"ridge_input", map.ridges.input.value},
          {"ridge_output", map.ridges.output.value}};
}
/// The first cell that meets the requirements; else any place.
MapPoint place_in(const ExploreReply& reply) {
  if (reply.map == nullptr) return anywhere;
  const auto found = std::ranges::find(reply.map->fails, FailureBits{0});
  if (found == reply.map->fails.end()) return anywhere;
  const auto cell = static_cast<std::size_t>(found - reply.map->fails.begin());
  const auto columns = reply.map->region.output_coordinates();
  return {reply.map->region.input_coordinates()[cell / columns.size()], columns[cell % columns.size()]};
}

json linkage_json(const LinkageReply& reply) {
  return {{"linkage", reply.linkage}, {"states", reply.states}, {"tolerance", reply.tolerance}};
}
json machine_json(const MachineReply& reply) {
  return {{"plan", reply.plan}, {"vertices", reply.vertices}, {"triangles", reply.triangles}, {"travel", reply.travel}};
}

/// Calls of one session, as [method, arguments, reply].
json asked_of(const std::string& problem) {
  PageSession session;
  json calls = json::array();
  const auto note = [&calls](const char* method, json arguments, json reply) {
    calls.push_back({method, std::move(arguments), std::move(reply)});
  };
  note("read", {problem}, session.read(problem));
  note("notices", json::array(), session.notices());
  const bool is_good = session.set_problem(problem);
  note("set_problem", {problem}, is_good);
  note("mistakes", json::array(), session.mistakes());
  if (!is_good) return calls;

  const std::string property = "min_transmission_angle";
  const ExploreReply shown = session.explore({samples, MapRequest::whole, MapRequest::whole, property, 0});
  note("explore", {samples, 0, 1, 0, 1, property, 0},
       {{"task", shown.task}, {"curves", {{"tau", shown.input_curves->coordinate}}}, {"map", map_json(shown)}});
  const MapPoint at = place_in(shown);
  const json place = {at.input, at.output};
  note("linkage", place, linkage_json(session.linkage(at)));
  const LiveLinks live = session.live(at);
  note("live", place, {{"input", live.input}, {"output", live.output}});
  note("verify", place, session.verify(at));
  const bool is_soon_found = problem.find("six_bar") == std::string::npos;
  if (is_soon_found) note("best", {3}, session.best(3));
  note("halo", {0, false, 1.0, 3, 12}, session.halo({0, false, 1.0, 3, 12}));
  for (const char* format : {"dxf", "json"})
    note("exported", {at.input, at.output, format}, session.exported(at, format));
  const json chosen = {{"width", 0}, {"thickness", 0}, {"gap", 0}, {"pin", 0}, {"radius", 0}, {"clearance", -1}};
  note("machine", {at.input, at.output, chosen}, machine_json(session.machine(at, {})));
  return calls;
}

/// Reports that know no session, as [of, text, reply].
json reports() {
  json asked = json::array();
  for (const char* sequence : {"ZXZ", "XYZ", "xyz", "ZYX", "zxz"}) {
    const json orientation = {{"euler_deg", {35, 50, -20}}, {"sequence", sequence}};
    const json attitude = {{"orientation", orientation},
                           {"sequence", sequence},
                           {"turning", "intrinsic"},
                           {"vector", {1, 2, 3}},
                           {"from", {{"orientation", {{"quaternion", {1, 0, 0, 0}}}}, {"translation", {0, 0, 0}}}},
                           {"translation", {100, 50, 20}},
                           {"rates_deg", {10, 20, 30}},
                           {"at", {{"turns", 1.5}, {"rotation", 0.25}, {"screw", 0.75}}}};
    const json turn = {{"axis", {1, 0, 1}}, {"angle_deg", 30}};
    asked.push_back({"attitude", attitude.dump()});
    asked.push_back({"orientation", json{{"orientation", orientation}, {"turn", turn}}.dump()});
  }
  asked.push_back(
      {"instant",
       R"({"pivots": {"input_center": [0, 0], "input_circle": [1, 1.2], "output_center": [4, 0.3], "output_circle": [3.5, 3]}})"});
  for (json& one : asked)
    one.push_back(one[0] == "instant" ? instant_reply(one[1].get<std::string>())
                                      : attitude_reply(one[0].get<std::string>(), one[1].get<std::string>()));
  return asked;
}

/// The page knows none that is no Unicode.
bool is_text(const std::string& bytes) {
  return json::parse(json(bytes).dump(-1, ' ', false, json::error_handler_t::ignore)) == bytes;
}

std::vector<path> problems() {
  const path data = LINKWRIGHT_DATA_DIR;
  std::vector<path> found;
  for (const path& folder : {path(LINKWRIGHT_EXAMPLES_DIR), data / "bad_problems"})
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      if (entry.path().extension() == ".json" && is_text(testing::text_of(entry.path()))) found.push_back(entry.path());
  std::ranges::sort(found);
  return found;
}

TEST(TwinReplies, of_all_examples_and_bad_problems_can_be_compared) {
  json twin = {{"sessions", json::object()}, {"reports", reports()}};
  for (const path& file : problems()) twin["sessions"][file.stem().string()] = asked_of(testing::text_of(file));
  EXPECT_GT(twin["sessions"].size(), 200u);
  for (const json& report : twin["reports"])
    EXPECT_EQ(report[2].get<std::string>().find("mistakes"), std::string::npos) << report;
  EXPECT_EQ(twin["sessions"]["tailgate"][3][2], "[]");
  EXPECT_NE(twin["sessions"]["a_thousand_poses"][3][2], "[]");
  if (const char* file = std::getenv("LINKWRIGHT_TWIN")) std::ofstream(file) << twin;
}

}  // namespace
}  // namespace linkwright::wasm::twin_replies_test
