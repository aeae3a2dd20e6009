// The session asked about orientations: what the page is told of spherical four-bars.

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "linkwright/core/angle.hpp"
#include "session.hpp"
#include "spherical_reply.hpp"

namespace linkwright::wasm::spherical_session_test {
namespace {

using nlohmann::json;

constexpr std::string_view folding_wing =
    R"({"linkwright": 1, "task": {"kind": "motion", "mechanism": "spherical_four_bar", "orientations": [
    {"quaternion": [0.999048221581858, 0.043619387365336, 0, 0]},
    {"quaternion": [0.958358699680341, 0.204647675474021, -0.0704658456612476, -0.186286060308687]},
    {"quaternion": [0.828095951946162, 0.34848610206306, -0.30293434683669, -0.317876253510548]},
    {"quaternion": [0.65714960710091, 0.282543013684998, -0.634601998946228, -0.292581855620559]}]}})";

struct Shown {
  json linkage;
  std::vector<double> states;
  [[nodiscard]] std::size_t rows() const { return states.size() / spherical_state_width; }
  [[nodiscard]] double at(std::size_t row, std::size_t column) const {
    return states[row * spherical_state_width + column];
  }
};

/// Of the map of the folding wing every cell of some rows that is no degenerate one.
std::vector<Shown> shown_linkages() {
  Session session;
  EXPECT_TRUE(session.set_problem(folding_wing)) << session.mistakes();
  ExploreRequest request;
  request.samples = 24;
  const ExploreReply map = session.explore(request);
  std::vector<Shown> all;
  for (const double input : map.input_tau)
    for (const double output : map.output_tau) {
      const LinkageReply reply = session.linkage(input, output);
      json linkage = json::parse(reply.linkage);
      if (linkage["type"] != "degenerate") all.push_back({std::move(linkage), reply.states});
    }
  return all;
}

const std::vector<Shown>& linkages() {
  static const std::vector<Shown> all = shown_linkages();
  return all;
}

TEST(SphericalSession, DrivesInTheSenseOfTravel) {
  int clockwise = 0, clean = 0;
  for (const Shown& shown : linkages()) {
    const json& drive = shown.linkage["drive"];
    ASSERT_FALSE(drive.is_null());
    for (std::size_t row = 1; row < shown.rows(); ++row) ASSERT_LE(shown.at(row - 1, 0), shown.at(row, 0));
    const json& first = drive["ticks"][0];
    ASSERT_TRUE(first["reached"].get<bool>());
    EXPECT_NEAR(shown.at(first["state"].get<std::size_t>(), 0), 0, 1e-6);
    if (shown.linkage["drive_sense"].is_null()) continue;
    ++clean;
    clockwise += shown.linkage["drive_sense"] == "cw";
    int last = -1;
    for (const json& tick : drive["ticks"]) {
      ASSERT_GT(tick["state"].get<int>(), last) << shown.linkage["tau"];
      last = tick["state"].get<int>();
    }
    EXPECT_EQ(drive["task"][0], drive["ticks"][0]["state"]);
    EXPECT_EQ(drive["task"][1], drive["ticks"][3]["state"]);
  }
  EXPECT_GT(clean, 20);
  EXPECT_GT(clockwise, 5);
}

TEST(SphericalSession, TurnsTheOutputWithoutJumpsFromPositionOne) {
  for (const Shown& shown : linkages()) {
    const auto start = shown.linkage["drive"]["ticks"][0]["state"].get<std::size_t>();
    EXPECT_NEAR(shown.at(start, 10), 0, 1e-12);
    for (std::size_t row = 1; row < shown.rows(); ++row)
      ASSERT_LT(std::abs(shown.at(row, 10) - shown.at(row - 1, 10)), 180);
  }
}

TEST(SphericalSession, CarriesTheAxesAtTheirAnglesAndTheCouplerByItsTurn) {
  for (const Shown& shown : linkages()) {
    const json& bars = shown.linkage["spherical"];
    const auto axis = [&](const char* key) { return bars[key].get<std::array<double, 3>>(); };
    const auto fixed = axis("input_fixed"), moving = axis("input_moving");
    const double coupler = radians(bars["angles_deg"]["coupler"].get<double>());
    const double input = radians(bars["angles_deg"]["input"].get<double>());
    for (std::size_t row = 0; row < shown.rows(); row += 40) {
      const Vector3 a{shown.at(row, 13), shown.at(row, 14), shown.at(row, 15)};
      const Vector3 b{shown.at(row, 16), shown.at(row, 17), shown.at(row, 18)};
      EXPECT_NEAR(dot(a, b), std::cos(coupler), 1e-9);
      EXPECT_NEAR(dot(a, {fixed[0], fixed[1], fixed[2]}), std::cos(input), 1e-9);
      const UnitQuaternion turn =
          *UnitQuaternion::of(shown.at(row, 19), {shown.at(row, 20), shown.at(row, 21), shown.at(row, 22)});
      EXPECT_NEAR(norm(turn.apply({moving[0], moving[1], moving[2]}) - a), 0, 1e-9);
    }
  }
}

TEST(SphericalSession, ClosesATurnAndPutsThePositionsInItsMiddle) {
  int cranks = 0;
  for (const Shown& shown : linkages()) {
    if (!shown.linkage["drive"]["full_turn"].get<bool>()) continue;
    ++cranks;
    EXPECT_NEAR(shown.at(shown.rows() - 1, 0) - shown.at(0, 0), 360, 1e-6);
    EXPECT_LT(shown.at(0, 0), 1e-9);
    EXPECT_TRUE(shown.linkage["dead_points_deg"].empty());
  }
  EXPECT_GT(cranks, 5);
}

TEST(SphericalSession, EndsAtDeadPointsWhereTheInputCannotGoRound) {
  for (const Shown& shown : linkages()) {
    if (shown.linkage["drive"]["full_turn"].get<bool>()) continue;
    for (const std::size_t end : {std::size_t{0}, shown.rows() - 1}) {
      double nearest = 360;
      for (const json& dead : shown.linkage["dead_points_deg"])
        nearest = std::min(nearest, std::abs(dead.get<double>() - shown.at(end, 0)));
      EXPECT_LT(nearest, 1e-5) << shown.linkage["tau"];
    }
  }
}

TEST(SphericalSession, TellsOfTheBestWhatTheMapShows) {
  Session session;
  ASSERT_TRUE(session.set_problem(folding_wing));
  const json best = json::parse(session.best(3));
  ASSERT_FALSE(best["linkages"].empty());
  for (const json& one : best["linkages"]) {
    const json linkage = json::parse(session.linkage(one["tau"][0], one["tau"][1]).linkage);
    EXPECT_NEAR(one["min_link_angle_deg"].get<double>(), linkage["spherical"]["min_link_angle_deg"].get<double>(),
                1e-9);
    EXPECT_GE(one["min_link_angle_deg"].get<double>(), 5);
    EXPECT_GT(one["driver_sweep_deg"].get<double>(), 0);
    EXPECT_EQ(one["pivots"].size(), 4u);
  }
}

}  // namespace
}  // namespace linkwright::wasm::spherical_session_test
