#include "linkwright/files/angular_motion_file.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "linkwright/core/angle.hpp"

namespace linkwright::angular_motion_file_test {
namespace {

Result<AngularMotionTask> read(const std::string& motion, const std::string& more = "") {
  return read_angular_motion_task(
      R"({"linkwright": 1, "orientation": {"euler_deg": [10, 20, 30], "sequence": "zxz"}, "motion": )" + motion + more +
      "}");
}

nlohmann::json written(const Result<AngularMotionTask>& task) {
  EXPECT_TRUE(task.ok());
  const auto report = angular_motion_report(*task);
  EXPECT_TRUE(report.ok());
  return nlohmann::json::parse(write_angular_motion_report(*report));
}

TEST(AngularMotionFile, EveryFormComesBack) {
  const auto first = written(read(R"({"velocity": [1, 2, 3], "acceleration": [4, 5, 6]})"));
  for (const nlohmann::json& motion :
       {nlohmann::json{{"matrix_first", first["matrix_first"]}, {"matrix_second", first["matrix_second"]}},
        nlohmann::json{{"quaternion_first", first["quaternion_first"]},
                       {"quaternion_second", first["quaternion_second"]}},
        nlohmann::json{{"euler_rates_deg", first["given_angles"]["rates_deg"]},
                       {"euler_accelerations_deg", first["given_angles"]["accelerations_deg"]}}}) {
    const auto task = read(motion.dump());
    ASSERT_TRUE(task.ok()) << motion;
    EXPECT_LT(norm(task->in_i.velocity - Vector3{1, 2, 3}), 1e-13) << motion;
    EXPECT_LT(norm(task->in_i.acceleration - Vector3{4, 5, 6}), 1e-12) << motion;
  }
}

TEST(AngularMotionFile, TheFrameOfTheVectorsCounts) {
  const auto moving = read(R"({"velocity": [0, 0, 1], "frame": "moving"})");
  ASSERT_TRUE(moving.ok());
  EXPECT_LT(norm(moving->in_i.velocity - moving->orientation.rotation.matrix().column(2)), 1e-15);
}

TEST(AngularMotionFile, PointsAndStep) {
  const auto report =
      written(read(R"({"velocity": [0, 0, 2]})", R"(, "points": [{"position": [1, 0, 0]}, {}], "step": 0.5)"));
  EXPECT_EQ(report["points"].size(), 2u);
  EXPECT_NEAR(report["points"][0]["acceleration"][0].get<double>(),
              -4 * report["points"][0]["position"][0].get<double>(), 1e-15);
  EXPECT_EQ(report["after_step"]["step"], 0.5);
}

TEST(AngularMotionFile, MistakesNameTheirPlace) {
  const std::pair<const char*, const char*> cases[] = {
      {R"({"velocity": [0, 0]})", "motion.velocity"},
      {R"({"matrix_first": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]})", "motion.matrix_first"},
      {R"({"matrix_first": [[0, 0, 0], [0, 0, 0], [0, 0, 0]], "matrix_second": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]})",
       "motion.matrix_second"},
      {R"({"quaternion_second": [0, 0, 0, 0]})", "motion.quaternion_first"},
      {R"({"frame": "fixed"})", "motion"},
      {R"([])", "motion"},
  };
  for (const auto& [motion, place] : cases) {
    const auto task = read(motion);
    ASSERT_FALSE(task.ok()) << motion;
    EXPECT_EQ(task.errors().front().place, place) << motion;
  }
}

}  // namespace
}  // namespace linkwright::angular_motion_file_test
