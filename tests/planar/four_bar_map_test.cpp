#include "linkwright/planar/four_bar_map.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <new>
#include <random>

#include "linkwright/core/angle.hpp"
#include "linkwright/planar/burmester_curve.hpp"
#include "linkwright/planar/four_bar_family.hpp"
#include "support/case_coordinates.hpp"
#include "support/case_region.hpp"
#include "support/draws.hpp"
#include "support/planar_case.hpp"
#include "support/random_task.hpp"

namespace linkwright::four_bar_map_test {
namespace {

using testing::planar_case;
using testing::planar_cases;
using testing::region_of;

const std::map<std::string, LinkageType> case_types = {
    {"GCRR", LinkageType::crank_rocker},          {"GRRC", LinkageType::rocker_crank},
    {"GCCC", LinkageType::double_crank},          {"GRCR", LinkageType::double_rocker},
    {"RRR1", LinkageType::triple_rocker_ground},  {"RRR2", LinkageType::triple_rocker_input},
    {"RRR3", LinkageType::triple_rocker_coupler}, {"RRR4", LinkageType::triple_rocker_output},
    {"change-point", LinkageType::change_point}};

// An independent count of the same cells, driven from either side; cells that rounding decides may differ.
void expect_counts(const nlohmann::json& theirs, const RegionCounts& ours, const std::string& name) {
  const std::int64_t slack = theirs["borderline_type"];
  for (const auto& [key, type] : case_types)
    EXPECT_LE(std::abs(theirs["types"][key].get<std::int64_t>() - ours.types[static_cast<std::size_t>(type)]), slack)
        << name << " " << key;
  EXPECT_LE(std::abs(theirs["circuit_defect"].get<std::int64_t>() - ours.circuit), slack) << name;
  EXPECT_LE(std::abs(theirs["branch_defect"].get<std::int64_t>() - ours.branch), slack) << name;
  EXPECT_LE(std::abs(theirs["defect_free"].get<std::int64_t>() - ours.defect_free), slack) << name;
}

// The dyads of a case's region. Where a circle point has a whole line of centres, the case's own choice among them.
std::vector<Dyad> case_dyads(const testing::PlanarCase& c, const BurmesterCurve& curve,
                             const std::vector<double>& theirs) {
  const std::vector<double> ours = our_coordinates(c, curve, theirs);
  std::vector<Dyad> dyads;
  for (std::size_t i = 0; i < ours.size(); ++i) {
    dyads.push_back(curve.dyad(ours[i]));
    for (const Homogeneous p : curve.circle_curve().double_points())
      for (const auto& sample : c.json["circle_point_curve"]["samples_homogeneous_working_frame"])
        if (great_circle(p, dyads.back().circle) < 1e-9 && std::abs(sample["tau"].get<double>() - theirs[i]) < 1e-12)
          dyads.back().center = {sample["C"][0], sample["C"][1], sample["C"][2]};
  }
  return dyads;
}

TEST(FourBarMap, CasesAgreeInEveryCountAndInTheBestTransmissionAngle) {
  int compared = 0;
  for (const auto& c : planar_cases()) {
    const auto region = c.json.value("solution_region", nlohmann::json::object());
    if (!region.contains("driver_A") || c.name == "tiny_1e-6") continue;
    const BurmesterCurve curve(pose_conditions(c.poses));
    std::vector<double> theirs;
    const int n = region["N"];
    const double branches = c.json["circle_point_curve"]["branches"];
    for (int i = 0; i < n; ++i) theirs.push_back(branches * (i + 0.5) / n);
    const RegionMap map = region_of(c.poses, testing::axis_of(c.poses, case_dyads(c, curve, theirs)));
    expect_counts(region["driver_A"], map.counts(), c.name);
    ++compared;
    const bool has_best = region["driver_A"].contains("best_gamma_task");
    double best = 0;
    for (std::size_t cell = 0; cell < map.types().size(); ++cell)
      if (has_best || map.defects(cell).none()) best = std::max(best, map.min_transmission_angle(cell));
    if (!has_best || c.name == "tiny_1e-2") continue;
    EXPECT_NEAR(degrees(best), region["driver_A"]["best_gamma_task"]["gamma_deg"].get<double>(), 1e-4) << c.name;
  }
  EXPECT_GE(compared, 18);
}

TEST(FourBarMap, EveryInstructionSetGivesTheSameBits) {
  for (const char* name : {"landing_gear", "drawer_hinge", "cardan", "mixed_PP-PP", "mixed_PPPP", "mixed_P-PPP"})
    for (const int samples : {8, 9, 101, 333}) {
      const RegionMap scalar = region_of(planar_case(name).poses, samples, {1, Simd::scalar});
      for (const Simd simd : {Simd::baseline, Simd::avx2, Simd::avx512}) {
        if (!is_supported(simd)) continue;
        const RegionMap other = region_of(planar_case(name).poses, samples, {1, simd});
        EXPECT_TRUE(std::ranges::equal(scalar.types(), other.types())) << name << samples << linkwright::name(simd);
        EXPECT_TRUE(std::ranges::equal(scalar.defects(), other.defects()));
        EXPECT_TRUE(std::ranges::equal(scalar.values(measures::min_transmission_angle),
                                       other.values(measures::min_transmission_angle)));
        EXPECT_TRUE(std::ranges::equal(scalar.values(measures::min_transmission_angle_full_turn),
                                       other.values(measures::min_transmission_angle_full_turn)));
        EXPECT_TRUE(std::ranges::equal(scalar.values(measures::link_ratio), other.values(measures::link_ratio)));
        EXPECT_TRUE(std::ranges::equal(scalar.values(measures::longest_link), other.values(measures::longest_link)));
      }
    }
}

TEST(FourBarMap, ThreadsDoNotShowInTheResult) {
  const RegionMap one = region_of(planar_case("landing_gear").poses, 301, {1, Simd::automatic});
  const RegionMap many = region_of(planar_case("landing_gear").poses, 301, {0, Simd::automatic});
  EXPECT_TRUE(std::ranges::equal(one.types(), many.types()));
  EXPECT_TRUE(std::ranges::equal(one.defects(), many.defects()));
  EXPECT_TRUE(
      std::ranges::equal(one.values(measures::min_transmission_angle), many.values(measures::min_transmission_angle)));
}

TEST(FourBarMap, CellsAgreeWithTheSingleLinkage) {
  const auto& poses = planar_case("landing_gear").poses;
  const PoseConditions conditions = pose_conditions(poses);
  const auto working = conditions.frame.to_working(poses);
  const DyadAxis axis = testing::axis_of(poses, 120);
  const RegionMap map = region_of(poses, axis);
  for (std::size_t row = 0; row < map.rows(); row += 3)
    for (std::size_t column = 0; column < map.columns(); ++column) {
      if (row == column) continue;
      const Dyad a = axis.dyads[row], b = axis.dyads[column];
      const FourBar bars{*finite_point(a.center), *finite_point(a.circle), *finite_point(b.center),
                         *finite_point(b.circle)};
      const DefectReport report = find_defects(bars, working);
      const std::size_t cell = map.index(row, column);
      ASSERT_EQ(map.type(cell), report.type);
      ASSERT_EQ(map.defects(cell), report.defects);
      ASSERT_EQ(map.drive_sense(row, column), report.sense);
      EXPECT_NEAR(map.min_transmission_angle(cell), report.min_transmission_angle, 1e-6);
      EXPECT_NEAR(map.driver_sweep(row, column), report.sweep, 1e-6);
      const LinkLengths lengths = bars.lengths();
      EXPECT_NEAR(
          static_cast<double>(map.values(measures::link_ratio)[cell]) / (lengths.longest() / lengths.shortest()), 1,
          1e-6);
      EXPECT_NEAR(
          static_cast<double>(map.values(measures::longest_link)[cell]) / (lengths.longest() * conditions.frame.scale),
          1, 1e-6);
    }
}

// Beside find_defects without respect for directions; counts the senses that were met.
void expect_senses_of_pairs(const RegionMap& map, const DyadAxis& axis, const std::vector<PrescribedPose>& working,
                            std::array<int, 4>& met) {
  for (std::size_t row = 0; row < map.rows(); ++row)
    for (std::size_t column = 0; column < map.columns(); ++column) {
      const auto bars = four_bar_of({axis.dyads[row], axis.dyads[column]});
      if (row == column || !bars) continue;
      const DefectReport report = find_defects(*bars, working, false);
      ASSERT_EQ(map.drive_sense(row, column), report.sense) << row << " " << column;
      ASSERT_NEAR(map.driver_sweep(row, column), report.sweep, 1e-6);
      ++met[static_cast<std::size_t>(report.sense)];
    }
}

// Two poses come in order whichever way the driver turns; which ways it can go is for the pair to say.
TEST(FourBarMap, TwoPosesArePassedInTheSenseThatThePairAllows) {
  std::array<int, 4> met{};
  std::mt19937_64 random(17);
  for (int trial = 0; trial < 6; ++trial)
    for (const Simd simd : {Simd::scalar, Simd::automatic}) {
      const auto poses = testing::random_poses(random, trial % 2 == 0 ? std::vector{2, 2} : std::vector{3, 1});
      const auto working = pose_conditions(poses).frame.to_working(poses);
      const DyadAxis axis(testing::axis_of(poses, 61).dyads, working, false);
      expect_senses_of_pairs(testing::map_of(axis, axis, 1, {1, simd}), axis, working, met);
      RegionMap by_rows;
      const std::vector<double> places(axis.size(), 0.5);
      classify_rows(by_rows, places, places,
                    [&](std::size_t row) {
                      return FourBarRow{DyadAxis({axis.dyads[row]}, working, false), axis, {}};
                    },
                    1, {1, simd});
      expect_senses_of_pairs(by_rows, axis, working, met);
    }
  for (const int count : met) EXPECT_GT(count, 0);
}

TEST(FourBarMap, DiagonalAndSlidersAreDegenerate) {
  const DyadAxis axis = testing::axis_of(planar_case("cardan").poses, 101);
  const RegionMap map = region_of(planar_case("cardan").poses, axis);
  const RegionCounts counts = map.counts();
  EXPECT_EQ(counts.pairs, 101 * 100);
  for (std::size_t i = 0; i < map.rows(); ++i) {
    EXPECT_EQ(map.type(map.index(i, i)), LinkageType::degenerate);
    const bool slider = is_at_infinity(axis.dyads[i].center);
    for (std::size_t k = 0; slider && k < map.columns(); ++k) {
      EXPECT_EQ(map.type(map.index(i, k)), LinkageType::degenerate);
      EXPECT_EQ(map.values(measures::link_ratio)[map.index(i, k)], 0.0F);
      EXPECT_EQ(map.driver_sweep(i, k), 0);
    }
  }
  EXPECT_GT(counts.types[static_cast<std::size_t>(LinkageType::degenerate)], 0);
}

TEST(FourBarMap, NoNumberIsEverNotANumber) {
  for (const auto& c : planar_cases()) {
    if (c.name == "translations_on_circle") continue;
    const RegionMap map = region_of(c.poses, 64);
    for (const auto column :
         {map.values(measures::min_transmission_angle), map.values(measures::min_transmission_angle_full_turn),
          map.values(measures::link_ratio), map.values(measures::longest_link)})
      for (const float value : column) ASSERT_TRUE(std::isfinite(value) && value >= 0) << c.name;
  }
}

TEST(FourBarMap, RectangularMapsTakeTheirOwnAxes) {
  const auto& poses = planar_case("landing_gear").poses;
  const RegionMap map =
      testing::map_of(testing::axis_at(poses, {0.1, 0.3}), testing::axis_at(poses, {0.3, 0.7, 1.1}), 1);
  EXPECT_EQ(map.rows(), 2u);
  EXPECT_EQ(map.columns(), 3u);
  EXPECT_TRUE(map.is_diagonal(1, 0));
  EXPECT_EQ(map.type(map.index(1, 0)), LinkageType::degenerate);
  EXPECT_EQ(map.counts().pairs, 5);
}

TEST(FourBarMap, CancelledWorkLeavesDegenerateCells) {
  std::atomic<bool> stop{true};
  Progress progress;
  progress.cancelled = &stop;
  const DyadAxis axis = testing::axis_of(planar_case("landing_gear").poses, 40);
  const RegionMap map = testing::map_of(axis, axis, 1, {}, progress);
  for (const std::uint8_t type : map.types()) EXPECT_EQ(type, static_cast<std::uint8_t>(LinkageType::degenerate));
}

TEST(FourBarMap, RecomputingGivesTheSameAsANewMap) {
  const auto& poses = planar_case("landing_gear").poses;
  RegionMap map = region_of(planar_case("drawer_hinge").poses, 50);
  const RegionMap fresh = region_of(poses, 50);
  const DyadAxis axis = testing::axis_of(poses, 50);
  classify_pairs(map, axis, axis, pose_conditions(poses).frame.scale);
  EXPECT_TRUE(std::ranges::equal(map.types(), fresh.types()));
  EXPECT_TRUE(std::ranges::equal(map.values(measures::longest_link), fresh.values(measures::longest_link)));
}

TEST(FourBarMap, TakesLessThan64BytesACell) { EXPECT_LE(four_bar_bytes_per_cell, 64u); }

TEST(FourBarMap, RemembersItsThreads) {
  const auto task = testing::motion_task({{{0, 0}, 0}, {{1, 0.2}, 0.4}, {{1.9, 0.8}, 0.9}});
  const DyadAxis axis({{Homogeneous::of(Point{0, -2}), Homogeneous::of(Point{0.3, 0.4}), 0.5}}, task.poses);
  RegionMap map = testing::map_of(axis, axis, 1, {.threads = 1});
  EXPECT_EQ(map.threads(), 1);
  classify_pairs(map, axis, axis, 1);
  EXPECT_EQ(map.threads(), 0);
}

TEST(DyadAxisDeathTest, TakesNoMoreThanFivePoses) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const std::vector<PrescribedPose> six(6);
  EXPECT_DEATH(DyadAxis({}, six), "one to five poses are judged");
}

}  // namespace
}  // namespace linkwright::four_bar_map_test
