#include "planar/path_drive.hpp"

#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/planar/path_task.hpp"
#include "support/path_case.hpp"

namespace linkwright::path_drive_test {
namespace {

constexpr double near = 1e-8;  // over the longest link

// Every linkage of the case files: the crank gets through the points where the file says that it has no defect, and
// nowhere else.
TEST(PathDrive, PassesWhereThereIsNoDefect) {
  int clean = 0, with_defects = 0;
  for (const char* name : {"film_claw_timed", "dough_mixer_timed_full_turn", "thread_takeup_timed_mixed",
                           "stirrer_timed_five", "packaging_feeder_timed_five_mixed"}) {
    const testing::PathCase c = testing::path_case(name);
    for (const auto& linkage : c.json.at("linkages")) {
      const FourBar bars = testing::bars_of(linkage);
      const double size = bars.lengths().longest();
      const auto& defects = linkage.at("defects");
      const bool has_none = !defects["order"] && !defects["branch"] && !defects["circuit"];
      const PathDrive found = drive_along_path(bars, c.task.points[0].point, angled_poses(c.task), near * size);
      EXPECT_EQ(found.passes, has_none) << name << linkage.at("input").dump();
      ++(has_none ? clean : with_defects);
      if (!has_none) continue;
      EXPECT_LT(found.position_error, 1e-9 * size) << name;
      EXPECT_LT(found.timing_error, 1e-8) << name;
      const bool turns = linkage.at("type") == "crank_rocker" || linkage.at("type") == "double_crank";
      EXPECT_EQ(found.turns_fully, turns) << name;
    }
  }
  EXPECT_GT(clean, 20);
  EXPECT_GT(with_defects, 5);
}

struct Claw {
  testing::PathCase c = testing::path_case("film_claw_timed");
  FourBar bars = testing::bars_of(c.json.at("linkages")[0]);
  Point point = c.task.points[0].point;

  [[nodiscard]] PathDrive drive() const {
    return drive_along_path(bars, point, angled_poses(c.task), near * bars.lengths().longest());
  }
};

TEST(PathDrive, SeesThatThePointIsElsewhere) {
  Claw claw;
  claw.c.task.points[2].point += Point{0.01, 0};
  const PathDrive found = claw.drive();
  EXPECT_FALSE(found.passes);
  EXPECT_NEAR(found.position_error, 0.01, 1e-9);
}

// The point is where it is to be a little later: so much has the crank to turn on.
TEST(PathDrive, SeesThatThePointIsLate) {
  Claw claw;
  *claw.c.task.points[2].input -= radians(0.01);
  const PathDrive found = claw.drive();
  EXPECT_FALSE(found.passes);
  EXPECT_NEAR(found.timing_error, radians(0.01), radians(1e-5));
}

TEST(PathDrive, SeesThatThePointGoesAnotherWay) {
  testing::PathCase c = testing::path_case("thread_takeup_timed_mixed");
  const FourBar bars = testing::bars_of(c.json.at("linkages")[0]);
  const double tolerance = near * bars.lengths().longest();
  const auto drive = [&] { return drive_along_path(bars, c.task.points[0].point, angled_poses(c.task), tolerance); };
  EXPECT_TRUE(drive().passes);
  EXPECT_LT(drive().direction_error, 1e-5);
  c.task.points[0].derivatives[0].point *= direction(0.1);
  EXPECT_FALSE(drive().passes);
  EXPECT_NEAR(drive().direction_error, 0.1, 1e-5);
  c.task.points[0].derivatives[0].point *= -direction(-0.1);
  EXPECT_NEAR(drive().direction_error, pi, 1e-5) << "the other way round";
}

// A rocker stops at its dead point, and does not jump into the other assembly behind it.
TEST(PathDrive, StopsWhereTheCrankCannotGo) {
  const FourBar rocker{{0, 0}, {2, 1}, {5, 0}, {4, 1.5}};
  const std::vector<PrescribedPose> all_round = {{{{2, 2}, 0}, {}}, {{{2, 2}, 3}, {}}};
  const PathDrive found = drive_along_path(rocker, {2, 2}, all_round, 1e9);
  EXPECT_FALSE(found.passes);
  EXPECT_FALSE(found.turns_fully);
}

}  // namespace
}  // namespace linkwright::path_drive_test
