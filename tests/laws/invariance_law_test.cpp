// What must not change the answer: where the drawing lies, how big it is, which of the two grounded links is named
// first.

#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "linkwright/core/angle.hpp"
#include "linkwright/synthesis/solve.hpp"
#include "support/case_region.hpp"
#include "support/draws.hpp"
#include "support/random_task.hpp"
#include "support/solved.hpp"

namespace linkwright::invariance_law_test {
namespace {

SynthesisOptions small() {
  SynthesisOptions options;
  options.region_samples = 60;
  options.best = 3;
  return options;
}

MotionAnswer solved(const std::vector<PrescribedPose>& poses) {
  return testing::solved(MotionTask{poses, {}}, {}, small());
}

// Cells whose verdict rounding may turn.
constexpr std::int64_t borderline_cells = 6;

void expect_same_counts(const RegionCounts& a, const RegionCounts& b) {
  for (std::size_t type = 0; type < a.types.size(); ++type)
    EXPECT_LE(std::abs(a.types[type] - b.types[type]), borderline_cells);
  EXPECT_LE(std::abs(a.defect_free - b.defect_free), borderline_cells);
  EXPECT_LE(std::abs(a.circuit - b.circuit), borderline_cells);
  EXPECT_LE(std::abs(a.branch - b.branch), borderline_cells);
}

TEST(InvarianceLaw, RigidMotionAndScaleLeaveTheMapAndMoveTheLinkages) {
  std::mt19937_64 random(99);
  for (int trial = 0; trial < 25; ++trial) {
    const auto poses = testing::random_poses(random);
    const MotionAnswer before = solved(poses);
    for (const double scale : {1e-6, 1.0, 1e6}) {
      const double angle = testing::uniform(random, -pi, pi);
      const Point shift = scale * Point{testing::uniform(random, -50, 50), testing::uniform(random, -50, 50)};
      const MotionAnswer after = solved(testing::moved(poses, scale, angle, shift));
      EXPECT_NEAR(*before.given.curve->kappa(), *after.given.curve->kappa(), 1e-8);
      EXPECT_NEAR(before.given.conditions.condition() / after.given.conditions.condition(), 1, 1e-8);
      expect_same_counts(before.counts, after.counts);
      ASSERT_EQ(before.linkages.empty(), after.linkages.empty());
      if (before.linkages.empty()) continue;
      const FourBarSolution &a = before.linkages[0], &b = after.linkages[0];
      EXPECT_NEAR(a.report.min_transmission_angle, b.report.min_transmission_angle, 1e-6);
      EXPECT_NEAR(b.lengths.ground / (scale * a.lengths.ground), 1, 1e-3);
      EXPECT_NEAR(
          std::abs(b.four_bar.input_fixed - (scale * direction(angle) * a.four_bar.input_fixed + shift)) / scale, 0,
          1e-3 * (1 + std::abs(a.four_bar.input_fixed)));
    }
  }
}

TEST(InvarianceLaw, RigidMotionAndScaleLeaveTheMapOfMixedPositions) {
  std::mt19937_64 random(95);
  for (const auto& multiplicities : testing::mixed_patterns())
    for (int trial = 0; trial < testing::draws(6); ++trial) {
      const auto poses = testing::random_poses(random, multiplicities);
      const MotionAnswer before = solved(poses);
      for (const double scale : {1e-6, 1.0, 1e6}) {
        const double angle = testing::uniform(random, -pi, pi);
        const Point shift = scale * Point{testing::uniform(random, -50, 50), testing::uniform(random, -50, 50)};
        const MotionAnswer after = solved(testing::moved(poses, scale, angle, shift));
        EXPECT_EQ(after.given.pattern, before.given.pattern);
        EXPECT_NEAR(*before.given.curve->kappa(), *after.given.curve->kappa(), 1e-8);
        EXPECT_NEAR(before.given.conditions.condition() / after.given.conditions.condition(), 1, 1e-8);
        EXPECT_NEAR(after.given.conditions.frame.scale / (scale * before.given.conditions.frame.scale), 1, 1e-9);
        expect_same_counts(before.counts, after.counts);
        EXPECT_EQ(before.linkages.empty(), after.linkages.empty());
        for (const FourBarSolution& found : after.linkages) {
          EXPECT_TRUE(found.verified_by_driving);
          EXPECT_LT(*found.residual_derivatives, 1e-10);
        }
      }
    }
}

TEST(InvarianceLaw, ACellAndItsMirrorAreTheSameBarsDrivenFromTheOtherSide) {
  std::mt19937_64 random(98);
  for (int trial = 0; trial < 20; ++trial) {
    const RegionMap map = testing::region_of(testing::random_poses(random), 70);
    for (std::size_t row = 0; row < map.rows(); ++row)
      for (std::size_t column = 0; column < row; ++column) {
        const std::size_t cell = map.index(row, column), mirror = map.index(column, row);
        EXPECT_EQ(map.type(cell), swapped(map.type(mirror)));
        EXPECT_EQ(map.defects(cell).circuit(), map.defects(mirror).circuit());
        EXPECT_EQ(map.values(measures::link_ratio)[cell], map.values(measures::link_ratio)[mirror]);
        EXPECT_EQ(map.values(measures::longest_link)[cell], map.values(measures::longest_link)[mirror]);
      }
  }
}

TEST(InvarianceLaw, WholeTurnsAddedToAPoseChangeNothing) {
  std::mt19937_64 random(97);
  auto poses = testing::random_poses(random);
  const MotionAnswer before = solved(poses);
  poses[1].pose.angle += two_pi;
  poses[3].pose.angle -= 2 * two_pi;
  expect_same_counts(before.counts, solved(poses).counts);
}

TEST(InvarianceLaw, VisitingThePosesBackwardsTurnsTheDriveRound) {
  // The curve of dyads is the same set; only circle points are told in another position.
  std::mt19937_64 random(96);
  for (int trial = 0; trial < 10; ++trial) {
    auto poses = testing::random_poses(random);
    const MotionAnswer forwards = solved(poses);
    std::reverse(poses.begin(), poses.end());
    const MotionTask backwards{poses};
    for (const FourBarSolution& linkage : forwards.linkages) {
      const FourBar& f = linkage.four_bar;
      const Pose &first = poses.back().pose, &last = poses.front().pose;
      const FourBar from_last{f.input_fixed, displaced(f.input_moving, first, last), f.output_fixed,
                              displaced(f.output_moving, first, last)};
      const DefectReport report = find_defects(from_last, poses);
      EXPECT_EQ(report.type, linkage.report.type);
      EXPECT_EQ(report.defects, linkage.report.defects);
      EXPECT_NEAR(report.sweep, linkage.report.sweep, 1e-9);
      EXPECT_NE(report.sense, linkage.report.sense);
    }
  }
}

// What is measured by the characteristic length depends on the frame on purpose: here the lengths are given.
TEST(InvarianceLaw, WhereTheBodysFrameLiesDoesNotChangeTheListOfLinkages) {
  std::mt19937_64 random(11);
  SynthesisOptions options;
  options.region_samples = 120;
  Requirements wanted;
  wanted.max_length = 30;
  wanted.min_length = 0.05;
  std::size_t compared = 0;
  for (int trial = 0; trial < 40; ++trial) {
    options.objective = static_cast<Objective>(trial % 3);
    wanted.no_defects = trial % 2 == 0;
    const MotionTask task{testing::random_poses(random), {}};
    MotionTask other = task;
    const Point offset{testing::uniform(random, -5, 5), testing::uniform(random, -5, 5)};
    const double turn = testing::uniform(random, -pi, pi);
    for (PrescribedPose& pose : other.poses) {
      pose.pose.origin += direction(pose.pose.angle) * offset;
      pose.pose.angle += turn;
    }
    const MotionAnswer one = testing::solved(task, wanted, options), two = testing::solved(other, wanted, options);
    ASSERT_EQ(one.linkages.size(), two.linkages.size()) << trial;
    for (std::size_t i = 0; i < one.linkages.size(); ++i) {
      const FourBarSolution &a = one.linkages[i], &b = two.linkages[i];
      const auto score = [&](const FourBarSolution& found) {
        return rank_of(options.objective, planar_measures)
            .score({found.report.type,
                    {},
                    {versine_of_angle(found.report.min_transmission_angle), 0,
                     found.lengths.longest() / found.lengths.shortest(), found.lengths.longest()}});
      };
      EXPECT_EQ(a.local_optimum, b.local_optimum) << trial << ' ' << i;
      EXPECT_NEAR(score(a), score(b), (a.local_optimum ? 1e-5 : 1e-3) * std::abs(score(a))) << trial << ' ' << i;
      ++compared;
    }
  }
  EXPECT_GT(compared, 100u);
}

}  // namespace
}  // namespace linkwright::invariance_law_test
