#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <optional>

#include "linkwright/core/angle.hpp"
#include "linkwright/function/function_error.hpp"
#include "linkwright/mechanism/defects.hpp"
#include "linkwright/planar/four_bar_solution.hpp"
#include "linkwright/synthesis/solve.hpp"
#include "planar/function_family.hpp"
#include "planar/function_linkage.hpp"
#include "support/random_function.hpp"
#include "support/solved.hpp"

namespace linkwright::function_search_test {
namespace {

using testing::named_task;

Requirements usual() {
  Requirements wanted;
  wanted.max_length = 10;
  return wanted;
}

std::vector<RankedGenerator> best_of(const FunctionTask& task, const Requirements& wanted,
                                     const GeneratorSearchOptions& options = {}) {
  const TaskFamily given = task_family(task);
  return best_generators(dynamic_cast<const FunctionFamily&>(*given.family), wanted, options);
}

TEST(FunctionSearch, NoSampleOfTheRibbonBettersTheBest) {
  for (const FunctionTask& task : {named_task("x^2", {0, 1}, 60, 90), named_task("log", {1, 2}, 60, -90),
                                   named_task("sin_deg", {0, 90}, 90, 90)}) {
    const auto best = best_of(task, usual());
    ASSERT_FALSE(best.empty());
    const TaskFamily given = task_family(task);
    const auto& family = dynamic_cast<const FunctionFamily&>(*given.family);
    double least = 10;
    for (const double tau : family.samples(Side::input, 1500, Spacing::coordinate)) {
      const auto links = family.dyad_pair({tau, 0.5});
      const auto bars = links ? four_bar_of(*links) : std::nullopt;
      if (!bars) continue;
      const LinkLengths lengths = bars->lengths();
      if (!find_defects(*bars, family.working_poses({tau, 0.5}, *bars)).defects.none() ||
          lengths.longest() > 20 * lengths.shortest() || family.frame().scale * lengths.longest() > 10)
        continue;
      const FunctionError error = function_error(*bars, task, ErrorSampling::coarse());
      if (error.unreached.empty()) least = std::min(least, error.max_structural_error.value_or(10));
    }
    EXPECT_LE(best.front().max_structural_error, least + 1e-12);
    for (std::size_t i = 0; i + 1 < best.size(); ++i)
      EXPECT_LE(best[i].max_structural_error, best[i + 1].max_structural_error);
  }
}

TEST(FunctionSearch, AFreeNumberLowersTheError) {
  FunctionTask task = named_task("x^2", {0, 1}, 60, 90);
  const auto fixed = best_of(task, usual());
  task.free = FreeParameter{};
  const auto free = best_of(task, usual(), {60, 10, 31, 1});
  ASSERT_FALSE(fixed.empty() || free.empty());
  // Of the travel that it has.
  const double scale = FreeParameter{}.at(free.front().place.output);
  EXPECT_LT(free.front().max_structural_error, fixed.front().max_structural_error);
  EXPECT_GE(scale, 0.5);
  EXPECT_LE(scale, 2);
}

TEST(FunctionSearch, RequirementsAreKept) {
  const FunctionTask task = named_task("log", {1, 2}, 60, 90);
  Requirements wanted = usual();
  wanted.min_transmission_angle = radians(25);
  wanted.max_link_ratio = 6;
  const auto best = best_of(task, wanted);
  const TaskFamily given = task_family(task);
  for (const RankedGenerator& generator : best) {
    const FourBar bars = *four_bar_of(*given.family->dyad_pair(generator.place));
    const DefectReport report = find_defects(bars, coupler_poses(bars, task.pairs));
    EXPECT_EQ(report.type, generator.type);
    EXPECT_TRUE(report.defects.none());
    EXPECT_GE(report.min_transmission_angle, radians(25) - 1e-9);
    EXPECT_LE(bars.lengths().longest(), 6 * bars.lengths().shortest() * (1 + 1e-9));
    const FunctionError error = function_error(bars, task);
    EXPECT_NEAR(*error.max_structural_error, generator.max_structural_error, 1e-12);
    EXPECT_TRUE(error.unreached.empty());
  }
  wanted.max_link_ratio = 1.0001;
  EXPECT_TRUE(best_of(task, wanted).empty());
}

// A hill of this task lies across the place where the closed branch begins and ends.
TEST(FunctionSearch, ClimbsOnOverTheEndOfAClosedBranch) {
  Requirements wanted = usual();
  wanted.min_transmission_angle = radians(40);
  wanted.max_link_ratio = 4;
  for (const RankedGenerator& generator : best_of(named_task("sin_deg", {0, 90}, 90, 45), wanted)) {
    const double tau = generator.place.input;
    EXPECT_GT(std::abs(tau - std::round(tau)), 1e-6) << "stopped where nothing but the count of τ ends";
  }
}

// Where what is allowed ends, the rows' coordinate runs far while the free pair hardly changes: from wherever a climb
// meets that edge it must go on along it, and no place around its end is better.
TEST(FunctionSearch, ClimbsAlongTheEdgeOfTheReach) {
  FunctionTask task = named_task("sqrt", {1, 2}, 60, -70);
  const double output = task.pairs[1].output;
  task.free = FreeParameter{FreeParameter::Kind::pair_output, {output - 0.15, output + 0.15}, 1};
  const TaskFamily given = task_family(task);
  const auto& family = dynamic_cast<const FunctionFamily&>(*given.family);
  std::optional<LinkageType> type;  // a climb keeps the type
  const auto error_at = [&](MapPoint place) {
    const auto found = make_four_bar(given, place, true, false);
    if (!found || !found->report.defects.none() || found->report.type != type.value_or(found->report.type) ||
        found->lengths.longest() > std::min(10.0, 20 * found->lengths.shortest()))
      return 10.0;
    type = found->report.type;
    const FunctionError error = family.error_of(found->four_bar, place, ErrorSampling::coarse());
    return error.unreached.empty() ? error.max_structural_error.value_or(10) : 10.0;
  };
  for (const MapPoint start : {MapPoint{0.1709, 0.4999}, {0.1709, 0.5029}, {0.1729, 0.5009}}) {
    const double before = error_at(start);
    const auto top = improved_generator(family, usual(), start);
    ASSERT_TRUE(top);
    const double reached = error_at(*top);
    EXPECT_LT(reached, 0.9 * before);
    for (int i = -15; i <= 15; ++i)
      for (int j = -15; j <= 15; ++j)
        EXPECT_GE(error_at({top->input + 2e-4 * i, top->output + 1e-4 * j}), reached - 1e-9) << i << " " << j;
  }
}

TEST(FunctionSearch, WithoutANamedFunctionThereIsNoError) {
  FunctionTask task = named_task("x^2", {0, 1}, 60, 90);
  task.function.reset();
  EXPECT_TRUE(best_of(task, usual()).empty());
}

TEST(FunctionSearch, FivePairsAreOnlyRanked) {
  FunctionTask task = named_task("sin_deg", {0, 90}, 90, 90);
  task.function->points = 5;
  task.pairs = precision_pairs(*task.function);
  const auto best = best_of(task, usual());
  ASSERT_EQ(best.size(), 1u);
  EXPECT_NEAR(degrees(best[0].max_structural_error), 0.28829, 1e-4);
}

FunctionTask named_function(std::string expression, std::array<double, 2> x, double output_range_deg) {
  FunctionTask task;
  task.function = NamedFunction{.expression = std::move(expression),
                                .x = x,
                                .input_range = {0, radians(60)},
                                .output_range = {0, radians(output_range_deg)},
                                .points = 5};
  task.pairs = precision_pairs(*task.function);
  return task;
}

FunctionTask squares() {
  FunctionTask task = named_function("x^2", {0, 1}, 60);
  task.function->points = 4;
  task.pairs = precision_pairs(*task.function);
  return task;
}

TEST(SolveFunction, AnAxisOfOnePlaceIsWithinAnyWindow) {
  SynthesisOptions options;
  options.window = MapWindow{{0, 2}, {0.6, 0.9}};
  const FunctionAnswer answer = testing::solved(squares(), {}, options);
  EXPECT_GT(answer.meeting_requirements, 0);
  EXPECT_FALSE(answer.linkages.empty());
}

TEST(SolveFunction, TheLeastStructuralErrorIsSoughtWithinTheWindow) {
  SynthesisOptions options;
  options.objective = Objective::structural_error;
  const FunctionAnswer whole = testing::solved(squares(), {}, options);
  ASSERT_GT(whole.linkages.size(), 1u);
  const double best = whole.linkages[0].input.coordinate, other = whole.linkages[1].input.coordinate;
  options.window = MapWindow{{other - 1e-3, other + 1e-3}, {0, 1}};
  ASSERT_GT(std::abs(best - other), 1e-3);
  const FunctionAnswer part = testing::solved(squares(), {}, options);
  ASSERT_FALSE(part.linkages.empty());
  for (const FourBarSolution& found : part.linkages) EXPECT_NEAR(found.input.coordinate, other, 1e-3);
  EXPECT_NEAR(*part.linkages[0].function->max_structural_error, *whole.linkages[1].function->max_structural_error,
              1e-6);
}

TEST(SolveFunction, FivePrecisionPointsListEveryLinkageWhateverItsDefects) {
  int with_defects = 0, free_of_them = 0;
  for (const FunctionTask& task : {named_function("log", {1, 10}, 60), named_function("log", {1, 4}, -45),
                                   named_function("sin_deg", {0, 90}, -120), named_function("x^2", {1, 10}, -120)}) {
    const FunctionAnswer answer = testing::solved(task);
    EXPECT_LE(answer.linkages.size(), answer.pairs.size());
    EXPECT_NE(answer.reason.message.find("generate all pairs"), std::string::npos) << answer.reason.message;
    for (const FourBarSolution& found : answer.pairs) {
      ASSERT_TRUE(found.function);
      EXPECT_TRUE(found.verified_by_driving);
      const bool is_free = found.report.defects.none();
      EXPECT_EQ(defect_notice(found, answer.given).has_value(), !is_free);
      if (is_free) {
        EXPECT_TRUE(found.function->reaches_pairs);
        EXPECT_LT(found.function->precision_error, 1e-9);
      }
      (is_free ? free_of_them : with_defects) += 1;
    }
  }
  EXPECT_GT(with_defects, 0);
  EXPECT_GT(free_of_them, 0);
}

}  // namespace
}  // namespace linkwright::function_search_test
