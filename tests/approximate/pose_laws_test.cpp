#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "linkwright/approximate/pose_fit.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/coupler_curve.hpp"
#include "support/curve_case.hpp"
#include "support/random_four_bar.hpp"

// What holds of fits to poses whatever the poses: beside what pose_fit_test asks of known ones.
namespace linkwright::pose_laws_test {
namespace {

PoseFitOptions quick() {
  PoseFitOptions options;
  options.effort = FitEffort::quick;
  return options;
}

PoseTarget tailgate() {
  PoseTarget target = testing::pose_case("poses_tailgate8");
  target.exact.clear();
  return target;
}

struct Drawn {
  FourBar bars;
  Pose body;
  PoseTarget target;
};

// A random crank-rocker over a good third of its turn, by the tree's own motion; poses moved off by up to `noise`.
Drawn drawn(std::uint64_t seed, double noise) {
  Drawn d{testing::drawn_linkage(seed, true).bars, {}, {}};
  d.body = testing::coupler_pose(d.bars);
  d.target.turning_length = 0.6;
  testing::RandomFourBars draw(seed + 500);
  const auto coupler = [](const FourBar& bars) { return std::arg(bars.output_moving - bars.input_moving); };
  for (const MotionState& at : motion_sweep(d.bars, d.body.origin, 2.2, 12)) {
    const Point off{draw.uniform(-noise, noise), draw.uniform(-noise, noise)};
    const double turned = d.body.angle + coupler(at.four_bar) - coupler(d.bars);
    d.target.poses.push_back({at.coupler_point + off, turned + draw.uniform(-noise, noise) / 0.6});
  }
  return d;
}

double best(const PoseFits& found) {
  return found.fits.empty() ? std::numeric_limits<double>::infinity() : found.fits.front().error.rms;
}

// Moved, turned by a similarity of size |turn|; mirrored first, or not.
PoseTarget transformed(PoseTarget target, Point turn, Point shift, bool mirror) {
  for (Pose& pose : target.poses) {
    if (mirror) pose = {std::conj(pose.origin), -pose.angle};
    pose = {turn * pose.origin + shift, pose.angle + std::arg(turn)};
  }
  target.turning_length *= std::abs(turn);
  return target;
}

TEST(PoseLaws, NeitherFrameNorUnitNorMirrorNorOrderMatters) {
  for (const PoseTarget& target : {tailgate(), testing::pose_case("poses_hsieh1"), drawn(4, 0.02).target}) {
    const double error = best(fit_poses(target, quick()));
    for (const double size : {1e-6, 1.0, 1e6})
      for (const bool mirror : {false, true}) {
        const Point shift{3 * size * target.turning_length, -5 * size * target.turning_length};
        const PoseTarget other = transformed(target, std::polar(size, 0.7), shift, mirror);
        EXPECT_NEAR(best(fit_poses(other, quick())) / size, error, 0.01 * error) << size << mirror;
      }
    PoseTarget reversed = target;
    std::reverse(reversed.poses.begin(), reversed.poses.end());
    EXPECT_NEAR(best(fit_poses(reversed, quick())), error, 0.01 * error);
  }
}

// A wider bound allows all that a narrower one does; but a search from a fixed number of starts may miss it: in 1 step
// of 40 by more than one per cent (docs/theory/approximate.md, section 13).
TEST(PoseLaws, LongerLinksAreNeverWorse) {
  std::vector<PoseTarget> targets = {tailgate(), testing::pose_case("poses_hsieh1")};
  for (std::uint64_t seed = 1; seed <= 3; ++seed) targets.push_back(drawn(seed, 0.02).target);
  int above = 0;
  for (std::size_t k = 0; k < targets.size(); ++k) {
    double before = std::numeric_limits<double>::infinity();
    for (const double longest : {1.5, 3.0, 8.0, 60.0}) {
      PoseFitOptions options;
      options.max_length = longest;
      const double error = best(fit_poses(targets[k], options));
      EXPECT_LE(error, 1.3 * before) << k << " " << longest;
      above += error > 1.01 * before ? 1 : 0;
      before = error;
    }
  }
  EXPECT_LE(above, 2);
}

TEST(PoseLaws, FollowPosesThroughTheirNoise) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Drawn d = drawn(seed, 0.02);
    const auto itself = compare_with_poses(d.bars, d.body, d.target);
    ASSERT_TRUE(itself);
    const double error = best(fit_poses(d.target, quick()));
    EXPECT_LE(error, 1.02 * itself->error.rms) << seed << ": the linkage itself is one of those looked for";
    EXPECT_GT(error, 0.2 * itself->error.rms) << seed << ": ten numbers take out some of 24";
  }
}

// Driven by the tree's own motion, by the turns that are told, the body comes where it is told.
TEST(PoseLaws, TurningTheInputLeadsWhereItIsTold) {
  int fits = 0, stopped = 0;
  const auto leads_there = [](const PoseFit& fit, double size) {
    for (std::size_t j = 1; j < fit.states.size(); ++j) {
      const double turn = fit.states[j].input_angle - fit.states[0].input_angle;
      const auto way =
          motion_sweep(fit.bars, fit.states[0].body.origin, turn, 2 + static_cast<int>(400 * std::abs(turn)));
      if (!(std::abs(way.back().coupler_point - fit.states[j].body.origin) < 1e-5 * size)) return false;
    }
    return true;
  };
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const PoseTarget target = drawn(seed, 0.01 + 0.01 * static_cast<double>(seed % 3)).target;
    const PoseFits found = fit_poses(target, quick());
    for (const PoseFit& fit : found.fits) {
      EXPECT_TRUE(leads_there(fit, target.scale())) << seed;
      ++fits;
    }
    const auto& defective = found.smallest_with_defects;
    if (!defective || !defective->drive.one_circuit || defective->drive.input_drives) continue;
    EXPECT_FALSE(leads_there(*defective, target.scale())) << seed << ": a dead point is on the way";
    ++stopped;
  }
  EXPECT_GT(fits, 30);
  EXPECT_GT(stopped, 0);
}

TEST(PoseLaws, StrangePosesAreAnswered) {
  const PoseTarget target = drawn(2, 0.01).target;
  PoseTarget twice = target, doubled = target, tiny = target, huge = target, shifted = target, turned = target;
  twice.poses.insert(twice.poses.end(), target.poses.begin(), target.poses.end());
  doubled.poses.clear();
  for (const Pose& pose : target.poses) doubled.poses.insert(doubled.poses.end(), 2, pose);
  for (Pose& pose : tiny.poses) pose.origin *= 1e-100;
  tiny.turning_length *= 1e-100;
  for (Pose& pose : huge.poses) pose.origin *= 1e100;
  huge.turning_length *= 1e100;
  for (Pose& pose : shifted.poses) pose.angle = 0.3;
  for (Pose& pose : turned.poses) pose.origin = {1, 2};
  for (const PoseTarget& strange : {twice, doubled, tiny, huge, shifted, turned}) {
    for (const PoseFit& fit : fit_poses(strange, quick()).fits) {
      EXPECT_TRUE(std::isfinite(fit.error.rms) && std::isfinite(fit.error.angle_max));
      EXPECT_TRUE(std::isfinite(fit.bars.lengths().perimeter()));
      EXPECT_TRUE(fit.drive.no_defects(false));
    }
  }
  const double error = best(fit_poses(target, quick()));
  EXPECT_NEAR(best(fit_poses(doubled, quick())), error, 0.01 * error) << "the same poses, of twice the weight";
}

}  // namespace
}  // namespace linkwright::pose_laws_test
