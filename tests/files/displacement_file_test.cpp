#include "linkwright/files/displacement_file.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "linkwright/core/angle.hpp"

namespace linkwright::displacement_file_test {
namespace {

Result<DisplacementTask> read(const std::string& displacement) {
  return read_displacement_task(R"({"linkwright": 1, "displacement": )" + displacement + "}");
}

nlohmann::json report_of(const std::string& displacement) {
  const auto task = read(displacement);
  EXPECT_TRUE(task.ok());
  const auto report = displacement_report(*task);
  EXPECT_TRUE(report.ok());
  return nlohmann::json::parse(write_displacement_report(*report));
}

TEST(DisplacementFile, AScrewComesBack) {
  const auto report = report_of(R"({"screw": {"axis": [0, 3, 0], "point": [1, 7, 0], "angle_deg": 60, "slide": -2}})");
  const auto& screw = report["screw"];
  EXPECT_EQ(screw["kind"], "general");
  EXPECT_NEAR(screw["angle_deg"].get<double>(), 60, 1e-13);
  EXPECT_NEAR(screw["slide"].get<double>(), -2, 1e-15);
  EXPECT_NEAR(screw["point"][0].get<double>(), 1, 1e-15);
  EXPECT_NEAR(screw["point"][1].get<double>(), 0, 1e-15);
  EXPECT_EQ(report["matrix"][3], nlohmann::json({0, 0, 0, 1}));
}

TEST(DisplacementFile, PosesGiveTheDisplacementBetweenThem) {
  const auto report = report_of(
      R"({"from": {"translation": [1, 2, 3]},
          "to": {"orientation": {"axis": [0, 0, 1], "angle_deg": 90}, "translation": [1, 2, 3]}})");
  EXPECT_NEAR(report["screw"]["point"][0].get<double>(), 1, 1e-14);
  EXPECT_NEAR(report["screw"]["point"][1].get<double>(), 2, 1e-14);
  EXPECT_NEAR(report["screw"]["slide"].get<double>(), 0, 1e-14);
}

TEST(DisplacementFile, TheSmallestTurnIsATurnWhereItIsExact) {
  EXPECT_EQ(report_of(R"({"screw": {"axis": [0, 0, 1], "angle_deg": 1e-40}})")["screw"]["kind"], "general");
  EXPECT_EQ(report_of(R"({"screw": {"axis": [0, 0, 1], "angle_deg": 720, "slide": 1}})")["screw"]["kind"],
            "pure_translation");
}

TEST(DisplacementFile, MistakesNameTheirPlace) {
  const std::pair<const char*, const char*> cases[] = {
      {R"({"matrix": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]})", "displacement.matrix"},
      {R"({"screw": {"axis": [0, 0, 0]}})", "displacement.screw.axis"},
      {R"({"orientation": {"quaternion": [0, 0, 0, 0]}})", "displacement.orientation.quaternion"},
      {R"({"translation": [1e13, 0, 0]})", "displacement.translation"},
      {R"({"from": {"translation": [0, 0, 0]}, "to": {}})", "displacement.to"},
      {R"({})", "displacement"},
  };
  for (const auto& [displacement, place] : cases) {
    const auto task = read(displacement);
    ASSERT_FALSE(task.ok()) << displacement;
    EXPECT_EQ(task.errors().front().place, place) << displacement;
  }
}

}  // namespace
}  // namespace linkwright::displacement_file_test
