#include "linkwright/files/pose_comparison_file.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "linkwright/core/angle.hpp"
#include "linkwright/drawing/svg_drawing.hpp"
#include "linkwright/files/analysis_file.hpp"
#include "linkwright/mechanism/coupler_curve.hpp"

namespace linkwright::pose_comparison_file_test {
namespace {

constexpr Pose lies{{1.2, 2.5}, 0.3};

StoredLinkage crank_rocker() {
  StoredLinkage linkage = *read_linkage(R"({"lengths": {"ground": 4, "input": 1, "coupler": 3, "output": 3}})");
  linkage.poses = {{lies, {}}};
  return linkage;
}

// The body at every 20° of the input, by the tree's own motion.
std::vector<Pose> steps(const StoredLinkage& linkage, int count) {
  std::vector<Pose> poses;
  const auto coupler = [](const FourBar& bars) { return std::arg(bars.output_moving - bars.input_moving); };
  const auto states = motion_cycle(linkage.four_bar, lies.origin, 19);
  for (int k = 0; k < count; ++k) {
    const MotionState& state = states[static_cast<std::size_t>(k)];
    poses.push_back({state.coupler_point, lies.angle + coupler(state.four_bar) - coupler(linkage.four_bar)});
  }
  return poses;
}

TEST(PoseComparisonFile, TellsPosesThatAreMovedOffTheMotion) {
  const StoredLinkage linkage = crank_rocker();
  std::vector<Pose> poses = steps(linkage, 12);
  const auto exact = compare_with_poses(linkage, {}, *compared_poses(poses));
  ASSERT_TRUE(exact);
  EXPECT_LT(exact->miss.error.rms, 1e-9);
  EXPECT_TRUE(exact->drive.no_defects(false));
  EXPECT_NEAR(exact->miss.at[3].input, radians(60), 1e-6);
  std::vector<Pose> shifted = poses, turned = poses;
  shifted[4].origin += Point{0.3, 0.4};
  turned[9].angle += 0.2;
  const auto off = compare_with_poses(linkage, {}, *compared_poses(shifted));
  const auto askew = compare_with_poses(linkage, {}, *compared_poses(turned));
  ASSERT_TRUE(off && askew);
  EXPECT_EQ(off->position_max_at, 4u);
  EXPECT_EQ(askew->angle_max_at, 9u);
  EXPECT_LE(off->miss.error.position_max, 0.5);
  EXPECT_GT(off->miss.error.position_max, 0.02);
  EXPECT_LE(askew->miss.error.angle_max, 0.2);
  EXPECT_EQ(off->miss.at.size(), poses.size());
}

// What is told is the least over the motion in fine steps: found without slides, circuits and assignments.
TEST(PoseComparisonFile, ErrorIsTheLeastOverTheMotionWhateverTheTurningLength) {
  const StoredLinkage linkage = crank_rocker();
  std::vector<Pose> poses = steps(linkage, 9);
  for (std::size_t j = 0; j < poses.size(); ++j) {
    poses[j].origin += 0.05 * Point{std::cos(3.0 * j), std::sin(2.0 * j)};
    poses[j].angle += 0.04 * std::sin(5.0 * j);
  }
  const auto coupler = [](const FourBar& bars) { return std::arg(bars.output_moving - bars.input_moving); };
  const auto cycle = motion_cycle(linkage.four_bar, lies.origin, 40'001);
  for (const double turning_length : {0.1, 1.0, 10.0}) {
    const auto compared = compare_with_poses(linkage, {}, *compared_poses(poses, turning_length));
    ASSERT_TRUE(compared);
    double sum = 0;
    for (const Pose& pose : poses) {
      double least = 1e300;
      for (const MotionState& state : cycle) {
        const double angle = lies.angle + coupler(state.four_bar) - coupler(linkage.four_bar);
        const double turn = turning_length * std::remainder(angle - pose.angle, two_pi);
        least = std::min(least, std::norm(state.coupler_point - pose.origin) + turn * turn);
      }
      sum += least;
    }
    EXPECT_NEAR(compared->miss.error.sum_of_squares, sum, 1e-5 * sum) << turning_length;
  }
}

TEST(PoseComparisonFile, ExactPosesCountForThemselves) {
  const StoredLinkage linkage = crank_rocker();
  const std::vector<Pose> poses = steps(linkage, 8);
  MotionTask task;
  for (const std::size_t j : {0, 3, 5, 7}) task.poses.push_back({poses[j], {}});
  const auto alone = compared_poses(task);
  ASSERT_TRUE(alone);
  EXPECT_TRUE(alone->target().exact.empty()) << "errors are told at each";
  for (const std::size_t after : {1, 1, 2}) task.near.push_back({poses[after + task.near.size()], after, {}, {}});
  task.near[1].tolerance = NearPose::Tolerance{1e-3, {}};
  task.near[1].pose.origin += Point{0.1, 0.2};
  const auto mixed = compared_poses(task);
  ASSERT_TRUE(mixed);
  EXPECT_EQ(mixed->target().exact.size(), 4u);
  const auto compared = compare_with_poses(linkage, {}, *mixed);
  ASSERT_TRUE(compared);
  EXPECT_LT(compared->miss.error.exact_residual, 1e-9);
  ASSERT_EQ(compared->miss.outside.size(), 1u);
  EXPECT_EQ(compared->miss.outside.front(), 2u);
  EXPECT_EQ(compared->position_max_at, 2u);
}

// A file says where its body is, or the caller does: the same motion, another frame on the body.
TEST(PoseComparisonFile, TheBodyLiesWhereItIsSaid) {
  StoredLinkage linkage = crank_rocker();
  const auto poses = compared_poses(steps(linkage, 8));
  EXPECT_LT(compare_with_poses(linkage, lies, *poses)->miss.error.rms, 1e-9);
  EXPECT_GT(compare_with_poses(linkage, Pose{{1.5, 2.5}, 0.3}, *poses)->miss.error.rms, 1e-2);
  EXPECT_GT(compare_with_poses(linkage, Pose{{1.2, 2.5}, 0.5}, *poses)->miss.error.angle_rms, 1e-2);
  linkage.poses.clear();
  EXPECT_EQ(compare_with_poses(linkage, {}, *poses).errors().front().code, "no_body");
  EXPECT_TRUE(compare_with_poses(linkage, lies, *poses));
  const Pose nowhere{{1.2, 2.5}, std::nan("")};
  EXPECT_EQ(compare_with_poses(linkage, nowhere, *poses).errors().front().code, "body_not_finite");
}

TEST(PoseComparisonFile, TellsPosesThatCannotBeCompared) {
  const auto code = [](const std::vector<Pose>& poses, std::optional<double> turning_length = {}) {
    const auto compared = compared_poses(poses, turning_length);
    return compared ? "" : compared.errors().front().code;
  };
  const std::vector<Pose> three = {{{0, 0}, 0}, {{1, 0}, 0.2}, {{2, 1}, 0.5}};
  EXPECT_EQ(code(three), "");
  EXPECT_EQ(code({}), "too_few_near_poses");
  EXPECT_EQ(code({three[0], three[1], three[0]}), "too_few_near_poses");
  EXPECT_EQ(code(three, 0.0), "near_turning_length");
  EXPECT_EQ(code(std::vector<Pose>(1001, three[0])), "too_many_near_poses");
  EXPECT_NE(code({three[0], three[1], {{std::nan(""), 0}, 0}}), "");
}

TEST(PoseComparisonFile, IsWrittenAsJsonTableAndPicture) {
  const StoredLinkage linkage = crank_rocker();
  LinkageAnalysis analysis = analyze(linkage);
  EXPECT_FALSE(nlohmann::json::parse(write_analysis(analysis)).contains("pose_comparison"));
  std::vector<Pose> poses = steps(linkage, 4);
  poses[2].origin += Point{0, 0.2};
  analysis.pose_comparison = *compare_with_poses(linkage, {}, *compared_poses(poses));
  const auto json = nlohmann::json::parse(write_analysis(analysis)).at("pose_comparison");
  EXPECT_EQ(json.at("at").size(), 4u);
  EXPECT_EQ(json.at("position_max_at"), 3);
  EXPECT_TRUE(json.at("in_order"));
  const std::string table = comparison_table(*analysis.pose_comparison);
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 5);
  EXPECT_EQ(table.substr(0, table.find('\n')),
            "pose,x,y,theta_deg,body_x,body_y,body_theta_deg,distance,angle_deg,input_deg");
  EXPECT_NE(draw_comparison(linkage, *analysis.pose_comparison).find("largest, at pose 3"), std::string::npos);
}

}  // namespace
}  // namespace linkwright::pose_comparison_file_test
