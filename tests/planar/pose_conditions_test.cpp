#include "linkwright/planar/pose_conditions.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "support/planar_case.hpp"
#include "support/random_task.hpp"

namespace linkwright::pose_conditions_test {
namespace {

using testing::planar_case;
using testing::planar_cases;

TEST(PoseConditions, CasesAgreeInScaleConditionAndRank) {
  for (const auto& c : planar_cases()) {
    if (c.name == "tiny_1e-6") continue;  // beyond the arithmetic on purpose
    const PoseConditions conditions = pose_conditions(c.poses);
    EXPECT_EQ(conditions.rank, c.json["rank"]) << c.name;
    if (conditions.only_translations) continue;  // the case's L is √3 times ours: a norm where ours is a mean
    EXPECT_NEAR(conditions.frame.scale / c.json["working_frame"]["scale"].get<double>(), 1, 1e-12) << c.name;
    EXPECT_NEAR(conditions.condition() / c.json["condition"].get<double>(), 1, 1e-6) << c.name;
  }
}

TEST(PoseConditions, AreSeenFromAPoleThatIsNearlyShared) {
  std::mt19937_64 random(1);
  for (const double deviation : {1e-5, 1e-7, 1e-9}) {
    const auto poses = testing::nearly_common_pole(random, deviation);
    const PoseConditions conditions = pose_conditions(poses);
    EXPECT_GT(conditions.condition(), 0.1 / deviation);
    ASSERT_TRUE(conditions.near_pole) << deviation;
    const PoleFrame& view = *conditions.near_pole;
    EXPECT_EQ(view.rows.size(), 3u);
    const Point pole = conditions.frame.to_user(view.frame.origin);
    double miss = 0;
    for (const PrescribedPose& pose : poses) {
      const Point turned = pole + direction(pose.pose.angle - poses[0].pose.angle) * (poses[0].pose.origin - pole);
      miss = std::max(miss, std::abs(pose.pose.origin - turned));
    }
    EXPECT_NEAR(conditions.frame.scale * view.deviation / miss, 1, 1e-5);
    EXPECT_LT(miss, 5 * deviation);
  }
}

TEST(PoseConditions, OfOtherTasksAreNotSeenFromAPole) {
  for (const auto& c : planar_cases()) EXPECT_FALSE(pose_conditions(c.poses).near_pole) << c.name;
  std::mt19937_64 random(2);
  EXPECT_FALSE(pose_conditions(testing::nearly_common_pole(random, 1e-2)).near_pole);
  EXPECT_FALSE(pose_conditions(testing::nearly_common_pole(random, 0)).near_pole);
}

// The bilinear form must be what it stands for: half the change of the squared distance.
TEST(PoseConditions, VanishExactlyWhereTheDistanceIsKept) {
  std::mt19937_64 random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const auto poses = testing::random_poses(random, 2);
    const PoseConditions conditions = pose_conditions(poses);
    const auto working = conditions.frame.to_working(poses);
    const Point z{testing::uniform(random, -1, 1), testing::uniform(random, -1, 1)};
    const Point c{testing::uniform(random, -1, 1), testing::uniform(random, -1, 1)};
    const Point moved = displaced(z, working[0].pose, working[1].pose);
    const double change = (std::norm(moved - c) - std::norm(z - c)) / 2;
    // The row was scaled to unit length: its sign and size are lost, its zeros and ratios are not.
    const Point moved_mid = (z + moved) / 2.0, normal = Point{0, 1} * (moved - z);
    const Point on_bisector = moved_mid + 0.7 * normal;
    const Homogeneous unit_z = Homogeneous::of(z);
    EXPECT_NEAR(dot(unit_z, conditions.rows[0] * Homogeneous::of(on_bisector)), 0, 1e-14);
    const double form = dot(unit_z, conditions.rows[0] * Homogeneous::of(c));
    const double other_form = dot(unit_z, conditions.rows[0] * Homogeneous::of(c + 0.3 * (moved - z)));
    const double other_change = (std::norm(moved - c - 0.3 * (moved - z)) - std::norm(z - c - 0.3 * (moved - z))) / 2;
    EXPECT_NEAR(form * other_change, other_form * change, 1e-13);
  }
}

TEST(PoseConditions, DerivativeRowsAreTheLimitOfCloseFinitePositions) {
  // Positions on one smooth motion, h apart, span the same space as their derivatives to O(h).
  const auto pose_at = [](double t) { return Pose{{std::sin(t), 0.4 * t * t}, 0.8 * t + 0.1 * t * t}; };
  const std::vector<PrescribedPose> mixed = {{pose_at(0), {{{1, 0}, 0.8}, {{0, 0.8}, 0.2}}}, {pose_at(1), {}}};
  const PoseConditions exact = pose_conditions(mixed);
  for (const double h : {1e-2, 1e-3}) {
    std::vector<PrescribedPose> close;
    for (const double t : {0.0, h, 2 * h, 1.0}) close.push_back({pose_at(t), {}});
    const PoseConditions finite = pose_conditions(close);
    for (const HomogeneousMatrix& row : finite.rows) {
      // Express the finite rows in the frame of the mixed task before comparing.
      double projected = 0, length = 0;
      const double ratio = finite.frame.scale / exact.frame.scale;
      const auto entries = [&](const HomogeneousMatrix& m, double s) {
        return std::array<double, 9>{m.row[0].w,     m.row[0].x / s,     m.row[0].y / s,
                                     m.row[1].w / s, m.row[1].x / s / s, m.row[1].y / s / s,
                                     m.row[2].w / s, m.row[2].x / s / s, m.row[2].y / s / s};
      };
      const auto a = entries(row, ratio);
      for (const double v : a) length += v * v;
      for (const HomogeneousMatrix& other : exact.rows) {
        const auto b = entries(other, 1);
        double inner = 0;
        for (std::size_t i = 0; i < 9; ++i) inner += a[i] * b[i];
        projected += inner * inner;
      }
      EXPECT_NEAR(projected / length, 1, 20 * h);
    }
  }
}

TEST(PoseConditions, SaySoWhenRowsDepend) {
  EXPECT_EQ(pose_conditions(planar_case("translations_on_circle").poses).rank, 2);
  const auto turn = [](double angle) { return PrescribedPose{{direction(angle) * Point{1, 0}, angle}, {}}; };
  EXPECT_EQ(pose_conditions({turn(0), turn(0.4), turn(1.1), turn(2)}).rank, 2);  // one common pole
}

TEST(PoseConditions, ThoseOfDerivativesAloneArePartOfAll) {
  std::mt19937_64 random(7);
  for (const auto& multiplicities : testing::mixed_patterns()) {
    const auto poses = testing::random_poses(random, multiplicities);
    const PoseConditions all = pose_conditions(poses);
    const std::vector<HomogeneousMatrix> rows = derivative_conditions(poses, all.frame);
    ASSERT_EQ(rows.size(), 4 - poses.size());
    const auto product = [](const HomogeneousMatrix& a, const HomogeneousMatrix& b) {
      return dot(a.row[0], b.row[0]) + dot(a.row[1], b.row[1]) + dot(a.row[2], b.row[2]);
    };
    for (std::size_t i = 0; i < rows.size(); ++i) {
      for (std::size_t j = 0; j <= i; ++j) EXPECT_NEAR(product(rows[i], rows[j]), i == j, 1e-14);
      double projected = 0;
      for (const HomogeneousMatrix& row : all.rows) projected += product(rows[i], row) * product(rows[i], row);
      EXPECT_NEAR(projected, 1, 1e-13);
    }
  }
  EXPECT_TRUE(derivative_conditions(testing::random_poses(random), {}).empty());
}

TEST(WorkingFrame, RoundTripsPointsDyadsAndPoses) {
  const WorkingFrame frame{{1e6, -2e6}, 350};
  const Homogeneous p{0.3, 0.1, -0.7};
  EXPECT_LT(norm(cross(frame.to_working(frame.to_user(p)), p)), 1e-9);
  EXPECT_EQ(frame.to_user(Point{0, 0}), frame.origin);
  EXPECT_FALSE(frame.finite_user_point(frame.to_user(Homogeneous{0, 1, 2})));
  EXPECT_TRUE(frame.finite_user_point(frame.to_user(Homogeneous{1e-8, 1, 2})));
  const auto poses = frame.to_working({{{{1e6 + 35, -2e6}, 0.5}, {{{70, 0}, 2}}}});
  EXPECT_NEAR(poses[0].pose.origin.real(), 0.1, 1e-12);
  EXPECT_NEAR(poses[0].derivatives[0].origin.real(), 0.2, 1e-15);
}

}  // namespace
}  // namespace linkwright::pose_conditions_test
