// A task of the plane, shrunk onto the sphere about one point, is the task of the plane: the same dyads, types, defects
// and angles. And a great many spherical verdicts against driving.

#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "linkwright/attitude/rotation_vector.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/spherical_defects.hpp"
#include "linkwright/mechanism/spherical_position.hpp"
#include "linkwright/planar/burmester_curve.hpp"
#include "linkwright/planar/four_bar_family.hpp"
#include "linkwright/spherical/axis_curve.hpp"
#include "linkwright/synthesis/solve.hpp"
#include "support/draws.hpp"
#include "support/random_task.hpp"
#include "support/solved.hpp"
#include "support/spherical_case.hpp"

namespace linkwright::sphere_law_test {
namespace {

// One unit of the plane, radians.
constexpr double unit = 1e-3;

Vector3 on_sphere(Point p) { return normalized(Vector3{unit * p.real(), unit * p.imag(), 1}); }

// The turn about z by the pose's angle, then that which carries the pole to where its origin lies.
UnitQuaternion on_sphere(const Pose& pose) {
  const Point there = unit * pose.origin;
  return RotationVector::of(Vector3{-there.imag(), there.real(), 0})->quaternion() *
         UnitQuaternion::about({0, 0, 1}, pose.angle);
}

std::vector<PrescribedOrientation> on_sphere(const std::vector<PrescribedPose>& poses) {
  std::vector<PrescribedOrientation> shrunk;
  for (const PrescribedPose& pose : poses) shrunk.push_back({on_sphere(pose.pose), {}});
  return shrunk;
}

SphericalFourBar on_sphere(const FourBar& bars) {
  return {on_sphere(bars.input_fixed), on_sphere(bars.input_moving), on_sphere(bars.output_moving),
          on_sphere(bars.output_fixed)};
}

/// Random four-bars of random tasks with pivots within 20 units.
template <class Visit>
void for_each_pair(int tasks, const Visit& visit) {
  std::mt19937_64 random(1);
  for (int i = 0; i < tasks; ++i) {
    const auto poses = testing::random_poses(random);
    const PoseConditions conditions = pose_conditions(poses);
    const auto curve = std::make_shared<const BurmesterCurve>(conditions);
    const CurveFamily family(conditions.frame, poses, curve);
    for (int k = 0; k < 40; ++k) {
      const MapPoint place{testing::uniform(random, 0, curve->coordinate_length()),
                           testing::uniform(random, 0, curve->coordinate_length())};
      const auto links = family.dyad_pair(place);
      const auto bars = links ? four_bar_of(*links) : std::nullopt;
      if (!bars || bars->lengths().longest() > 5) continue;
      const WorkingFrame& frame = conditions.frame;
      visit(poses, FourBar{frame.to_user(bars->input_fixed), frame.to_user(bars->input_moving),
                           frame.to_user(bars->output_fixed), frame.to_user(bars->output_moving)});
    }
  }
}

double margin_of(const FourBar& bars) {
  const GrashofExcesses t = grashof_excesses(bars.lengths());
  return std::min({std::abs(t.t1), std::abs(t.t2), std::abs(t.t3), bars.lengths().shortest()}) /
         bars.lengths().perimeter();
}

TEST(SphereLaw, DyadsOfASmallTaskAreThePlanes) {
  int seen = 0, far = 0;
  for_each_pair(testing::draws(60), [&](const auto& poses, const FourBar& bars) {
    const AxisCurve curve(orientation_conditions(on_sphere(poses)));
    const auto at = curve.coordinate_of(on_sphere(bars.input_moving));
    ASSERT_TRUE(at);
    const SphericalDyad dyad = curve.dyad(*at);
    const double size = 1 + std::abs(bars.input_moving) + std::abs(bars.input_fixed);
    ++seen;
    // Near a double point of the curve a dyad runs far for a small step.
    far += testing::off_line(dyad.moving_axis, on_sphere(bars.input_moving)) > 2e-2 * unit * size ||
           testing::off_line(dyad.fixed_axis, on_sphere(bars.input_fixed)) > 2e-1 * unit * size;
  });
  EXPECT_GT(seen, 20);
  EXPECT_LE(far, seen / 10);
}

TEST(SphereLaw, VerdictsOfASmallLinkageAreThePlanes) {
  int clean = 0, seen = 0;
  for_each_pair(testing::draws(400), [&](const auto& poses, const FourBar& bars) {
    if (margin_of(bars) < 1e-3) return;
    const DefectReport flat = find_defects(bars, poses), round = find_defects(on_sphere(bars), on_sphere(poses));
    const bool triple = !is_grashof(flat.type) && flat.type != LinkageType::change_point;
    EXPECT_EQ(round.type, triple ? LinkageType::triple_rocker : flat.type);
    // A moving pivot that the map carries to the sphere keeps its place to the second order only.
    if (flat.min_transmission_angle < 0.02 && flat.defects.none()) return;
    ++seen;
    if (flat.defects != round.defects) {
      double nearest = pi;  // to a dead point, in some pose
      for (const PrescribedPose& pose : poses) {
        const auto at = [&](Point p) { return displaced(p, poses.front().pose, pose.pose); };
        const FourBar moved{bars.input_fixed, at(bars.input_moving), bars.output_fixed, at(bars.output_moving)};
        for (const FourBar& side : {moved, moved.swapped()})
          nearest = std::min(nearest, transmission_angle(on_sphere(side)));
      }
      EXPECT_LT(nearest, 0.05);
      return;
    }
    if (!flat.defects.none()) return;
    ++clean;
    EXPECT_NEAR(round.min_transmission_angle, flat.min_transmission_angle, 1e-2);
    EXPECT_NEAR(round.sweep, flat.sweep, 1e-2);
  });
  EXPECT_GT(seen, testing::draws(1000) / 10);
  EXPECT_GT(clean, testing::draws(1000) / 100);
}

// Every disagreement lies next to a dead point or a change point, which rounding puts on one side or the other.
TEST(SphereLaw, VerdictsAreWhatDrivingShows) {
  std::mt19937_64 random(2);
  int clean = 0, differ = 0, looked_at = 0;
  for (int task = 0; task < testing::draws(400); ++task) {
    const auto orientations =
        task % 2 == 0 ? testing::random_sweep(random, 4) : testing::random_orientations(random, 4);
    const AxisCurve curve(orientation_conditions(orientations));
    for (int k = 0; k < 100; ++k) {
      const SphericalDyad a = curve.dyad(testing::uniform(random, 0, curve.coordinate_length())),
                          b = curve.dyad(testing::uniform(random, 0, curve.coordinate_length()));
      const SphericalFourBar bars{a.fixed_axis, a.moving_axis, b.moving_axis, b.fixed_axis};
      const DefectReport report = find_defects(bars, orientations);
      const DriveThroughReport driven = drive_through(bars, orientations, {.max_steps = 200'000});
      if (!driven.completed) continue;
      ++looked_at;
      clean += report.defects.none();
      if (driven.defects == report.defects) continue;
      ++differ;
      const SphericalExcesses t = spherical_excesses(bars.angles());
      double margin = std::min({std::abs(t.t1), std::abs(t.t2), std::abs(t.t3), std::abs(t.t4)});
      for (const double arc : bars.angles().all()) margin = std::min({margin, arc, pi - arc});
      for (const auto& there : orientations) {
        const auto at = [&](Vector3 v) { return turned(v, orientations.front().orientation, there.orientation); };
        const SphericalFourBar moved{bars.input_fixed, at(bars.input_moving), at(bars.output_moving),
                                     bars.output_fixed};
        margin = std::min({margin, transmission_angle(moved), transmission_angle(moved.swapped())});
      }
      EXPECT_LT(margin, 5e-3);
    }
  }
  EXPECT_GT(clean, looked_at / 50);
  EXPECT_LT(differ, looked_at / 500 + 3);
}

// A whole task, turned on either side, answers the same.
TEST(SphereLaw, TurnedAsAWholeTheAnswerIsTheSame) {
  std::mt19937_64 random(3);
  SynthesisOptions options;
  options.region_samples = 60;
  options.best = 3;
  for (int trial = 0; trial < testing::draws(20); ++trial) {
    const auto orientations = testing::random_sweep(random, 4);
    const auto solved = [&](const std::vector<PrescribedOrientation>& asked) {
      return testing::solved(SphericalMotionTask{asked, {}}, {}, options);
    };
    std::vector<PrescribedOrientation> moved;
    const UnitQuaternion left = UnitQuaternion::about(normalized(Vector3{1, -2, 0.5}), 1.1 + trial),
                         right = UnitQuaternion::about(normalized(Vector3{-0.3, 1, 2}), 0.7 * trial);
    for (const auto& there : orientations) moved.push_back({left * there.orientation * right, {}});
    const SphericalMotionAnswer here = solved(orientations), there = solved(moved);
    EXPECT_NEAR(static_cast<double>(here.counts.defect_free), static_cast<double>(there.counts.defect_free), 4);
    ASSERT_EQ(here.linkages.size(), there.linkages.size());
    for (std::size_t i = 0; i < here.linkages.size(); ++i)
      EXPECT_NEAR(here.linkages[i].report.min_transmission_angle, there.linkages[i].report.min_transmission_angle,
                  1e-3);
  }
}

}  // namespace
}  // namespace linkwright::sphere_law_test
