#include "planar/arm_family.hpp"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <random>
#include <string>

#include "linkwright/core/angle.hpp"
#include "linkwright/planar/four_bar_solution.hpp"
#include "planar/path_drive.hpp"
#include "support/arm_maps.hpp"
#include "support/path_case.hpp"
#include "support/random_task.hpp"

namespace linkwright::arm_family_test {
namespace {

using testing::anything;
using testing::arms_of;
using testing::curve_coordinate_of;
using testing::nearest_of;
using testing::off;
using testing::place_of;
using testing::uniform;

TaskFamily given_by(const std::shared_ptr<const ArmFamily>& family) {
  TaskFamily given;
  given.conditions.frame = family->frame();
  given.family = given.paths = family;
  return given;
}

void expect_verdict(const FourBarSolution& made, const nlohmann::json& linkage) {
  EXPECT_EQ(linkwright::name(made.report.type), linkage.at("type").get<std::string>());
  EXPECT_EQ(made.report.defects.order(), linkage.at("defects").at("order").get<bool>());
  EXPECT_EQ(made.report.defects.branch(), linkage.at("defects").at("branch").get<bool>());
  EXPECT_EQ(made.report.defects.circuit(), linkage.at("defects").at("circuit").get<bool>());
  if (!made.report.defects.none()) return;
  EXPECT_NEAR(degrees(made.report.min_transmission_angle), linkage.at("min_transmission_angle_deg"), 1e-7);
}

Point point_of(const nlohmann::json& json) { return {json[0], json[1]}; }

/// All linkages at a place of a case.
std::vector<Cell> cells_at(const ArmFamily& family, const PathTask& task, const nlohmann::json& place) {
  if (place.contains("w")) return family.all_at(place_of(task, place.at("w"), place.at("zl")), true);
  if (task.form() == PathForm::ground_pivot) return family.all_at(place_of(task, point_of(place.at("A0"))), true);
  std::vector<Cell> cells;
  const double tau = curve_coordinate_of(task, point_of(place.at("A")));
  for (const double number : family.samples(Side::output, 0, Spacing::coordinate))
    if (const auto cell = family.cell({tau, number})) cells.push_back(*cell);
  return cells;
}

// The linkages at places of the map, by an independent implementation with 40 digits: all of them, and no other.
void expect_linkages_of_case(const std::string& name) {
  const testing::PathCase c = testing::path_case(name);
  const auto family = arms_of(c.task);
  const TaskFamily given = given_by(family);
  std::map<int, std::vector<Cell>> found;
  const auto& places = c.json.at("places");
  for (std::size_t i = 0; i < places.size(); ++i) found[static_cast<int>(i) + 1] = cells_at(*family, c.task, places[i]);
  std::map<int, std::size_t> counted;
  for (const auto& linkage : c.json.at("linkages")) {
    const int place = linkage.at("place");
    ++counted[place];
    const FourBar wanted = testing::bars_of(linkage);
    EXPECT_LT(off(nearest_of(found[place], wanted), wanted), 1e-8 * wanted.lengths().longest()) << name;
  }
  for (const auto& [place, cells] : found) {
    EXPECT_EQ(cells.size(), counted[place]) << name;
    for (const Cell& cell : cells) {
      const auto made = make_four_bar(given, cell.place, true, true);
      ASSERT_TRUE(made);
      const bool is_sharp = cell.change_point_margin > 1e-4;  // closer, the way over the change point is too narrow
      EXPECT_TRUE(made->verified_by_driving || !is_sharp)
          << name << " at " << place << ": " << family->elbows_at(cell.place);
      EXPECT_LT(made->residual, 1e-9);
      for (const auto& linkage : c.json.at("linkages"))
        if (off(testing::bars_of(linkage), made->four_bar) < 1e-8 * made->lengths.longest())
          expect_verdict(*made, linkage);
    }
  }
}

TEST(ArmFamily, HasAllLinkagesOfTheCaseFiles) {
  expect_linkages_of_case("dough_mixer_five_points");
  expect_linkages_of_case("wiper_pivots_three_points");
  expect_linkages_of_case("feeder_three_poses_two_points");
  expect_linkages_of_case("tailgate_four_poses_one_point");
}

// ---- laws -----------------------------------------------------------------------------------------------------------

const PathTask& mixer() {
  static const PathTask task = testing::path_case("dough_mixer_five_points").task;
  return task;
}

TEST(ArmFamily, EveryPatternHasOneOrThree) {
  std::mt19937_64 random(7);
  const auto family = arms_of(mixer());
  for (int i = 0; i < 200; ++i) {
    std::map<int, int> of_pattern;
    for (const Cell& cell : family->all_at({uniform(random, 0.02, 0.99), uniform(random, 0.01, 0.99)}, true))
      ++of_pattern[(static_cast<int>(cell.place.input) - 1) / 3];
    for (const auto& [pattern, count] : of_pattern) EXPECT_TRUE(count == 1 || count == 3) << pattern;
    EXPECT_EQ(of_pattern.size(), 32u);
  }
}

// Arm and crank exchanged, the elbows on the other sides: the cognate on the same pivot and on C0.
TEST(ArmFamily, CognatesStandOnTheOtherSide) {
  std::mt19937_64 random(11);
  const auto family = arms_of(mixer());
  for (int i = 0; i < 50; ++i) {
    const MapPoint place{uniform(random, 0.05, 0.95), uniform(random, 0.05, 0.95)};
    const std::vector<Cell> one = family->all_at(place, true);
    const std::vector<Cell> other = family->all_at({place.input, 1 - place.output}, true);
    EXPECT_EQ(one.size(), other.size());
    for (const Cell& cell : one) {
      const FourBar bars = four_bar_of(cell.pivots);
      const Point point = mixer().points.front().point;
      const Point similar = (point - bars.input_moving) / (bars.output_moving - bars.input_moving);
      const Point center = bars.input_fixed + similar * (bars.output_fixed - bars.input_fixed);
      double least = std::numeric_limits<double>::infinity();
      for (const Cell& there : other)
        least = std::min(least, std::abs(four_bar_of(there.pivots).output_fixed - center));
      EXPECT_LT(least, 1e-6 * (1 + std::abs(center)));
    }
  }
}

const PathTask& feeder() {
  static const PathTask task = testing::path_case("feeder_three_poses_two_points").task;
  return task;
}

// A four-bar has two links that can be the arm, and stands on the map at both ground pivots.
TEST(ArmFamily, EveryLinkageAmongPosesIsThereFromItsOtherPivot) {
  std::mt19937_64 random(3);
  const auto family = arms_of(feeder());
  int seen = 0;
  for (int i = 0; i < 400; ++i)
    for (const Cell& cell : family->all_at({uniform(random, 0.02, 0.98), uniform(random, 0.02, 0.98)}, true)) {
      const FourBar bars = four_bar_of(cell.pivots);
      const FourBar turned{bars.output_fixed, bars.output_moving, bars.input_fixed, bars.input_moving};
      const auto there = family->all_at(place_of(feeder(), bars.output_fixed), true);
      EXPECT_LT(off(nearest_of(there, turned), turned), 1e-5 * bars.lengths().longest());
      ++seen;
    }
  EXPECT_GT(seen, 100);
}

// Two points found at some turns of the crank, given as timed ones, have the linkage among their pairs of cranks.
TEST(ArmFamily, APlainPointIsATimedOneAtTheTurnThatItIsPassedAt) {
  PathTask task = testing::timed_points({{0, 0, 0}, {95, 40, 70}, {150, 140, 150}});
  for (const Point p : {Point{60, 230}, Point{-70, 190}}) task.points.push_back({p, {}, {}, {}});
  const auto family = arms_of(task);
  const TaskFamily given = given_by(family);
  std::mt19937_64 random(8);
  int clean = 0;
  for (int i = 0; i < 900; ++i)
    for (const Cell& cell : family->all_at({uniform(random, 0.2, 0.8), uniform(random, 0.2, 0.8)}, true)) {
      if (!cell.defects.none()) continue;
      ++clean;
      const FourBar bars = four_bar_of(cell.pivots);
      const auto poses = family->crank_poses(cell.place, bars);
      PathTask timed = task;
      for (std::size_t j = 0; j < poses.size(); ++j) timed.points[j].input = poses[j].pose.angle;
      ASSERT_TRUE(mistakes_in(timed).empty());
      for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(poses[j].pose.angle, *task.points[j].input, 1e-9);
      const TaskFamily pairs = task_family(timed, anything(), Objective::min_transmission_angle);
      double least = std::numeric_limits<double>::infinity();
      for (const MapPoint place : pairs.paths ? pairs.paths->few_places() : std::vector<MapPoint>{})
        if (const auto one = pairs.paths->cell(place)) least = std::min(least, off(four_bar_of(one->pivots), bars));
      EXPECT_LT(least, 1e-6 * bars.lengths().longest());
    }
  EXPECT_GT(clean, 5);
}

// Nothing but its speed says how large the task is.
TEST(ArmFamily, APointThatStartsAtTheGivenPivotHasASize) {
  PathTask task;
  task.points = {{{1, 2}, 0.0, {}, {{{3, 4}, 5.0, {}}, {{0, 1}, -1.0, {}}}}};
  task.pivots.input = Point{1, 2};
  EXPECT_TRUE(mistakes_in(task).empty());
  EXPECT_EQ(arm_task(task).frame.scale, 5);
}

// To the bit: where a dyad's number changes, the last digit of the arm would make it another linkage.
TEST(ArmFamily, ALinkageIsTheSameByItsPlaceAndByItsLayer) {
  std::mt19937_64 random(4);
  for (const PathTask& task : {mixer(), feeder()}) {
    const auto family = arms_of(task);
    for (int i = 0; i < 500; ++i) {
      const auto found = family->cell({uniform(random, 0, 1), uniform(random, 0, 1)});
      if (!found) continue;
      const auto again = family->cell(found->place);
      ASSERT_TRUE(again);
      EXPECT_EQ(again->place.input, found->place.input);
      EXPECT_EQ(again->values, found->values);
    }
  }
}

// Whatever stands at a place, the cell shows the best of it.
TEST(ArmFamily, ACellShowsTheBestOfItsPlace) {
  Requirements wanted = with_default_lengths({}, arms_of(mixer())->frame().scale);
  wanted.full_turn = true;
  const auto best = arms_of(mixer(), wanted), all = arms_of(mixer());
  const CellJudge judge(wanted, path_linkages, best->measures());
  RegionMap map;
  const auto samples = best->samples(Side::input, 24, Spacing::coordinate);
  best->classify(map, samples, samples, true);
  int passing = 0;
  for (std::size_t row = 0; row < samples.size(); ++row)
    for (std::size_t column = 0; column < samples.size(); ++column) {
      double angle = -1;
      for (const Cell& cell : all->all_at({samples[row], samples[column]}, true))
        if (judge.passes(cell)) angle = std::max(angle, cell.values[0]);
      const std::size_t cell = map.index(row, column);
      const auto shown = best->cell({samples[row], samples[column]});
      ASSERT_TRUE(shown);
      EXPECT_EQ(judge.passes(*shown), angle >= 0);
      EXPECT_EQ(map.type(cell), shown->type);
      EXPECT_EQ(map.defects(cell), shown->defects);
      if (angle < 0) continue;
      ++passing;
      EXPECT_NEAR(shown->values[0], angle, 1e-12);
      EXPECT_NEAR(map.values(measures::min_transmission_angle)[cell], angle, 1e-6);
    }
  EXPECT_GT(passing, 100);
}

// The verdict of a cell against turning the crank of its four pivots.
TEST(ArmFamily, CellsAreCleanWhereTheCrankPassesThePoints) {
  const auto family = arms_of(mixer());
  std::mt19937_64 random(5);
  int clean = 0;
  for (int i = 0; i < 25; ++i)
    for (const Cell& cell : family->all_at({uniform(random, 0.05, 0.95), uniform(random, 0.05, 0.95)}, true)) {
      if (!cell.defects.none()) continue;
      ++clean;
      const FourBar bars = four_bar_of(cell.pivots);
      const PathDrive drive = drive_along_path(bars, mixer().points.front().point,
                                               family->crank_poses(cell.place, bars), 1e-6 * family->frame().scale);
      EXPECT_TRUE(drive.passes);
      EXPECT_EQ(drive.turns_fully, input_is_crank(cell.type));
    }
  EXPECT_GT(clean, 30);
}

TEST(ArmFamily, InstructionSetsAgreeToTheBit) {
  const auto family = arms_of(mixer());
  const auto samples = family->samples(Side::input, 20, Spacing::coordinate);
  RegionMap reference;
  RegionOptions options;
  options.simd = Simd::scalar;
  family->classify(reference, samples, samples, true, options);
  for (const Simd simd : {Simd::baseline, Simd::avx2, Simd::avx512}) {
    if (!is_supported(simd)) continue;
    RegionMap map;
    options.simd = simd;
    family->classify(map, samples, samples, true, options);
    for (const Measure& measure : family->measures()) {
      const auto one = reference.values(measure), other = map.values(measure);
      EXPECT_TRUE(std::equal(one.begin(), one.end(), other.begin())) << name(simd) << measure.key;
    }
  }
}

TEST(ArmFamily, AMovedTaskHasMovedLinkages) {
  const PathTask task = mixer();
  PathTask moved = task;
  const Point turn = 7.0 * direction(1.1), shift{300, -200};
  const auto move = [&](Point p) { return turn * p + shift; };
  for (PathPoint& point : moved.points) point.point = move(point.point);
  moved.pivots.input = move(*task.pivots.input);
  const auto one = arms_of(task)->all_at({0.6, 0.4}, true), other = arms_of(moved)->all_at({0.6, 0.4}, true);
  ASSERT_EQ(one.size(), other.size());
  for (const Cell& cell : one) {
    const FourBar bars = four_bar_of(cell.pivots);
    const FourBar wanted{move(bars.input_fixed), move(bars.input_moving), move(bars.output_fixed),
                         move(bars.output_moving)};
    EXPECT_LT(off(nearest_of(other, wanted), wanted), 1e-8 * wanted.lengths().longest());
  }
}

TEST(ArmFamily, APointThatComesTwiceTakesBothElbows) {
  PathTask task = mixer();
  task.points[4].point = task.points[1].point;
  const auto family = arms_of(task);
  const auto cells = family->all_at({0.5, 0.5}, true);
  EXPECT_FALSE(cells.empty());
  for (const Cell& cell : cells) {
    const int pattern = (static_cast<int>(cell.place.input) - 1) / 3;
    EXPECT_NE((pattern >> 1) & 1, (pattern >> 4) & 1);
  }
}

}  // namespace
}  // namespace linkwright::arm_family_test
