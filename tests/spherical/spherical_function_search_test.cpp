#include <algorithm>
#include <gtest/gtest.h>
#include <optional>

#include "linkwright/core/angle.hpp"
#include "linkwright/spherical/spherical_solution.hpp"
#include "spherical/spherical_function_family.hpp"
#include "support/spherical_function.hpp"

namespace linkwright::spherical_function_search_test {
namespace {

TEST(SphericalFunctionSearch, NoSampleOfTheRibbonBettersTheBest) {
  for (const SphericalFunctionTask& task : {testing::named_spherical_task("log", {1, 2}, 60, -70, 40),
                                            testing::named_spherical_task("sin_deg", {0, 90}, 90, 90, 60),
                                            testing::named_spherical_task("x^2", {0, 1}, 60, 90, 110),
                                            testing::named_spherical_task("exp", {0, 1}, 60, 60, 30)}) {
    const SphericalTaskFamily given = task_family(task);
    const auto& family = dynamic_cast<const SphericalFunctionFamily&>(*given.family);
    const Requirements wanted = with_default_angles({});
    const auto best = best_generators(family, wanted);
    ASSERT_FALSE(best.empty());
    double least = 10;
    for (const double tau : family.samples(Side::input, 700, Spacing::coordinate)) {
      const auto made = make_spherical_four_bar(given, {tau, 0.5}, true, false);
      if (!made || !made->report.defects.none() || made->report.min_transmission_angle < radians(0.1)) continue;
      bool long_enough = true;
      for (const double arc : made->angles.all())
        long_enough = long_enough && std::min(arc, pi - arc) >= *wanted.min_link_angle;
      const FunctionError error = family.error_of(made->four_bar, {tau, 0.5}, ErrorSampling::coarse());
      if (long_enough && error.unreached.empty()) least = std::min(least, error.max_structural_error.value_or(10));
    }
    EXPECT_LE(best.front().max_structural_error, least + 1e-9);
    EXPECT_LT(best.front().max_structural_error, radians(2)) << task.function->expression;
    for (std::size_t i = 0; i + 1 < best.size(); ++i)
      EXPECT_LE(best[i].max_structural_error, best[i + 1].max_structural_error);
  }
}

// Where the reach of the linkages ends, the rows' coordinate runs far while the free pair hardly changes: from wherever
// a climb meets that edge it must go on along it, and no place around its end is better.
TEST(SphericalFunctionSearch, ClimbsAlongTheEdgeOfTheReach) {
  SphericalFunctionTask task = testing::named_spherical_task("log", {1, 2}, 120, 60, 110);
  const double output = task.pairs[1].output;
  task.free = FreeParameter{FreeParameter::Kind::pair_output, {output - 0.15, output + 0.15}, 1};
  const SphericalTaskFamily given = task_family(task);
  const auto& family = dynamic_cast<const SphericalFunctionFamily&>(*given.family);
  std::optional<LinkageType> type;  // a climb keeps the type
  const auto error_at = [&](MapPoint place) {
    const auto made = make_spherical_four_bar(given, place, true, false);
    if (!made || !made->report.defects.none() || made->report.type != type.value_or(made->report.type)) return 10.0;
    for (const double arc : made->angles.all())
      if (std::min(arc, pi - arc) < radians(5)) return 10.0;
    type = made->report.type;
    const FunctionError error = family.error_of(made->four_bar, place, ErrorSampling::coarse());
    return error.unreached.empty() ? error.max_structural_error.value_or(10) : 10.0;
  };
  for (const MapPoint start : {MapPoint{1.111, 0.5188}, {1.113, 0.5248}, {1.119, 0.5238}}) {
    const double before = error_at(start);
    const auto top = improved_generator(family, with_default_angles({}), start);
    ASSERT_TRUE(top);
    const double reached = error_at(*top);
    EXPECT_LT(reached, 0.4 * before);
    for (int i = -15; i <= 15; ++i)
      for (int j = -15; j <= 15; ++j)
        EXPECT_GE(error_at({top->input + 2e-4 * i, top->output + 1e-4 * j}), reached - 1e-9) << i << " " << j;
  }
}

TEST(SphericalFunctionSearch, WithoutANamedFunctionThereIsNoError) {
  const SphericalTaskFamily given = task_family(testing::spherical_function_case("stapler-function-4"));
  EXPECT_TRUE(
      best_generators(dynamic_cast<const SphericalFunctionFamily&>(*given.family), with_default_angles({})).empty());
}

}  // namespace
}  // namespace linkwright::spherical_function_search_test
