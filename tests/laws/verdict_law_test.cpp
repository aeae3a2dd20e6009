// The closed-form verdicts against driving, and what must not change them.

#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <random>

#include "linkwright/analysis/defects.hpp"
#include "linkwright/analysis/drive_through.hpp"
#include "linkwright/planar/burmester_curve.hpp"
#include "support/random_task.hpp"

namespace linkwright {
namespace {

using testing::uniform;

std::optional<FourBar> random_pair(const BurmesterCurve& curve, std::mt19937_64& random) {
  const Dyad a = curve.dyad(uniform(random, 0, curve.coordinate_length()));
  const Dyad b = curve.dyad(uniform(random, 0, curve.coordinate_length()));
  const auto p = finite_point(a.center), q = finite_point(a.circle), r = finite_point(b.center),
             s = finite_point(b.circle);
  if (!p || !q || !r || !s) return std::nullopt;
  return FourBar{*p, *q, *r, *s};
}

// Whether rounding decides: the type by a hair, or a joint stretched at a pose by a hair.
bool is_borderline(const FourBar& bars, const std::vector<PrescribedPose>& poses) {
  const GrashofExcesses t = grashof_excesses(bars.lengths());
  double least = std::min({std::abs(t.t1), std::abs(t.t2), std::abs(t.t3)}) / bars.lengths().perimeter();
  const auto sine = [](Point u, Point v) { return std::abs(cross(u, v)) / (std::abs(u) * std::abs(v)); };
  for (const PrescribedPose& pose : poses) {
    const Point a = displaced(bars.input_circle, poses[0].pose, pose.pose);
    const Point b = displaced(bars.output_circle, poses[0].pose, pose.pose);
    const Point frame = bars.output_center - bars.input_center;
    least = std::min({least, sine(frame, a - bars.input_center), sine(a - bars.input_center, b - a),
                      sine(b - a, bars.output_center - b)});
  }
  return least < 1e-7;
}

TEST(VerdictLaw, TwentyThousandPairsDriveAsTheSignsSay) {
  std::mt19937_64 random(2024);
  int verdicts = 0, borderline = 0;
  std::map<int, int> of_kind;
  while (verdicts < 20'000) {
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
  for (const int bits : {0, 1, 2, 6}) EXPECT_GT(of_kind[bits], 300) << bits;
}

}  // namespace
}  // namespace linkwright
