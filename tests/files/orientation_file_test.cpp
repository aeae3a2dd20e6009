#include "linkwright/files/orientation_file.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "linkwright/core/angle.hpp"
#include "support/attitude_case.hpp"

namespace linkwright::orientation_file_test {
namespace {

using testing::attitude_cases;
using testing::AttitudeCase;
using testing::ulps_between;

Result<OrientationTask> read(const std::string& orientation) {
  return read_orientation_task(R"({"linkwright": 1, "orientation": )" + orientation + "}");
}

std::string text_of(const UnitQuaternion& q) {
  return nlohmann::json({{"quaternion", {q.w(), q.v().x, q.v().y, q.v().z}}}).dump();
}

TEST(OrientationFile, WritesWhatTheWorkedRotationsSay) {
  for (const AttitudeCase& row : attitude_cases()) {
    const auto task = read(text_of(row.input));
    ASSERT_TRUE(task.ok());
    const auto written = nlohmann::json::parse(write_orientation_report(orientation_report(*task)));
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        EXPECT_LE(ulps_between(written["matrix"][i][j].get<double>(), row.matrix(i, j)), 4) << row.name;
      }
    }
    EXPECT_EQ(written["axis_defined"].get<bool>(), row.axis.has_value()) << row.name;
    EXPECT_EQ(written["rodrigues"].is_null(), !row.rodrigues) << row.name;
    EXPECT_EQ(written["euler_deg"].size(), 12u);
  }
}

TEST(OrientationFile, KeepsWhatWasGiven) {
  const auto turned = read(R"({"axis": [0, 0, 5], "angle_deg": 750})");
  ASSERT_TRUE(turned.ok() && turned->orientation.turn);
  EXPECT_EQ(turned->orientation.turn->angle(), radians(750));
  EXPECT_FALSE(turned->orientation.euler);
  const auto angles = read(R"({"euler_deg": [10, 200, 30], "sequence": "3-1-3", "turning": "extrinsic"})");
  ASSERT_TRUE(angles.ok() && angles->orientation.euler);
  EXPECT_EQ(angles->orientation.euler->second, radians(200));
  EXPECT_EQ(angles->orientation.euler->sequence.turning(), Turning::extrinsic);
  const auto nearest = read(R"({"matrix": [[2, 0, 0], [0, 1, 0], [0, 0, 1]], "nearest": true})");
  ASSERT_TRUE(nearest.ok() && nearest->orientation.nearest_distance);
  EXPECT_DOUBLE_EQ(*nearest->orientation.nearest_distance, 1);
}

TEST(OrientationFile, SmallTurnsKeepTheirDigits) {
  const auto task = read(R"({"rotation_vector": [1e-30, 2e-30, -2e-30]})");
  ASSERT_TRUE(task.ok());
  const OrientationReport report = orientation_report(*task);
  EXPECT_NEAR(report.turn.angle(), 3e-30, 1e-45);
  EXPECT_EQ(report.rotation_vector.vector().y, 2e-30);
}

TEST(OrientationFile, MistakesNameTheirPlace) {
  const std::pair<const char*, const char*> cases[] = {
      {R"({"axis": [0, 0, 0], "angle_deg": 1})", "orientation.axis"},
      {R"({"matrix": [[1, 0, 0], [0, 1, 0], [0, 0, -1]]})", "orientation.matrix"},
      {R"({"euler_deg": [1, 2, 3], "sequence": "xyy"})", "orientation.sequence"},
      {R"({"mrp": [0, 0, 0], "nearest": true})", "orientation.nearest"},
      {R"({"turns": [{"axis": [0, 0, 1], "angle_deg": 1}, 7]})", "orientation.turns[1]"},
      {R"(null)", "orientation"},
  };
  for (const auto& [orientation, place] : cases) {
    const auto task = read(orientation);
    ASSERT_FALSE(task.ok()) << orientation;
    EXPECT_EQ(task.errors().front().place, place) << orientation;
    EXPECT_FALSE(task.errors().front().message.empty());
  }
}

TEST(OrientationFile, EveryMistakeIsTold) {
  const auto task = read_orientation_task(
      R"({"linkwright": 1, "orientation": {"axis": [0, 1], "angle_deg": "x"}, "vectors": [1], "more": 2})");
  ASSERT_FALSE(task.ok());
  EXPECT_EQ(task.errors().size(), 4u);
}

}  // namespace
}  // namespace linkwright::orientation_file_test
