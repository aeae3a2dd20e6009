#include "planar/function_family.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "linkwright/core/angle.hpp"
#include "linkwright/function/function_error.hpp"
#include "linkwright/mechanism/defects.hpp"
#include "linkwright/synthesis/solve.hpp"
#include "planar/function_linkage.hpp"
#include "region/improved_linkage.hpp"
#include "support/random_function.hpp"

namespace linkwright::function_family_test {
namespace {

FunctionTask squares(int points = 4) {
  FunctionTask task = testing::named_task("x^2", {0, 1}, 60, 90);
  task.function->points = points;
  task.pairs = precision_pairs(*task.function);
  task.input_pivot = {20, 10};
  task.output_pivot = {60, 40};
  return task;
}

const FunctionFamily& family_of(const TaskFamily& given) { return dynamic_cast<const FunctionFamily&>(*given.family); }

// Each cell of the map beside the verdict over its linkage alone.
void expect_map_of_verdicts(const FourBarFamily& family, int count, bool respect_direction) {
  const auto input = family.samples(Side::input, count, Spacing::coordinate);
  const auto output = family.samples(Side::output, count, Spacing::coordinate);
  RegionMap map;
  family.classify(map, input, output, respect_direction);
  ASSERT_EQ(map.rows(), input.size());
  ASSERT_EQ(map.columns(), output.size());
  int differences = 0, linkages = 0;
  for (std::size_t row = 0; row < map.rows(); ++row)
    for (std::size_t column = 0; column < map.columns(); ++column) {
      const MapPoint place{input[row], output[column]};
      const auto links = family.dyad_pair(place);
      const auto bars = links ? four_bar_of(*links) : std::nullopt;
      const std::size_t cell = map.index(row, column);
      if (!bars) {
        EXPECT_EQ(map.type(cell), LinkageType::degenerate);
        continue;
      }
      const auto report = find_defects(*bars, family.working_poses(place, *bars), respect_direction);
      // Rounding decides next to a change point or a dead point only.
      if (report.type != map.type(cell) || report.defects != map.defects(cell)) {
        ++differences;
        continue;
      }
      if (report.type == LinkageType::degenerate) continue;
      ++linkages;
      const LinkLengths lengths = bars->lengths();
      EXPECT_NEAR(map.values(measures::longest_link)[cell], family.frame().scale * lengths.longest(),
                  1e-5 * family.frame().scale * lengths.longest());
      EXPECT_NEAR(map.values(measures::link_ratio)[cell], lengths.longest() / lengths.shortest(),
                  1e-5 * lengths.longest() / lengths.shortest());
      if (report.defects.none()) {
        EXPECT_NEAR(map.values(measures::min_transmission_angle)[cell], versine_of_angle(report.min_transmission_angle),
                    1e-5);
        EXPECT_EQ(map.drive_sense(row, column), report.sense);
        EXPECT_NEAR(map.driver_sweep(row, column), report.sweep, 1e-5);
      }
    }
  EXPECT_LE(differences, static_cast<int>(map.rows() * map.columns()) / 500);
  EXPECT_GT(linkages, 0);
}

TEST(FunctionFamily, TheRibbonHasTheVerdictOfEachLinkage) {
  const TaskFamily given = task_family(squares());
  ASSERT_TRUE(given.family);
  EXPECT_EQ(given.pattern, "P-P-P-P");
  EXPECT_EQ(given.family->axis(Side::output).quantity, AxisQuantity::nothing);
  EXPECT_FALSE(given.family->is_symmetric());
  expect_map_of_verdicts(*given.family, 400, true);
}

TEST(FunctionFamily, SoHasTheMapOfAFreeNumber) {
  FunctionTask task = squares();
  task.free = FreeParameter{};
  const TaskFamily given = task_family(task);
  EXPECT_EQ(given.family->axis(Side::output).quantity, AxisQuantity::output_scale);
  EXPECT_NEAR(given.family->axis_value(Side::output, 0.5), 1, 1e-15);
  expect_map_of_verdicts(*given.family, 40, true);
  task.free = FreeParameter{FreeParameter::Kind::pair_output, {0.5, 1.0}, 2};
  const TaskFamily other = task_family(task);
  EXPECT_NEAR(other.family->axis_value(Side::output, 0.5), degrees(0.75), 1e-12);
  expect_map_of_verdicts(*other.family, 40, true);
}

TEST(FunctionFamily, RandomTasksOfAllPatterns) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 24; ++i) {
    FunctionTask task;
    task.pairs = testing::random_pairs(random, testing::four_position_patterns()[static_cast<std::size_t>(i) % 8]);
    const TaskFamily given = task_family(task);
    ASSERT_TRUE(given.family);
    expect_map_of_verdicts(*given.family, 60, i % 2 == 0);
  }
}

