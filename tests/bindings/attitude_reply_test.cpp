// What the attitude page is told: the same as `linkwright attitude` says, and each thing played from its beginning to
// its end.
#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "linkwright/files/orientation_file.hpp"
#include "replies.hpp"

namespace linkwright::wasm::attitude_reply_test {
namespace {

using nlohmann::json;

json task(json change = json::object()) {
  json asked = {{"orientation", {{"euler_deg", {40, 50, 35}}, {"sequence", "zxz"}}},
                {"sequence", "zxz"},
                {"turning", "intrinsic"},
                {"vector", {1, 0, 0}},
                {"from", {{"translation", {1, 0, 0}}}},
                {"translation", {0, 2, 1}},
                {"rates_deg", {10, 20, 30}}};
  asked.update(change);
  return asked;
}
json reply(const json& asked, std::string_view of = "attitude") {
  return json::parse(attitude_reply(of, asked.dump()));
}

double distance(const json& a, const json& b) {
  if (!a.is_array()) return std::fabs(a.get<double>() - b.get<double>());
  double most = a.size() == b.size() ? 0 : INFINITY;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, distance(a[i], b[i]));
  return most;
}
json column(const json& rows, std::size_t j) { return {rows[0][j], rows[1][j], rows[2][j]}; }

TEST(AttitudeReply, SaysWhatConvertSays) {
  const auto orientation = read_orientation_task(
      R"({"linkwright": 1, "orientation": {"euler_deg": [40, 50, 35], "sequence": "zxz"}, "vectors": [[1, 0, 0]]})");
  EXPECT_EQ(reply(task())["convert"], json::parse(write_orientation_report(orientation_report(*orientation))));
}

TEST(AttitudeReply, PlaysTheTurnsOneAfterTheOther) {
  for (const std::string turning : {"intrinsic", "extrinsic"}) {
    for (const std::string sequence : {"zxz", "xyz", "zyx", "yzy"}) {
      const json shown = {{"sequence", sequence}, {"turning", turning}};
      const auto at = [&](double turns) {
        json asked = task(shown);
        asked["at"] = {{"turns", turns}};
        return reply(asked)["turns"];
      };
      const json all = at(3);
      EXPECT_LE(distance(at(0)["now"]["frame"], {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}), 1e-15);
      EXPECT_LE(distance(at(1)["now"]["frame"], all["frames"][0]), 1e-15);
      EXPECT_LE(distance(at(2)["now"]["frame"], all["frames"][1]), 1e-15);
      EXPECT_LE(distance(all["frames"][2], reply(task())["convert"]["matrix"]), 1e-14);
      EXPECT_LE(distance(all["now"]["axes"], all["axes"]), 1e-15);
    }
  }
}

TEST(AttitudeReply, KeepsTheAnglesThatWereGiven) {
  const json locked = {{"orientation", {{"euler_deg", {400, 0, 35}}, {"sequence", "zxz"}}}};
  const json turns = reply(task(locked))["turns"];
  EXPECT_EQ(turns["angles_deg"], json({400, 0, 35}));
  EXPECT_EQ(turns["given"], true);
  EXPECT_EQ(turns["locked"], true);
  EXPECT_NEAR(turns["determined"]["angle_deg"].get<double>(), 75, 1e-12);
  json other = task(locked);
  other["sequence"] = "xyz";
  EXPECT_EQ(reply(other)["turns"]["given"], false);
  EXPECT_EQ(reply(other)["turns"]["locked"], false);
}

TEST(AttitudeReply, TurnsAboutTheBodysOwnAxes) {
  json asked = task({{"orientation", {{"axis", {0, 0, 1}}, {"angle_deg", 90}}}});
  asked["turn"] = {{"axis", {1, 0, 0}}, {"angle_deg", 90}};
  for (const char* of : {"attitude", "orientation"}) {
    const json matrix = reply(asked, of)["convert"]["matrix"];
    EXPECT_LE(distance(column(matrix, 0), {0, 1, 0}), 1e-15) << "the axis of the turn stays";
    EXPECT_LE(distance(column(matrix, 1), {0, 0, 1}), 1e-15);
  }
}

TEST(AttitudeReply, RunsOnTheConeAndOnTheHelix) {
  const json all = reply(task());
  const json path = all["rotation"]["path"];
  EXPECT_LE(distance(path.front(), {1, 0, 0}), 1e-15);
  EXPECT_LE(distance(path.back(), all["convert"]["images"][0]), 1e-14);
  EXPECT_LE(distance(all["rotation"]["now"]["vector"], path.back()), 1e-15);
  const json way = all["motion"]["path"];
  EXPECT_LE(distance(way.front(), {1, 0, 0}), 1e-15);
  EXPECT_LE(distance(way.back(), {0, 2, 1}), 1e-13);
  for (int i = 0; i < 3; ++i)
    EXPECT_LE(distance(column(all["motion"]["now"], i), column(all["convert"]["matrix"], i)), 1e-13);
  json first = task();
  first["at"] = {{"screw", 0}};
  EXPECT_LE(distance(reply(first)["motion"]["now"], all["motion"]["from"]), 1e-15);
}

TEST(AttitudeReply, NothingMovesBetweenAPoseAndItself) {
  json asked = task();
  asked["from"] = {{"orientation", asked["orientation"]}, {"translation", asked["translation"] = {-60, 260, 90}}};
  EXPECT_EQ(reply(asked)["screw"]["screw"]["kind"], "identity");
}

TEST(AttitudeReply, HasTheAngularVelocityOfTheRates) {
  const json all = reply(task());
  json sum = {0, 0, 0};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      sum[i] = sum[i].get<double>() + all["rate_matrix"][i][j].get<double>() * 10 * (j + 1) * M_PI / 180;
  EXPECT_LE(distance(sum, all["rates"]["fixed"]["velocity"]), 1e-15);
}

TEST(AttitudeReply, MistakesNameTheirPlaceInTheTask) {
  const auto place = [](const json& change) { return reply(task(change))["mistakes"][0]["place"].get<std::string>(); };
  EXPECT_EQ(place({{"orientation", {{"quaternion", {0, 0, 0, 0}}}}}), "task.orientation.quaternion");
  EXPECT_EQ(place({{"from", {{"translation", {0, 1}}}}}), "task.from.translation");
  EXPECT_EQ(place({{"translation", {0, 1}}}), "task.translation");
  EXPECT_EQ(place({{"rates_deg", {0, 1e13, 0}}}), "task.rates_deg");
}

}  // namespace
}  // namespace linkwright::wasm::attitude_reply_test
