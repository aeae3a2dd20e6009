#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "replies.hpp"

namespace linkwright::wasm::instant_reply_test {
namespace {

using nlohmann::json;

json reply(const char* pivots) { return json::parse(instant_reply(pivots)); }

TEST(InstantReply, HoldsTheInstantAndItsCurves) {
  const json told = reply(
      R"({"pivots": {"input_center": [0, 0], "input_circle": [1, 1.2], "output_center": [4, 0.3], "output_circle": [3.5, 3]}})");
  EXPECT_EQ(told["instant"]["kind"], "turning");
  for (const char* curve : {"circling_points", "centering_points"}) {
    std::size_t vertices = 0;
    for (const json& path : told[curve]) vertices += path.size();
    EXPECT_GT(vertices, 200U);
    EXPECT_LT(vertices, 6000U);
  }
  // Every vertex of the one curve keeps its equation.
  const json& cubic = told["instant"]["cubic"];
  const double m = cubic["m"], n = cubic["n"],
               angle = told["instant"]["pole_tangent_deg"].get<double>() * 3.141592653589793 / 180;
  for (const json& path : told["circling_points"])
    for (const json& vertex : path) {
      const double dx = vertex[0].get<double>() - told["instant"]["pole"][0].get<double>(),
                   dy = vertex[1].get<double>() - told["instant"]["pole"][1].get<double>();
      const double x = dx * std::cos(angle) + dy * std::sin(angle), y = dy * std::cos(angle) - dx * std::sin(angle);
      const double square = x * x + y * y;
      EXPECT_NEAR(square * (m * x + n * y), x * y, 0.05 * (1 + square));
    }
}

TEST(InstantReply, SaysWhereThereIsNone) {
  const json told = reply(
      R"({"pivots": {"input_center": [0, 0], "input_circle": [1, 0], "output_center": [4, 0], "output_circle": [3, 0]}})");
  EXPECT_TRUE(told["instant"].contains("degenerate"));
  EXPECT_FALSE(told.contains("circling_points"));
  EXPECT_TRUE(reply(R"({"pivots": {}})").contains("mistakes"));
}

}  // namespace
}  // namespace linkwright::wasm::instant_reply_test