TEST(FunctionFamily, AFreeNumberAtItsOwnValueIsTheTask) {
  FunctionTask task = squares();
  const TaskFamily plain = task_family(task);
  task.free = FreeParameter{};
  const TaskFamily free = task_family(task);
  for (const double tau : {0.1, 0.4, 0.7}) {
    const auto a = plain.family->dyad_pair({tau, 0.5}), b = free.family->dyad_pair({tau, 0.5});
    ASSERT_TRUE(a && b);
    const auto bars = four_bar_of(*a), others = four_bar_of(*b);
    ASSERT_TRUE(bars && others);
    EXPECT_NEAR(std::abs(bars->input_moving - others->input_moving), 0, 1e-9);
    EXPECT_NEAR(std::abs(bars->output_moving - others->output_moving), 0, 1e-9);
  }
}

TEST(FunctionFamily, FivePairsMakeAMapOfPoints) {
  const TaskFamily given = task_family(squares(5));
  ASSERT_TRUE(given.family);
  EXPECT_EQ(given.family->axis(Side::input).quantity, AxisQuantity::burmester_point);
  const auto rows = given.family->samples(Side::input, 400, Spacing::coordinate);
  EXPECT_TRUE(rows.size() == 1 || rows.size() == 3);
  EXPECT_EQ(given.family->samples(Side::output, 400, Spacing::coordinate).size(), 1u);
  EXPECT_EQ(given.family->polygon(Side::input).size(), rows.size());
  expect_map_of_verdicts(*given.family, 400, true);
}

TEST(FunctionFamily, LinkagesFoundStandOnTheGroundPivotsAndGenerateThePairs) {
  for (const bool free : {false, true}) {
    FunctionTask task = squares();
    if (free) task.free = FreeParameter{};
    const TaskFamily given = task_family(task);
    int checked = 0;
    for (double tau = 0.05; tau < 1; tau += 0.1) {
      const MapPoint place{tau, free ? 0.3 : 0.5};
      const auto found = make_four_bar(given, place, true, true);
      if (!found || found->lengths.longest() > 30 * found->lengths.shortest()) continue;
      EXPECT_NEAR(std::abs(found->four_bar.input_fixed - task.input_pivot), 0, 1e-12);
      EXPECT_NEAR(std::abs(found->four_bar.output_fixed - task.output_pivot), 0, 1e-12);
      EXPECT_LT(found->residual, 1e-10);
      EXPECT_TRUE(found->verified_by_driving) << tau;
      const FunctionTask fixed = family_of(given).task_at(place);
      EXPECT_EQ(fixed.pairs[1].output == task.pairs[1].output, !free);
      if (found->report.defects.none()) {
        EXPECT_LT(function_error(found->four_bar, fixed).precision_error, 1e-9);
      }
      ++checked;
    }
    EXPECT_GT(checked, 3);
  }
}

TEST(FunctionFamily, HasTheLinksOfEachCellOfAMap) {
  FunctionTask task = squares();
  task.free = FreeParameter{};
  const TaskFamily given = task_family(task);
  const FourBarFamily& family = *given.family;
  const auto input = family.samples(Side::input, 20, Spacing::coordinate),
             output = family.samples(Side::output, 9, Spacing::coordinate);
  const auto links_at = family.dyad_pairs_of_cells(input, output);
  int compared = 0;
  for (std::size_t row = 0; row < input.size(); ++row)
    for (std::size_t column = 0; column < output.size(); ++column) {
      const auto links = links_at(row, column), same = family.dyad_pair({input[row], output[column]});
      ASSERT_EQ(links.has_value(), same.has_value());
      if (!links) continue;
      EXPECT_TRUE(same_points(links->input, same->input) && same_points(links->output, same->output));
      EXPECT_EQ(links->output.coordinate, same->output.coordinate);
      ++compared;
    }
  EXPECT_GT(compared, 50);
}

