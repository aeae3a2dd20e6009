// The verdicts of maps of paths against driving: every linkage at places drawn at random.

#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <string>

#include "linkwright/mechanism/drive_through.hpp"
#include "linkwright/mechanism/pose_visits.hpp"
#include "planar/path_drive.hpp"
#include "planar/path_family.hpp"
#include "support/arm_maps.hpp"
#include "support/draws.hpp"
#include "support/path_case.hpp"
#include "support/verdict_margin.hpp"

namespace linkwright::path_verdict_law_test {
namespace {

PathTask task_named(const std::string& name) {
  if (name != "three_timed_points_and_a_pivot") return testing::path_case(name).task;
  PathTask task = testing::path_case("film_claw_timed").task;
  task.points.pop_back();
  task.pivots.input = Point{-14, 3};
  return task;
}

// Rounding decides, or links are beyond all measure.
bool is_borderline(const FourBar& bars, std::span<const PrescribedPose> poses) {
  constexpr double hair = 1e-6, largest_ratio = 1e4;
  const LinkLengths lengths = bars.lengths();
  return !(lengths.longest() < largest_ratio * lengths.shortest()) || testing::verdict_margin(bars, poses) < hair;
}

struct Compared {
  int linkages = 0, borderline = 0, clean = 0, differences = 0;
  int doubted = 0;  ///< a crank driven by its angles went another way: links of 1e4 times the path, in steps of 0.1°
};

// A crank whose angles are given gets through all points, or not.
bool passes_as_said(const PathFamily& family, const Cell& cell, const FourBar& bars, Point point) {
  const PathDrive drive =
      drive_along_path(bars, point, family.crank_poses(cell.place, bars), 1e-6 * family.frame().scale);
  return drive.passes == cell.defects.none();
}

bool has_defects_as_said(const Cell& cell, const FourBar& bars, std::span<const PrescribedPose> poses,
                         bool only_whether) {
  const DriveThroughReport drive = drive_through(bars, poses);
  return drive.completed &&
         (only_whether ? drive.defects.none() == cell.defects.none() : drive.defects == cell.defects);
}

Compared compare(const PathTask& task, int wanted) {
  const TaskFamily given = task_family(task, testing::anything(), Objective::min_transmission_angle);
  const PathFamily& family = *given.paths;
  std::mt19937_64 random(31);
  const auto somewhere = [&](Side side) {
    const double length = family.axis(side).coordinate_length();
    return std::uniform_real_distribution<double>(0, length)(random);
  };
  Compared compared;
  for (int tries = 0; compared.linkages < wanted && tries < 40 * wanted; ++tries) {
    const double input = somewhere(Side::input);
    for (const Cell& cell : family.all_at({input, somewhere(Side::output)}, true)) {
      const auto links = family.dyad_pair(cell.place);
      const auto bars = links ? four_bar_of(*links) : std::nullopt;
      if (!bars) continue;
      const FourBar user = family.frame().to_user(*bars);
      const auto poses = family.user_poses(cell.place, user);
      if (is_borderline(user, poses)) {
        ++compared.borderline;
        continue;
      }
      ++compared.linkages;
      compared.clean += cell.defects.none() ? 1 : 0;
      const bool timed = family.is_timed(),
                 passes = timed && passes_as_said(family, cell, user, task.points.front().point);
      if (passes) continue;
      compared.doubted += timed ? 1 : 0;
      compared.differences += has_defects_as_said(cell, user, poses, timed) ? 0 : 1;
    }
  }
  return compared;
}

class PathVerdictLaw : public ::testing::TestWithParam<const char*> {};

TEST_P(PathVerdictLaw, MapsSayWhatDrivingShows) {
  const int wanted = testing::draws(2'000, 100'000);
  const Compared compared = compare(task_named(GetParam()), wanted);
  RecordProperty("linkages", compared.linkages);
  RecordProperty("clean", compared.clean);
  EXPECT_GE(compared.linkages, wanted);
  EXPECT_GT(compared.clean, 0);
  EXPECT_LT(compared.borderline, compared.linkages / 5);
  EXPECT_LE(compared.doubted, compared.linkages / 20'000);
  EXPECT_EQ(compared.differences, 0) << "of " << compared.linkages;
}

INSTANTIATE_TEST_SUITE_P(Maps, PathVerdictLaw,
                         ::testing::Values("film_claw_timed", "dough_mixer_timed_full_turn",
                                           "thread_takeup_timed_mixed", "three_timed_points_and_a_pivot",
                                           "dough_mixer_five_points", "feeder_three_poses_two_points",
                                           "tailgate_four_poses_one_point", "wiper_pivots_three_points"));

}  // namespace
}  // namespace linkwright::path_verdict_law_test
