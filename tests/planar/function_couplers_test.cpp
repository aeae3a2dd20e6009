#include "planar/function_couplers.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "linkwright/core/angle.hpp"
#include "linkwright/function/function_error.hpp"
#include "linkwright/mechanism/defects.hpp"
#include "planar/function_linkage.hpp"
#include "support/random_four_bar.hpp"
#include "support/random_function.hpp"
#include "support/random_task.hpp"

namespace linkwright::function_couplers_test {
namespace {

using testing::uniform;

FunctionTask task_of(std::vector<AnglePair> pairs) {
  FunctionTask task;
  task.pairs = std::move(pairs);
  return task;
}

const std::vector<std::vector<int>>& five_position_patterns() {
  static const std::vector<std::vector<int>> patterns = {{1, 1, 1, 1, 1}, {2, 1, 1, 1}, {1, 2, 2}, {1, 3, 1}};
  return patterns;
}

TEST(FunctionCouplers, PivotsLieOnTheUsersGroundLink) {
  FunctionTask task = task_of({{0, 0, {}}, {0.3, 0.2, {}}, {0.7, 0.8, {}}, {1.1, 1.3, {}}});
  task.input_pivot = {3, 1};
  task.output_pivot = {3, 5};
  const FunctionCouplers couplers = function_couplers(task), unit = function_couplers(task_of(task.pairs));
  ASSERT_TRUE(couplers.curve);
  const auto bars = function_four_bar(task, couplers.frame(), *couplers.coupler(0.3));
  ASSERT_TRUE(bars);
  EXPECT_EQ(bars->input_fixed, Point(3, 1));
  EXPECT_EQ(bars->output_fixed, Point(3, 5));
  EXPECT_LT(coupler_residual(*bars, task.pairs), 1e-12);
  EXPECT_FALSE(couplers.coupler(-0.1));
  EXPECT_FALSE(couplers.coupler(couplers.curve->coordinate_length()));
  EXPECT_FALSE(function_four_bar(task, couplers.frame(), {Homogeneous::of(1), {0, 1, 1}, 0})) << "a slider";
}

TEST(FunctionCouplers, TheGroundLinkHasItsPlaceOnTheCurve) {
  std::mt19937_64 random(4);
  for (int i = 0; i < 300; ++i) {
    const FunctionCouplers couplers = function_couplers(task_of(testing::random_pairs(random, {1, 1, 1, 1})));
    const auto tau = couplers.ground_coordinate();
    ASSERT_TRUE(tau);
    EXPECT_LT(distance_from_ground(couplers.given, *couplers.coupler(*tau)), 1e-6);
  }
}

TEST(FunctionCouplers, FivePairsLeaveOneLinkageOrThree) {
  std::mt19937_64 random(5);
  std::array<int, 5> counts{};
  int exact = 0;
  double worst = 0;
  for (int i = 0; i < 500; ++i) {
    const auto& pattern = five_position_patterns()[static_cast<std::size_t>(i) % 4];
    const FunctionTask task = task_of(testing::random_pairs(random, pattern));
    ASSERT_TRUE(mistakes_in(task).empty());
    const FunctionCouplers couplers = function_couplers(task);
    EXPECT_FALSE(couplers.curve);
    EXPECT_FALSE(couplers.degeneracy);
    ++counts[couplers.points.size()];
    EXPECT_TRUE(couplers.points.size() == 1 || couplers.points.size() == 3) << "task " << i;
    for (const Dyad& point : couplers.points) {
      EXPECT_GT(distance_from_ground(couplers.given, point), 1e-6);
      const auto bars = function_four_bar(task, couplers.frame(), point);
      if (!bars || bars->lengths().longest() > 1e3 * bars->lengths().shortest()) continue;
      worst = std::max(worst, coupler_residual(*bars, task.pairs));
      ++exact;
    }
  }
  EXPECT_LT(worst, 1e-8);
  EXPECT_GT(exact, 500);
  EXPECT_GT(counts[1], counts[3]);
  EXPECT_GT(counts[3], 20);
  RecordProperty("one", counts[1]);
  RecordProperty("three", counts[3]);
  RecordProperty("worst", std::to_string(worst * 1e12) + "e-12");
}

// Pairs taken from a linkage that is driven lead back to it.
TEST(FunctionCouplers, FivePairsOfALinkageFindIt) {
  testing::RandomFourBars random(6);
  int found = 0;
  for (int i = 0; i < 200; ++i) {
    const FourBar bars = random.four_bar();
    const LinkLengths lengths = bars.lengths();
    FunctionTask task;
    task.input_pivot = bars.input_fixed;
    task.output_pivot = bars.output_fixed;
    const Configuration start = configuration_of(bars);
    task.pairs = {{start.input_angle, start.output_angle, {}}};
    while (task.pairs.size() < 5) {
      const double input = random.input_angle(lengths);
      const auto there = assemble(lengths, input, random.assembly());
      if (there) task.pairs.push_back({input, there->output_angle, {}});
    }
    const FunctionCouplers couplers = function_couplers(task);
    if (couplers.given.conditions.condition() > 1e5) continue;
    double nearest = 1e9;
    for (const Dyad& point : couplers.points)
      if (const auto other = function_four_bar(task, couplers.frame(), point))
        nearest = std::min(nearest, std::abs(other->input_moving - bars.input_moving) +
                                        std::abs(other->output_moving - bars.output_moving));
    EXPECT_LT(nearest, 1e-5) << "task " << i;
    ++found;
  }
  EXPECT_GT(found, 150);
}

TEST(FunctionCouplers, ThePositionsOfOnePairTendToItsDerivatives) {
  const AnglePair from{0.2, -0.4, {{1, 0.7}, {0.3, -1.1}, {-0.5, 0.9}}}, last{1.6, 0.3, {}};
  const auto after = [&](double t) { return testing::pair_after(from, t); };
  const FunctionCouplers limit = function_couplers(task_of({from, last}));
  ASSERT_FALSE(limit.points.empty());
  const double h = 1e-2;
  const FunctionCouplers near =
      function_couplers(task_of({after(-1.5 * h), after(-0.5 * h), after(0.5 * h), after(1.5 * h), last}));
  ASSERT_EQ(near.points.size(), limit.points.size());
  const auto bars_of = [](const FunctionCouplers& couplers) {
    std::vector<double> lengths;
    for (const Dyad& point : couplers.points)
      if (const auto bars = function_four_bar({}, couplers.frame(), point)) lengths.push_back(bars->lengths().coupler);
    std::sort(lengths.begin(), lengths.end());
    return lengths;
  };
  const auto a = bars_of(limit), b = bars_of(near);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(b[i], a[i], 0.02 * a[i]);
}

TEST(FunctionCouplers, LinearFunctions) {
  const auto linear = [](double slope, int count) {
    std::vector<AnglePair> pairs;
    for (int j = 0; j < count; ++j) pairs.push_back({0.1 + 0.3 * j * j / 4.0, slope * 0.3 * j * j / 4.0, {}});
    return task_of(pairs);
  };
  for (const int count : {4, 5}) {
    const FunctionCouplers same = function_couplers(linear(1, count));
    ASSERT_TRUE(same.degeneracy) << "every parallelogram does it";
    EXPECT_EQ(same.degeneracy->code, "parallelogram");
    EXPECT_FALSE(same.curve);
    EXPECT_TRUE(same.points.empty());
  }
  for (const double slope : {-1.0, 2.0, -0.5}) {
    const FunctionTask task = linear(slope, 4);
    const FunctionCouplers couplers = function_couplers(task);
    ASSERT_TRUE(couplers.curve) << slope;
    int linkages = 0;
    for (const double tau : couplers.curve->samples(40, Spacing::coordinate)) {
      const auto bars = function_four_bar(task, couplers.frame(), *couplers.coupler(tau));
      if (!bars || bars->lengths().longest() > 50 * bars->lengths().shortest()) continue;
      EXPECT_LT(coupler_residual(*bars, task.pairs), 1e-10);
      ++linkages;
    }
    EXPECT_GT(linkages, 5) << slope;
  }
}

TEST(FunctionCouplers, PairsThatAreTooCloseAreTold) {
  const FunctionCouplers couplers =
      function_couplers(task_of({{0, 0, {}}, {1e-8, 2e-8, {}}, {2.1e-8, 4.4e-8, {}}, {3e-8, 6.5e-8, {}}}));
  ASSERT_EQ(couplers.warnings.size(), 1u);
  EXPECT_EQ(couplers.warnings[0].code, "ill_conditioned");
}

// The weaving machine of a laboratory exercise: five pairs that its least squares meet to a degree.
TEST(FunctionCouplers, PublishedFivePairs) {
  const auto c = nlohmann::json::parse(std::ifstream(LINKWRIGHT_DATA_DIR "/function/fg5-weaving-lsq.json"));
  FunctionTask task;
  for (std::size_t j = 0; j < 5; ++j)
    task.pairs.push_back({radians(c["input"]["input_angles_deg"][j]), radians(c["input"]["output_angles_deg"][j]), {}});
  task.output_pivot = c["input"]["ground"].get<double>();
  const FunctionCouplers couplers = function_couplers(task);
  EXPECT_TRUE(couplers.points.size() == 1 || couplers.points.size() == 3);
  for (const Dyad& point : couplers.points) {
    const auto bars = function_four_bar(task, couplers.frame(), point);
    ASSERT_TRUE(bars);
    EXPECT_LT(coupler_residual(*bars, task.pairs), 1e-9);
    if (find_defects(*bars, coupler_poses(*bars, task.pairs)).defects.none()) {
      EXPECT_LT(function_error(*bars, task).precision_error, 1e-8);
    }
  }
}

}  // namespace
}  // namespace linkwright::function_couplers_test
