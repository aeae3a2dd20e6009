// The closed-form verdicts against driving, and what must not change them.

#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <random>

#include "linkwright/mechanism/defects.hpp"
#include "linkwright/mechanism/drive_through.hpp"
#include "linkwright/mechanism/pose_visits.hpp"
#include "linkwright/planar/burmester_curve.hpp"
#include "support/draws.hpp"
#include "support/random_task.hpp"
#include "support/verdict_margin.hpp"

namespace linkwright::verdict_law_test {
namespace {

using testing::draws;
using testing::uniform;

std::optional<FourBar> random_pair(const BurmesterCurve& curve, std::mt19937_64& random) {
  const Dyad a = curve.dyad(uniform(random, 0, curve.coordinate_length()));
  const Dyad b = curve.dyad(uniform(random, 0, curve.coordinate_length()));
  const auto p = finite_point(a.center), q = finite_point(a.circle), r = finite_point(b.center),
             s = finite_point(b.circle);
  if (!p || !q || !r || !s) return std::nullopt;
  return FourBar{*p, *q, *r, *s};
}

bool is_borderline(const FourBar& bars, const std::vector<PrescribedPose>& poses) {
  return testing::verdict_margin(bars, poses) < 1e-7;
}

TEST(VerdictLaw, TwentyThousandPairsDriveAsTheSignsSay) {
  std::mt19937_64 random(2024);
  int verdicts = 0, borderline = 0;
  std::map<int, int> of_kind;
  while (verdicts < draws(20'000)) {
    const auto task = testing::random_poses(random);
    const PoseConditions conditions = pose_conditions(task);
    const BurmesterCurve curve(conditions);
    const auto poses = conditions.frame.to_working(task);
    for (int k = 0; k < 10; ++k) {
      const auto bars = random_pair(curve, random);
      if (!bars) continue;
      for (const FourBar& driven : {*bars, bars->swapped()}) {
        if (is_borderline(driven, poses)) {
          ++borderline;
          continue;
        }
        const DefectReport signs = find_defects(driven, poses);
        const DriveThroughReport drive = drive_through(driven, poses);
        ASSERT_TRUE(drive.completed);
        EXPECT_EQ(signs.defects, drive.defects)
            << name(signs.type) << " signs " << int{signs.defects.bits} << " driving " << int{drive.defects.bits};
        ++of_kind[signs.defects.bits];
        ++verdicts;
      }
    }
  }
  EXPECT_LT(borderline, 20);
  // Every verdict occurs often enough to have been tested.
  for (const int bits : {0, 1, 2, 6}) EXPECT_GT(of_kind[bits], draws(300)) << bits;
}

// Whether the input hardly moves as the body passes a pose in its direction: a dead point, where rounding decides.
bool is_nearly_at_rest(const FourBar& bars, const std::vector<PrescribedPose>& poses) {
  for (const PrescribedPose& pose : poses) {
    if (pose.derivatives.empty()) continue;
    const PoseDerivative& d = pose.derivatives.front();
    const auto rate_of = [&](Point circle) {
      return d.origin + Point{0, d.angle} * (displaced(circle, poses[0].pose, pose.pose) - pose.pose.origin);
    };
    const double input = std::abs(rate_of(bars.input_moving)), output = std::abs(rate_of(bars.output_moving));
    if (input < 1e-6 * output) return true;
  }
  return false;
}

TEST(VerdictLaw, MixedPairsDriveAsTheSignsSayWithAndWithoutTheirDirections) {
  std::mt19937_64 random(2025);
  for (const auto& multiplicities : testing::mixed_patterns()) {
    int verdicts = 0, borderline = 0, only_against = 0, of_kind[8] = {};
    double worst_direction = 0;
    while (verdicts < 1500) {
      const auto task = testing::random_poses(random, multiplicities);
      const PoseConditions conditions = pose_conditions(task);
      const BurmesterCurve curve(conditions);
      const auto poses = conditions.frame.to_working(task);
      for (int k = 0; k < 10; ++k) {
        const auto bars = random_pair(curve, random);
        if (!bars) continue;
        for (const FourBar& driven : {*bars, bars->swapped()}) {
          const LinkLengths l = driven.lengths();
          const bool large = l.longest() > 1e4 * l.shortest() || l.longest() > 1e4;
          if (large || is_borderline(driven, poses) || is_nearly_at_rest(driven, poses)) {
            ++borderline;
            continue;
          }
          const DefectReport signs = find_defects(driven, poses), anyhow = find_defects(driven, poses, false);
          const DriveThroughReport drive = drive_through(driven, poses, {.respect_direction = true});
          ASSERT_TRUE(drive.completed);
          EXPECT_EQ(signs.defects, drive.defects) << pattern(poses) << ' ' << int{signs.defects.bits};
          EXPECT_EQ(anyhow.defects, drive_through(driven, poses).defects) << pattern(poses);
          worst_direction = std::max(worst_direction, drive.worst_direction_error);
          if (anyhow.defects.none() && !signs.defects.none()) ++only_against;
          if (signs.sense == DriveSense::ccw || signs.sense == DriveSense::cw) {
            EXPECT_EQ(pose_visits(driven, poses).counter_clockwise, signs.sense == DriveSense::ccw) << pattern(poses);
          }
          ++of_kind[signs.defects.bits];
          ++verdicts;
        }
      }
    }
    EXPECT_LT(borderline, 150);
    EXPECT_LT(worst_direction, 1e-4);
    const bool has_order = multiplicities.size() > 1;
    EXPECT_EQ(only_against > 15, has_order) << only_against;
    EXPECT_GT(of_kind[0], 15);
    for (const int bits : {1, 2, 6}) EXPECT_EQ(of_kind[bits] > 50, has_order) << bits;
  }
}

}  // namespace
}  // namespace linkwright::verdict_law_test
