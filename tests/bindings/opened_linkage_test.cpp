// Linkages that are opened as such: what the page is told of them and what is written.
#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "linkwright/core/angle.hpp"
#include "linkwright/files/six_bar_file.hpp"
#include "session.hpp"
#include "support/machine_cases.hpp"

namespace linkwright::wasm::opened_linkage_test {
namespace {

using nlohmann::json;

std::string problem_of(const json& file) {
  return json{{"linkwright", 1}, {"length_unit", "mm"}, {"task", {{"kind", "linkage"}, {"file", file}}}}.dump();
}
json file_of(const AnyStoredLinkage& linkage) {
  return json::parse(std::visit([](const auto& of_kind) { return write_linkage(of_kind); }, linkage));
}
std::size_t width_of(const AnyStoredLinkage& linkage) {
  if (std::holds_alternative<StoredSixBar>(linkage)) return six_bar_state_width;
  return std::holds_alternative<StoredSphericalFourBar>(linkage) ? spherical_state_width : state_width;
}

TEST(OpenedLinkages, AreDrivenAndWrittenWhateverTheyAre) {
  PageSession session;
  for (const AnyStoredLinkage& stored : testing::stored_linkages_of_examples()) {
    ASSERT_TRUE(session.set_problem(problem_of(file_of(stored)))) << session.mistakes();
    const LinkageReply reply = session.linkage({0, 0});
    const json linkage = json::parse(reply.linkage);
    ASSERT_FALSE(linkage["travel"].is_null());
    const std::size_t rows = reply.states.size() / width_of(stored);
    EXPECT_EQ(reply.states.size() % width_of(stored), 0u);
    EXPECT_GT(rows, 100u);
    EXPECT_EQ(linkage["rates"]["rows"].size(), rows);
    for (const char* format : {"svg", "csv", "json"}) EXPECT_FALSE(session.exported({0, 0}, format).empty()) << format;
    for (const char* format : {"3mf", "urdf", "sdf", "mjcf"}) {
      const auto file = session.machine_file({0, 0}, format, {});
      EXPECT_TRUE(file && !file->empty()) << format;
    }
  }
}

// The rates are those of the table that the page shows: by differences of its angles and of the point's places.
TEST(OpenedLinkages, TellTheRatesOfTheirOwnTable) {
  int compared = 0;
  for (const AnyStoredLinkage& stored : testing::stored_linkages_of_examples()) {
    if (std::holds_alternative<StoredSphericalFourBar>(stored)) continue;
    const LinkageReply reply = opened_reply(stored);
    const json rows = json::parse(reply.linkage)["rates"]["rows"];
    const std::size_t width = width_of(stored), bodies = std::holds_alternative<StoredSixBar>(stored) ? 5 : 3;
    const auto state = [&](std::size_t row, std::size_t column) { return reply.states[row * width + column]; };
    for (std::size_t row = 1; row + 1 < rows.size(); row += 10) {
      if (rows[row].is_null() || rows[row - 1].is_null() || rows[row + 1].is_null()) continue;
      const double before = radians(state(row, 0) - state(row - 1, 0)),
                   after = radians(state(row + 1, 0) - state(row, 0));
      const double vx = rows[row][2 * bodies], ax = rows[row][2 * bodies + 2];
      const double steepest = std::abs(double{rows[row][2]}) + std::abs(double{rows[row][2 * bodies - 2]});
      if (std::abs(after - before) > 1e-9 || steepest > 3) continue;
      const double size = 1 + std::abs(state(row, 5)) + std::abs(vx) + std::abs(ax);
      EXPECT_NEAR(vx, (state(row + 1, 5) - state(row - 1, 5)) / (2 * after), 0.02 * size);
      const double next = rows[row + 1][2 * bodies], last = rows[row - 1][2 * bodies];
      EXPECT_NEAR(ax, (next - last) / (2 * after), 0.05 * size);
      ++compared;
    }
  }
  EXPECT_GT(compared, 200);
}

TEST(OpenedLinkages, OfFourBarsHaveTheVelocityRatioForTheOutput) {
  const json file = {{"lengths", {{"ground", 3.5}, {"input", 1}, {"coupler", 3}, {"output", 2.5}}}};
  PageSession session;
  ASSERT_TRUE(session.set_problem(problem_of(file)));
  const LinkageReply reply = session.linkage({0, 0});
  const json linkage = json::parse(reply.linkage);
  EXPECT_EQ(linkage["record"]["type"], "crank_rocker");
  EXPECT_TRUE(linkage["travel"]["full_turn"].get<bool>());
  EXPECT_NEAR(linkage["record"]["driver_sweep_deg"], 360, 1e-9);
  EXPECT_EQ(linkage["record"]["min_transmission_angle_deg"], linkage["record"]["min_transmission_angle_full_turn_deg"]);
  for (std::size_t row = 0; row < linkage["rates"]["rows"].size(); row += 15)
    EXPECT_NEAR(linkage["rates"]["rows"][row][4], reply.states[row * state_width + 11], 1e-9);
}

TEST(OpenedLinkages, SayWhatIsWrongWithThem) {
  PageSession session;
  const auto first_mistake = [&](const json& file) {
    EXPECT_FALSE(session.set_problem(problem_of(file)));
    return json::parse(session.mistakes())[0];
  };
  const json open = first_mistake({{"lengths", {{"ground", 9}, {"input", 1}, {"coupler", 1}, {"output", 1}}}});
  EXPECT_EQ(open["code"], "cannot_be_assembled");
  EXPECT_EQ(open["place"], "task.file.lengths");
  EXPECT_EQ(first_mistake(json::object())["place"], "task.file");
  EXPECT_EQ(session.read(problem_of(json::object())), "");
}

// A problem that follows a linkage is a problem again, and the other way round.
TEST(OpenedLinkages, GiveWayToATask) {
  PageSession session;
  const json file = {{"lengths", {{"ground", 3.5}, {"input", 1}, {"coupler", 3}, {"output", 2.5}}}};
  const std::string task = R"({"linkwright": 1, "task": {"kind": "motion", "mechanism": "four_bar", "poses": [
    {"x": 0, "y": 0, "theta_deg": 0}, {"x": 50, "y": 30, "theta_deg": 30}, {"x": 60, "y": 90, "theta_deg": 80},
    {"x": 20, "y": 120, "theta_deg": 100}]}})";
  ASSERT_TRUE(session.set_problem(task));
  ASSERT_TRUE(session.set_problem(problem_of(file)));
  EXPECT_FALSE(session.linkage({0, 0}).linkage.empty());
  EXPECT_TRUE(session.live({0, 0}).input.empty());
  ASSERT_TRUE(session.set_problem(task));
  EXPECT_NE(session.explore({}).map, nullptr);
  EXPECT_FALSE(opened_linkage(task).has_value());
}

}  // namespace
}  // namespace linkwright::wasm::opened_linkage_test