TEST(FunctionFamily, MeasuresTheErrorOfTheTaskAtEachPlace) {
  for (const auto kind : {FreeParameter::Kind::output_scale, FreeParameter::Kind::pair_output}) {
    FunctionTask task = testing::named_task("x^2", {0, 1}, 60, 90);
    task.free = FreeParameter{kind, {0.5, 2}, 1};
    const TaskFamily given = task_family(task);
    int compared = 0;
    for (double tau = 0.05; tau < 1; tau += 0.1) {
      const MapPoint place{tau, 0.7};
      const auto found = make_four_bar(given, place, true, false);
      if (!found) continue;
      const FunctionError error = family_of(given).error_of(found->four_bar, place);
      const FunctionError same = function_error(found->four_bar, family_of(given).task_at(place));
      EXPECT_EQ(error.max_structural_error, same.max_structural_error);
      EXPECT_EQ(error.at_pairs, same.at_pairs);
      ++compared;
    }
    EXPECT_GT(compared, 3);
  }
}

TEST(FunctionFamily, CurvesOfPivotsRunThroughTheLinkages) {
  const TaskFamily given = task_family(squares());
  const auto input = given.family->polygon(Side::input), output = given.family->polygon(Side::output);
  ASSERT_EQ(input.size(), output.size());
  ASSERT_GT(input.size(), 50u);
  for (std::size_t i = 0; i < input.size(); i += 17) {
    const auto links = given.family->dyad_pair({input[i].coordinate, 0.5});
    ASSERT_TRUE(links);
    EXPECT_LT(norm(cross(links->input.circle, input[i].circle)), 1e-12);
    EXPECT_LT(norm(cross(links->output.circle, output[i].circle)), 1e-12);
  }
  FunctionTask task = squares();
  task.free = FreeParameter{};
  EXPECT_TRUE(task_family(task).family->polygon(Side::input).empty());
}

TEST(FunctionFamily, ALinkageCanBeImproved) {
  for (const bool free : {false, true}) {
    FunctionTask task = squares();
    if (free) task.free = FreeParameter{};
    const TaskFamily given = task_family(task);
    Requirements wanted;
    wanted.max_length = 10 * std::abs(task.output_pivot - task.input_pivot);
    const auto input = given.family->samples(Side::input, 200, Spacing::coordinate);
    int improved = 0;
    for (const double tau : input) {
      const auto before = make_four_bar(given, {tau, 0.5}, true, false);
      if (!before || !before->report.defects.none()) continue;
      const auto top = improved_linkage(*given.family, wanted, Objective::min_transmission_angle, {tau, 0.5});
      if (!top) continue;
      const auto after = make_four_bar(given, *top, true, false);
      ASSERT_TRUE(after);
      EXPECT_GE(after->report.min_transmission_angle, before->report.min_transmission_angle);
      if (++improved == 3) break;
    }
    EXPECT_EQ(improved, 3);
  }
}

TEST(FunctionFamily, AParallelogramIsNoFamily) {
  FunctionTask task = squares();
  for (AnglePair& pair : task.pairs) pair.output = pair.input + 1;
  const TaskFamily given = task_family(task);
  EXPECT_FALSE(given.family);
  ASSERT_TRUE(given.degeneracy);
  EXPECT_EQ(given.degeneracy->code, "parallelogram");
}

TEST(FunctionFamily, DerivativesAreMetAllAlongTheCurve) {
  std::mt19937_64 random(11);
  for (const auto& multiplicities : testing::four_position_patterns()) {
    FunctionTask task = squares();
    task.function.reset();
    task.pairs = testing::random_pairs(random, multiplicities);
    const TaskFamily given = task_family(task);
    for (const double tau : given.family->samples(Side::input, 40, Spacing::coordinate)) {
      const auto residual = family_of(given).rate_residual({tau, 0.5});
      ASSERT_EQ(residual.has_value(), multiplicities.size() < 4);
      EXPECT_LT(residual.value_or(0), 1e-9);
    }
  }
}

}  // namespace
}  // namespace linkwright::function_family_test
