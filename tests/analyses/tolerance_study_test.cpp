#include "linkwright/analyses/tolerance_study.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "analyses/tolerances/tolerance_analysis.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/synthesis/solve.hpp"
#include "support/draws.hpp"
#include "support/file_support.hpp"
#include "synthesis/listed_linkages.hpp"

namespace linkwright::tolerance_study_test {
namespace {

Tolerances some_tolerances(const Problem& problem) {
  Tolerances given;
  const bool on_sphere = std::holds_alternative<SphericalMotionTask>(problem.task) ||
                         std::holds_alternative<SphericalFunctionTask>(problem.task);
  if (on_sphere)
    given.link_angle = radians(0.1);
  else
    given.length = {0.003, 0.002, 0.004, 0.001, 0.005};
  given.driver = radians(0.05);
  given.samples = 20'000;
  return given;
}

Problem problem_of(const std::string& example) {
  constexpr int region_samples = 120;
  Problem problem = testing::example(example + ".json", region_samples);
  problem.options.tolerances = some_tolerances(problem);
  problem.options.best = 3;
  return problem;
}

Answer solved(const Problem& problem) { return solve(problem).value(); }

class EachKind : public ::testing::TestWithParam<const char*> {};

// A map and what is listed come by different ways: a kernel over rows, a sensitivity matrix, sampled linkages.
TEST_P(EachKind, TheMapSaysOfALinkageWhatItsReportSays) {
  const Problem problem = problem_of(GetParam());
  const Answer answer = solved(problem);
  const Findings& found = findings(answer);
  const auto outputs = listed_outputs(answer, found.options.tolerances->turning_length.value_or(0));
  ASSERT_FALSE(outputs.empty());
  ASSERT_EQ(found.tolerance.size(), outputs.size());
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    ASSERT_TRUE(found.tolerance[i]);
    const ToleranceReport& report = *found.tolerance[i];
    EXPECT_NEAR(report.sampled.error / report.error, 1, 0.03);
    EXPECT_GE(report.worst_case, report.error);
    std::visit(
        [&](const auto& of_kind) {
          if (!of_kind.family()) return;
          const auto there =
              found.added.find(measures::tolerance_error)->measure->at(of_kind.point_of(of_kind.linkages[i]));
          EXPECT_NEAR(*there, readable_error(*outputs[i], report.error), 1e-6 * *there);
        },
        answer);
  }
}

// Whole rows in lanes, or cell by cell.
TEST_P(EachKind, RowsAreTheirCells) {
  const Problem problem = problem_of(GetParam());
  const Answer answer = solved(problem);
  const Findings& found = findings(answer);
  if (found.region.rows() == 0) return;
  const auto column = found.region.values(measures::tolerance_error);
  ASSERT_EQ(column.size(), found.region.rows() * found.region.columns());
  int compared = 0;
  for (std::size_t row = 0; row < found.region.rows(); row += 7)
    for (std::size_t k = 0; k < found.region.columns(); k += 5) {
      const std::size_t cell = found.region.index(row, k);
      if (found.region.type(cell) == LinkageType::degenerate) {
        EXPECT_TRUE(column[cell] == 0 || std::isnan(column[cell]));
        continue;
      }
      const auto at = found.added.find(measures::tolerance_error)
                          ->measure->at({found.region.input_coordinates()[row], found.region.output_coordinates()[k]});
      if (!at || !(*at < 1e6) || std::isnan(column[cell])) continue;  // of lines those that meet all else
      EXPECT_NEAR(static_cast<double>(column[cell]), *at, 1e-5 * *at);
      ++compared;
    }
  EXPECT_GT(compared, 0);
}

TEST_P(EachKind, TheSmallestErrorIsSmallerThanOfAnyOtherBest) {
  Problem problem = problem_of(GetParam());
  const auto least = [](const Findings& found) {
    double error = found.tolerance.front()->listed_error();
    for (const auto& report : found.tolerance) error = std::min(error, report->listed_error());
    return error;
  };
  const Answer by_default = solved(problem);
  ASSERT_FALSE(findings(by_default).tolerance.empty());
  problem.options.objective = Objective::tolerance_error;
  const Answer by_error = solved(problem);
  ASSERT_FALSE(findings(by_error).tolerance.empty());
  EXPECT_LE(least(findings(by_error)), 1.001 * least(findings(by_default)));
  EXPECT_EQ(findings(by_error).tolerance.front()->listed_error(), least(findings(by_error))) << "best first";
}

TEST_P(EachKind, ARequirementKeepsLargeErrorsOut) {
  Problem problem = problem_of(GetParam());
  const Answer free = solved(problem);
  const auto outputs = listed_outputs(free, findings(free).options.tolerances->turning_length.value_or(0));
  const double error = readable_error(*outputs[0], findings(free).tolerance[0]->error);
  problem.requirements.max_tolerance_error = 0.9 * error;
  const Answer kept = solved(problem);
  EXPECT_LT(findings(kept).meeting_requirements, findings(free).meeting_requirements);
  for (const auto& report : findings(kept).tolerance)
    EXPECT_LE(readable_error(*outputs[0], report->error), 0.9 * error * 1.0001);
}

INSTANTIATE_TEST_SUITE_P(Examples, EachKind,
                         ::testing::Values("tailgate", "latch", "footrest", "hood_hinge", "sine_generator",
                                           "folding_wing", "universal_joint_like", "loader_bucket_chain",
                                           "straight_luffing_crane", "film_claw", "dough_mixer", "packaging_feeder",
                                           "garage_door_point", "walking_leg_path"));

Problem with_limit(double limit) {
  Problem problem = problem_of("tailgate");
  problem.options.tolerances->length = LengthTolerances::all(0.5);
  problem.options.tolerances->limit = ToleranceLimit{ToleranceLimit::Kind::position, limit};
  return problem;
}

TEST(Yield, IsAColumnOfTheCellsThatMeetAllElse) {
  const Answer answer = solved(with_limit(1.5));
  const Findings& found = findings(answer);
  const auto yields = found.region.values(measures::yield);
  ASSERT_FALSE(yields.empty());
  std::int64_t known = 0;
  for (const float yield : yields) {
    known += !std::isnan(yield);
    EXPECT_TRUE(std::isnan(yield) || (yield >= 0 && yield <= 1));
  }
  EXPECT_EQ(known, found.meeting_requirements);
}

TEST(Yield, IsRequiredAndRanks) {
  Problem problem = with_limit(1.5);
  const std::int64_t free = findings(solved(problem)).meeting_requirements;
  problem.requirements.min_yield = 0.99;
  problem.options.objective = Objective::yield;
  const Answer answer = solved(problem);
  const Findings& found = findings(answer);
  EXPECT_LT(found.meeting_requirements, free);
  ASSERT_FALSE(found.tolerance.empty());
  double before = 1;
  for (const auto& report : found.tolerance) {
    ASSERT_TRUE(report && report->sampled.yield);
    EXPECT_GT(report->sampled.yield->share, 0.97) << "the map has seen a thousand samples of it";
    EXPECT_LE(report->sampled.yield->share, before);
    before = report->sampled.yield->share;
  }
}

TEST(Yield, LeavesRelaxationsOfOtherRequirementsAsTheyAre) {
  Problem problem = with_limit(1.5);
  problem.requirements.max_length = 1;
  const Answer without = solved(problem);
  problem.requirements.min_yield = 0.5;
  const Answer with = solved(problem);
  ASSERT_FALSE(findings(without).relax.empty());
  ASSERT_FALSE(findings(with).relax.empty());
  EXPECT_EQ(findings(with).relax.front().requirement, RequirementKind::max_length);
  EXPECT_EQ(findings(with).relax.front().only_this, findings(without).relax.front().only_this);
}

TEST(ToleranceMeasures, AFrontOfTwoObjectivesListsWhatNothingBeats) {
  Problem problem = problem_of("tailgate");
  problem.options.pareto = {Objective::min_transmission_angle, Objective::tolerance_error};
  const Answer answer = solved(problem);
  const auto& motion = std::get<MotionAnswer>(answer);
  ASSERT_GT(motion.pareto.size(), 3u);
  ASSERT_EQ(motion.linkages.size(), 3u);
  for (std::size_t i = 1; i < motion.linkages.size(); ++i) {
    EXPECT_LT(motion.linkages[i].report.min_transmission_angle, motion.linkages[i - 1].report.min_transmission_angle);
    EXPECT_LT(motion.tolerance[i]->error, motion.tolerance[i - 1]->error);
  }
}

TEST(ToleranceMeasures, AFrontOfSixBarsListsWhatNothingBeats) {
  Problem problem = problem_of("loader_bucket_chain");
  problem.options.pareto = {Objective::min_transmission_angle, Objective::tolerance_error};
  const Answer answer = solved(problem);
  const auto& six_bars = std::get<SixBarAnswer>(answer);
  ASSERT_GE(six_bars.pareto.size(), 2u);
  ASSERT_GE(six_bars.linkages.size(), 2u);
  for (std::size_t i = 1; i < six_bars.linkages.size(); ++i) {
    EXPECT_LT(six_bars.linkages[i].rating.min_transmission_angle(),
              six_bars.linkages[i - 1].rating.min_transmission_angle());
    EXPECT_LT(six_bars.tolerance[i]->error, six_bars.tolerance[i - 1]->error);
  }
}

// Rows of a map share their link 4; on some rows of six-bars link 5 is joined to it.
TEST(ToleranceMeasures, AMapOfSixBarsHasTheErrorsOfItsPlaces) {
  for (const std::array added :
       {std::array{BodyPair{0, 2}, BodyPair{1, 3}}, std::array{BodyPair{0, 2}, BodyPair{4, 3}}}) {
    Problem problem = problem_of("loader_bucket_chain");
    problem.options.region_samples = 64;
    std::get<SixBarTask>(problem.task).added = added;
    const Answer answer = solved(problem);
    const Findings& found = findings(answer);
    const auto errors = found.region.values(measures::tolerance_error);
    std::size_t whole = 0;
    for (std::size_t row = 0; row < found.region.rows(); ++row)
      for (std::size_t column = 0; column < found.region.columns(); ++column) {
        const std::size_t cell = found.region.index(row, column);
        const auto there =
            found.added.find(measures::tolerance_error)
                ->measure->at({found.region.input_coordinates()[row], found.region.output_coordinates()[column]});
        EXPECT_EQ(errors[cell], static_cast<float>(there.value_or(0)));
        whole += errors[cell] > 0 ? 1 : 0;
      }
    EXPECT_GT(whole, 100u);
  }
}

// Contacts at places: the stroke between them begins where the linkage lies, and a stroke asked for may not hold it.
TEST(ToleranceMeasures, AStrokeNeedNotHoldThePlaceWhereTheLinkageLies) {
  for (const std::optional<double> stroke : {std::optional<double>(), std::optional(0.5)}) {
    Problem problem = problem_of("straight_luffing_crane");
    problem.task = StraightLineTask{{{0, 4}, 0}, straight_cases::MixedContacts{{0, 0}, {{1, 3, 1}, {3, 1, 1}}, 0}};
    problem.requirements = {};
    problem.options.line = {.stroke = stroke};
    problem.options.tolerances->limit = ToleranceLimit{ToleranceLimit::Kind::deviation, 0.05};
    problem.options.region_samples = std::min(40, testing::draws(150));
    const Answer answer = solved(problem);
    const auto& lines = std::get<StraightLineAnswer>(answer);
    ASSERT_FALSE(lines.linkages.empty());
    for (std::size_t i = 0; i < lines.linkages.size(); ++i) {
      ASSERT_TRUE(lines.tolerance[i]);
      const auto there = lines.added.find(measures::tolerance_error)->measure->at(lines.point_of(lines.linkages[i]));
      EXPECT_NEAR(*there, lines.tolerance[i]->error, 1e-6 * *there);
    }
  }
}

// Three poses, the other side's length left to the program: it is chosen by maps of which tolerances are not measured.
TEST(ToleranceMeasures, RankLinkagesOfALengthThatIsChosen) {
  Problem problem = testing::example("footrest.json", 60);
  auto& task = std::get<MotionTask>(problem.task);
  ASSERT_EQ(task.poses.size(), 3u);
  std::get<SideAngle>(*task.given).input_length.reset();
  problem.requirements = {};
  problem.options.tolerances = some_tolerances(problem);
  problem.options.tolerances->limit = ToleranceLimit{ToleranceLimit::Kind::position, 0.5};
  for (const Objective objective : {Objective::tolerance_error, Objective::yield}) {
    problem.options.objective = objective;
    EXPECT_FALSE(findings(solved(problem)).tolerance.empty());
  }
}

TEST(ToleranceMeasures, TheSameSeedGivesTheSameAnswerForAnyNumberOfThreads) {
  Problem problem = with_limit(1.5);
  problem.options.region.threads = 1;
  const Answer one = solved(problem);
  problem.options.region.threads = 3;
  const Answer three = solved(problem);
  for (std::size_t i = 0; i < findings(one).tolerance.size(); ++i) {
    EXPECT_EQ(findings(one).tolerance[i]->sampled.error, findings(three).tolerance[i]->sampled.error);
    EXPECT_EQ(findings(one).tolerance[i]->sampled.yield->share, findings(three).tolerance[i]->sampled.yield->share);
  }
}

}  // namespace
}  // namespace linkwright::tolerance_study_test
