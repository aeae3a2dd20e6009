#include "linkwright/files/twist_file.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace linkwright::twist_file_test {
namespace {

Result<TwistTask> read(const std::string& twist) {
  return read_twist_task(R"({"linkwright": 1, "points": [[1, 0, 0]], "twist": )" + twist + "}");
}

nlohmann::json report_of(const std::string& twist) {
  const auto task = read(twist);
  EXPECT_TRUE(task.ok());
  const auto report = twist_report(*task);
  EXPECT_TRUE(report.ok());
  return nlohmann::json::parse(write_twist_report(*report));
}

TEST(TwistFile, VelocitiesAndScrewSayTheSame) {
  const auto by_point = report_of(R"({"angular_velocity": [0, 0, 2], "velocity": [0, 2, 3], "at": [4, 7, 1]})");
  EXPECT_EQ(by_point["screw"]["kind"], "screw");
  EXPECT_EQ(by_point["screw"]["point"], nlohmann::json({3.0, 7.0, 0.0}));
  EXPECT_EQ(by_point["screw"]["pitch"], 1.5);
  EXPECT_EQ(by_point["velocities"][0], nlohmann::json({14.0, -4.0, 3.0}));
  EXPECT_EQ(report_of(R"({"screw": {"axis": [0, 0, 5], "point": [3, 7, 9], "rate": 2, "pitch": 1.5}})"), by_point);
  EXPECT_EQ(report_of(R"({"screw": {"axis": [0, 0, 5], "point": [3, 7, 9], "rate": 2, "slide_rate": 3}})"), by_point);
}

TEST(TwistFile, NamesWhatHasNoAxisOfItsOwn) {
  const auto sliding = report_of(R"({"velocity": [0, 0, 2]})");
  EXPECT_EQ(sliding["screw"]["kind"], "translation");
  EXPECT_TRUE(sliding["screw"]["point"].is_null());
  EXPECT_TRUE(sliding["screw"]["pitch"].is_null());
  EXPECT_EQ(report_of(R"({"velocity": [0, 0, 0]})")["screw"]["axis_defined"], false);
}

TEST(TwistFile, MistakesNameTheirPlace) {
  const std::pair<const char*, const char*> cases[] = {
      {R"({})", "twist"},
      {R"({"angular_velocity": [0, 0, 1], "screw": {"axis": [0, 0, 1]}})", "twist"},
      {R"({"velocity": [0, 1]})", "twist.velocity"},
      {R"({"velocity": [0, 0, 1e13]})", "twist.velocity"},
      {R"({"screw": {"rate": 1}})", "twist.screw.axis"},
      {R"({"screw": {"axis": [0, 0, 0]}})", "twist.screw.axis"},
      {R"({"screw": {"axis": [0, 0, 1], "pitch": 1, "slide_rate": 2}})", "twist.screw.pitch"},
      {R"({"screw": {"axis": [0, 0, 1], "slide": 2}})", "twist.screw.slide"},
  };
  for (const auto& [twist, place] : cases) {
    const auto task = read(twist);
    ASSERT_FALSE(task.ok()) << twist;
    EXPECT_EQ(task.errors().front().place, place) << twist;
  }
}

}  // namespace
}  // namespace linkwright::twist_file_test
