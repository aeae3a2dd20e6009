#include "linkwright/function/function_error.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/defects.hpp"
#include "linkwright/planar/burmester_curve.hpp"
#include "planar/function_couplers.hpp"
#include "planar/function_linkage.hpp"
#include "support/planar_case.hpp"
#include "support/random_four_bar.hpp"
#include "support/random_function.hpp"
#include "support/random_task.hpp"

namespace linkwright::function_error_test {
namespace {

using testing::named_task;
using testing::uniform;

nlohmann::json published(const std::string& name) {
  return nlohmann::json::parse(std::ifstream(LINKWRIGHT_DATA_DIR "/function/" + name + ".json"));
}

// Linkages of a four-pair task at even steps along its curve.
std::vector<FourBar> linkages_of(const FunctionTask& task, int count) {
  const FunctionCouplers couplers = function_couplers(task);
  std::vector<FourBar> found;
  for (const double tau : couplers.curve->samples(count, Spacing::coordinate))
    if (const auto bars = function_four_bar(task, couplers.frame(), *couplers.coupler(tau))) found.push_back(*bars);
  return found;
}

// The four-bar (lengths, ground 1) at an input angle.
FourBar bars_of(double input, double coupler, double output, double angle, Assembly assembly) {
  return testing::four_bar_at({1, input, coupler, output}, angle, assembly);
}

TEST(FunctionError, WithoutBranchDefectTheDriveGivesThePairs) {
  std::mt19937_64 random(1);
  int checked = 0;
  double worst = 0;
  for (int i = 0; i < 2000; ++i) {
    FunctionTask task;
    task.pairs = i % 2 == 0 ? testing::gentle_pairs(random, 4)
                            : testing::random_pairs(random, testing::four_position_patterns()[i / 2 % 8]);
    for (const FourBar& bars : linkages_of(task, 8)) {
      const DefectReport report = find_defects(bars, coupler_poses(bars, task.pairs));
      if (report.type == LinkageType::degenerate || report.defects.branch() || report.defects.circuit()) continue;
      const FunctionError error = function_error(bars, task);
      ASSERT_TRUE(error.reaches_pairs);
      EXPECT_FALSE(error.max_structural_error);
      EXPECT_TRUE(error.samples.empty());
      // Where the arms are long or the transmission angle is small the rounding of the pivots is magnified.
      const LinkLengths l = bars.lengths();
      if (l.longest() > 100 * l.shortest() || report.min_transmission_angle < 0.014) continue;
      worst = std::max(worst, error.precision_error);
      ++checked;
    }
  }
  EXPECT_LT(worst, 1e-9);
  EXPECT_GT(checked, 1000);
  RecordProperty("worst", std::to_string(worst * 1e12) + "e-12");
  RecordProperty("checked", checked);
}

TEST(FunctionError, ABranchDefectShowsAtThePairs) {
  std::mt19937_64 random(2);
  int defects = 0;
  for (int i = 0; i < 200; ++i) {
    FunctionTask task;
    task.pairs = testing::gentle_pairs(random, 4);
    for (const FourBar& bars : linkages_of(task, 6)) {
      const DefectReport report = find_defects(bars, coupler_poses(bars, task.pairs));
      const LinkLengths l = bars.lengths();
      if (!report.defects.branch() || l.longest() > 100 * l.shortest()) continue;
      const FunctionError error = function_error(bars, task);
      EXPECT_TRUE(!error.reaches_pairs || error.precision_error > 1e-9);
      ++defects;
    }
  }
  EXPECT_GT(defects, 100);
}

TEST(FunctionError, TheWorstIsThatOfADenseSearch) {
  for (const auto& [expression, low, high] :
       {std::tuple{"x^2", 0.0, 1.0}, {"log", 1.0, 2.0}, {"sin_deg", 0.0, 90.0}, {"exp", 0.0, 1.0}}) {
    const FunctionTask task = named_task(expression, {low, high}, 60, 80);
    const ScaledFunction scaled(*task.function);
    int compared = 0;
    for (const FourBar& bars : linkages_of(task, 30)) {
      if (!find_defects(bars, coupler_poses(bars, task.pairs)).defects.none()) continue;
      const FunctionError error = function_error(bars, task);
      ASSERT_TRUE(error.max_structural_error);
      // Brute force shares nothing but the joint equation: |B − A| = h by bisection on the output angle is replaced by
      // the closed form of the law of cosines with atan2.
      const Point a0 = bars.input_moving, b0 = bars.output_moving - 1.0;
      const double h = bars.lengths().coupler, b = bars.lengths().output;
      double brute = 0, brute_at = 0, last = 0;
      for (int i = 0; i <= 20'000; ++i) {
        const double input = task.function->input_range[1] * i / 20'000;
        const Point a = a0 * direction(input - task.pairs[0].input), d = a - 1.0;
        const double cosine = (std::norm(d) + b * b - h * h) / (2 * b * std::abs(d));
        if (std::abs(cosine) > 1) continue;
        double nearest = 10;
        for (const double side : {-1, 1}) {
          const double output = std::arg(d) + side * std::acos(cosine) - std::arg(b0) + task.pairs[0].output;
          const double off = wrap_signed(output - scaled.output_at(input));
          // The assembly of the first pair is the one that continues the curve.
          if (std::abs(wrap_signed(off - last)) < std::abs(wrap_signed(nearest - last))) nearest = off;
        }
        last = nearest;
        if (std::abs(nearest) > std::abs(brute)) {
          brute = nearest;
          brute_at = input;
        }
      }
      if (!error.unreached.empty()) continue;
      EXPECT_NEAR(*error.max_structural_error, std::abs(brute), 1e-6 * std::abs(brute) + 1e-9) << expression;
      EXPECT_GE(*error.max_structural_error, std::abs(brute) - 1e-12);
      EXPECT_NEAR(error.worst_input, brute_at, 1e-3);
      ++compared;
    }
    EXPECT_GT(compared, 2) << expression;
  }
}

TEST(FunctionError, ThePlotPassesThroughThePairs) {
  const FunctionTask task = named_task("x^2", {0, 1}, 60, 90);
  for (const FourBar& bars : linkages_of(task, 20)) {
    if (!find_defects(bars, coupler_poses(bars, task.pairs)).defects.none()) continue;
    const FunctionError error = function_error(bars, task);
    ASSERT_EQ(error.at_pairs.size(), 4u);
    for (const auto& at_pair : error.at_pairs) EXPECT_NEAR(at_pair.value_or(1), 0, 1e-9);
    ASSERT_GE(error.samples.size(), 181u);
    int crossings = 0;
    for (std::size_t i = 1; i < error.samples.size(); ++i) {
      const ErrorSample &a = error.samples[i - 1], &b = error.samples[i];
      EXPECT_LT(a.input, b.input);
      if (a.generated && b.generated && (*a.generated - a.wanted) * (*b.generated - b.wanted) < 0) ++crossings;
    }
    EXPECT_GE(crossings, error.unreached.empty() ? 4 : 0);
  }
}

TEST(FunctionError, WhatIsNotReachedIsTold) {
  // A double rocker with little travel.
  const LinkLengths lengths{1, 0.9, 0.3, 0.8};
  const auto ranges = input_ranges(lengths);
  ASSERT_FALSE(ranges.empty());
  const AngleRange range = ranges.back();
  ASSERT_FALSE(range.is_full_turn());
  const double middle = (range.from + range.to) / 2, length = range.to - range.from;
  const FourBar bars = testing::four_bar_at(lengths, middle, Assembly::positive);
  FunctionTask task = named_task("x", {0, 1}, 1, 40);
  task.function->input_range = {10, 10 + 1.5 * length};
  const double start = 10 + 0.5 * length;
  task.pairs = {{start, 0.3, {}}, {start + 0.1 * length, 0.4, {}}, {start + 0.7 * length, 0.5, {}}};
  const FunctionError error = function_error(bars, task);
  EXPECT_FALSE(error.reaches_pairs);
  EXPECT_TRUE(error.at_pairs[0] && error.at_pairs[1]);
  EXPECT_FALSE(error.at_pairs[2]);
  ASSERT_EQ(error.unreached.size(), 1u);
  EXPECT_NEAR(error.unreached[0].from, 10 + length, 1e-9);
  EXPECT_NEAR(error.unreached[0].to, 10 + 1.5 * length, 1e-12);
  for (const ErrorSample& sample : error.samples)
    EXPECT_EQ(sample.generated.has_value(), sample.input <= 10 + length + 1e-9) << sample.input;
  ASSERT_TRUE(error.max_structural_error);
  EXPECT_LE(error.worst_input, 10 + length + 1e-9);
}

TEST(FunctionError, ARangeThatIsMissedAltogetherHasNoError) {
  const LinkLengths lengths{1, 0.9, 0.3, 0.8};
  const AngleRange range = input_ranges(lengths).back();
  const FourBar bars = testing::four_bar_at(lengths, (range.from + range.to) / 2, Assembly::negative);
  FunctionTask task = named_task("x", {0, 1}, 1, 40);
  task.function->input_range = {pi, pi + 0.2};
  task.pairs = {{0, 0, {}}};
  const FunctionError error = function_error(bars, task);
  EXPECT_FALSE(error.max_structural_error);
  ASSERT_EQ(error.unreached.size(), 1u);
  EXPECT_EQ(error.unreached[0].from, pi);
}

TEST(FunctionError, LinksThatAreNoneGenerateNothing) {
  FunctionTask task = named_task("x^2", {0, 1}, 60, 90);
  const FunctionError error = function_error({0, 0, 1, 2}, task);
  EXPECT_FALSE(error.reaches_pairs);
  EXPECT_FALSE(error.max_structural_error);
  EXPECT_EQ(error.unreached.size(), 1u);
}

TEST(FunctionError, TheWorkedCaseGeneratesItsSquare) {
  const auto& c = testing::planar_case("funcgen4_sqrt");
  FunctionTask task = named_task("x^2", {0, 1}, 60, 90);
  for (std::size_t j = 0; j < 4; ++j) {
    EXPECT_NEAR(task.pairs[j].input, c.json["function_generation"]["phi"][j].get<double>(), 1e-15);
    EXPECT_NEAR(task.pairs[j].output, c.json["function_generation"]["psi"][j].get<double>(), 1e-15);
  }
  for (const auto& given : c.json["function_generators_four_bars"]) {
    const FourBar bars{0, {given["A"][0], given["A"][1]}, 1, {given["B"][0], given["B"][1]}};
    EXPECT_LT(coupler_residual(bars, task.pairs), 1e-10);
    const auto report = find_defects(bars, coupler_poses(bars, task.pairs));
    if (report.defects.none()) {
      EXPECT_LT(function_error(bars, task).precision_error, 1e-10);
    }
  }
}

// Lecture 12 of Kinzel's course: its printed lengths are 1 % off, and give the angles within 0.04°.
TEST(FunctionError, PublishedThreePairs) {
  const auto c = published("fg3-kinzel-lecture12");
  FunctionTask task;
  for (std::size_t j = 0; j < 3; ++j)
    task.pairs.push_back({radians(c["input"]["input_angles_deg"][j]), radians(c["input"]["output_angles_deg"][j]), {}});
  const auto error_of = [&](const nlohmann::json& lengths, double ground) {
    const double r2 = lengths["r2"], r3 = lengths["r3"], r4 = lengths["r4"];
    double least = 10;
    for (const Assembly assembly : {Assembly::negative, Assembly::positive}) {
      const FourBar bars = bars_of(r2 / ground, r3 / ground, r4 / ground, task.pairs[0].input, assembly);
      const FunctionError error = function_error(bars, task);
      // The first pair is the datum here; the published angles are from the frame.
      const double offset = wrap_signed(configuration_of(bars).output_angle - task.pairs[0].output);
      double worst = 0;
      for (const auto& e : error.at_pairs) worst = std::max(worst, std::abs(e.value_or(10) + offset));
      least = std::min(least, worst);
    }
    return least;
  };
  EXPECT_NEAR(degrees(error_of(c["published"], 4.5)), 0.04, 0.005);
  EXPECT_LT(degrees(error_of(c["own_result"], 4.5)), 1e-4);
}

// Negative ratios of Freudenstein's equation are links measured from the other end of their datum.
TEST(FunctionError, PublishedThreePairsFromTheOtherDatum) {
  const auto c = published("fg3-peer-datum-flip");
  for (std::size_t k = 0; k < 4; ++k) {
    FunctionTask task;
    for (std::size_t j = 0; j < 3; ++j)
      task.pairs.push_back(
          {radians(c["input"]["specs"][k]["theta2_deg"][j]), radians(c["input"]["specs"][k]["theta4_deg"][j]), {}});
    const auto& lengths = c["own_result"]["signed_crank_coupler_follower"][k];
    const double crank = lengths[0], follower = lengths[2], ground = c["input"]["ground"];
    EXPECT_LT(crank, 0);
    EXPECT_LT(follower, 0);
    const FourBar bars{0, crank * direction(task.pairs[0].input), ground,
                       ground + follower * direction(task.pairs[0].output)};
    EXPECT_NEAR(bars.lengths().coupler, lengths[1].get<double>(), 1e-5);
    const FunctionError error = function_error(bars, task);
    EXPECT_TRUE(error.reaches_pairs) << "one and the same circuit";
    EXPECT_LT(error.precision_error, 1e-5);
    // A fourth pair from its own drive: the linkage is one of those that meet the four.
    const GeneratedFunction generated = generated_function(bars, task.pairs[0]);
    const double input = (task.pairs[0].input + task.pairs[1].input) / 2;
    const auto output = generated.output_at(input, task.pairs[0].output);
    ASSERT_TRUE(output);
    task.pairs.push_back({input, *output, {}});
    const FunctionConditions given = function_conditions(task.pairs);
    const BurmesterCurve curve(given.conditions);
    const auto working = [&](Point p) {
      return normalized(given.conditions.frame.to_working(Homogeneous::of(p / ground)));
    };
    EXPECT_LT(curve.residual({working(bars.output_moving), working(bars.input_moving), 0}), 1e-5);
  }
}

// Far out the range is finer than the numbers there are.
TEST(FunctionError, OfADialFarFromZeroEnds) {
  const FunctionTask near = named_task("x^2", {0, 1}, 60, 80);
  FunctionTask far = near;
  const double away = 277'777 * two_pi;  // whole turns: 1e8 degrees
  for (double& end : far.function->input_range) end += away;
  far.pairs = precision_pairs(*far.function);
  for (const FourBar& bars : linkages_of(near, 10)) {
    const FunctionError here = function_error(bars, near), there = function_error(bars, far);
    ASSERT_EQ(here.max_structural_error.has_value(), there.max_structural_error.has_value());
    if (here.max_structural_error) {
      EXPECT_NEAR(*here.max_structural_error, *there.max_structural_error, 1e-4);
    }
  }
}

// A table whose one row off the others none of 181 even steps meets.
TEST(FunctionError, LooksAtEveryRowOfALongTable) {
  for (const auto interpolation : {TableInterpolation::linear, TableInterpolation::monotone_cubic}) {
    FunctionTask task = named_task("x^2", {0, 1}, 60, 80);
    NamedFunction& function = *task.function;
    function.expression.clear();
    function.interpolation = interpolation;
    constexpr int rows = 50'000, spike = 31'013;
    for (int i = 0; i <= rows; ++i) {
      const double x = static_cast<double>(i) / rows;
      function.table.push_back({x, x * x + (i == spike ? 0.01 : 0)});
    }
    const FourBar bars = linkages_of(task, 9).front();
    const ScaledFunction scaled(function);
    const GeneratedFunction generated = generated_function(bars, task.pairs.front());
    double worst = 0;
    for (const auto& [x, y] : function.table)
      if (const auto output = generated.output_at(scaled.input_at(x), scaled.output_of(x)))
        worst = std::max(worst, std::abs(*output - scaled.output_of(x)));
    const FunctionError error = function_error(bars, task);
    ASSERT_TRUE(error.max_structural_error);
    EXPECT_GE(*error.max_structural_error, worst);
    EXPECT_NEAR(*error.max_structural_error, worst, 1e-9);
    EXPECT_LT(error.samples.size(), 2000u) << "a plot needs no more";
    EXPECT_EQ(error.samples.front().input, function.input_range[0]);
    EXPECT_EQ(error.samples.back().input, function.input_range[1]);
    EXPECT_TRUE(std::any_of(error.samples.begin(), error.samples.end(), [&](const ErrorSample& sample) {
      return sample.generated && std::abs(std::abs(*sample.generated - sample.wanted) - worst) < 1e-9;
    })) << "the spike is in the plot";
    EXPECT_LE(*function_error(bars, task, ErrorSampling::coarse()).max_structural_error, worst + 1e-9);
  }
}

// Norton, Design of Machinery, section 5.13: the output turns by the square of the input's degrees.
TEST(FunctionError, PublishedFourPairs) {
  const auto c = published("fg4-norton-p262");
  FunctionTask task;
  task.pairs = {{0, 0, {}}};
  for (std::size_t j = 0; j < 3; ++j)
    task.pairs.push_back(
        {radians(c["input"]["input_rotations_deg"][j]), radians(c["input"]["output_rotations_deg"][j]), {}});
  ASSERT_TRUE(mistakes_in(task).empty());
  int free = 0;
  for (const FourBar& bars : linkages_of(task, 200)) {
    if (bars.lengths().longest() > 50 * bars.lengths().shortest()) continue;
    EXPECT_LT(coupler_residual(bars, task.pairs), 1e-10);
    if (!find_defects(bars, coupler_poses(bars, task.pairs)).defects.none()) continue;
    EXPECT_LT(function_error(bars, task).precision_error, 1e-8);
    ++free;
  }
  RecordProperty("defect_free", free);
}

}  // namespace
}  // namespace linkwright::function_error_test
