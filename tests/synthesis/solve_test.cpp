#include "linkwright/synthesis/solve.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

#include "linkwright/core/angle.hpp"
#include "mechanism/transmission_angle.hpp"
#include "support/file_support.hpp"
#include "support/planar_case.hpp"
#include "support/random_task.hpp"
#include "support/solved.hpp"
#include "support/spherical_function.hpp"
#include "support/tailgate.hpp"

namespace linkwright::solve_test {
namespace {

using testing::nearly_common_pole, testing::nearly_mirrored, testing::solved;
using testing::tailgate_requirements, testing::tailgate_task;

double transmission_angle(const FourBarSolution& linkage) { return linkage.report.min_transmission_angle; }

TEST(SolveMotion, TailgateHasItsKnownMap) {
  const MotionAnswer answer = solved(tailgate_task(), tailgate_requirements());
  EXPECT_EQ(answer.status, SolutionStatus::solved);
  EXPECT_EQ(answer.given.pattern, "P-P-P-P");
  EXPECT_EQ(answer.given.curve->kind(), CubicKind::two_branches);
  EXPECT_NEAR(*answer.given.curve->kappa(), 0.0021, 5e-5);
  EXPECT_NEAR(answer.given.conditions.condition(), 86, 0.5);
  EXPECT_EQ(answer.counts.pairs, 159'600);
  // Two independent implementations count 97 478; one cell is a change point to 5e-10, which we stop at.
  EXPECT_NEAR(static_cast<double>(answer.counts.defect_free), 97'478, 1);
  EXPECT_EQ(answer.meeting_requirements, 25'608);
}

TEST(SolveMotion, TailgateHasTheLinkageOfTheMap) {
  // A cell computed elsewhere: τ = (1.3125, 1.1125), lengths to a hundredth.
  const MotionTask task = tailgate_task();
  const MotionAnswer answer = solved(task);
  const auto linkage = make_four_bar(answer.given, {1.3125, 1.1125}, true, true);
  ASSERT_TRUE(linkage);
  EXPECT_EQ(linkage->report.type, LinkageType::triple_rocker_output);
  EXPECT_NEAR(degrees(transmission_angle(*linkage)), 73.5, 0.05);
  EXPECT_NEAR(linkage->lengths.ground, 65.03, 0.005);
  EXPECT_NEAR(linkage->lengths.input, 211.05, 0.005);
  EXPECT_NEAR(linkage->lengths.coupler, 53.92, 0.005);
  EXPECT_NEAR(linkage->lengths.output, 255.90, 0.005);
  EXPECT_TRUE(linkage->verified_by_driving);
}

TEST(SolveMotion, LinkagesMeetTheRequirementsAndAreChecked) {
  const Requirements wanted = tailgate_requirements();
  for (const Objective objective : {Objective::min_transmission_angle, Objective::link_ratio, Objective::size}) {
    SynthesisOptions options;
    options.objective = objective;
    const MotionAnswer answer = solved(tailgate_task(), wanted, options);
    ASSERT_EQ(answer.linkages.size(), 10u) << name(objective);
    double before = 1e300;
    for (const FourBarSolution& linkage : answer.linkages) {
      EXPECT_TRUE(linkage.verified_by_driving);
      EXPECT_TRUE(linkage.report.defects.none());
      EXPECT_LT(linkage.residual, 1e-12);
      EXPECT_GE(transmission_angle(linkage), wanted.min_transmission_angle);
      const double ratio = linkage.lengths.longest() / linkage.lengths.shortest();
      EXPECT_LE(ratio, wanted.max_link_ratio);
      EXPECT_LE(linkage.lengths.longest(), *wanted.max_length * (1 + 1e-12));
      EXPECT_TRUE(wanted.ground_pivots_within->contains(linkage.four_bar.input_fixed));
      EXPECT_TRUE(wanted.ground_pivots_within->contains(linkage.four_bar.output_fixed));
      EXPECT_TRUE(wanted.moving_pivots_within->contains(linkage.four_bar.input_moving));
      EXPECT_TRUE(wanted.moving_pivots_within->contains(linkage.four_bar.output_moving));
      const double score =
          rank_of(objective, planar_measures)
              .score({linkage.report.type,
                      {},
                      {versine_of_angle(linkage.report.min_transmission_angle), 0, ratio, linkage.lengths.longest()}});
      EXPECT_LE(score, before);
      before = score;
    }
  }
}

TEST(SolveMotion, BestIsAtLeastAsGoodAsTheBestCellAndAFinerMap) {
  const MotionAnswer coarse = solved(tailgate_task(), tailgate_requirements());
  SynthesisOptions fine;
  fine.region_samples = 1600;
  const MotionAnswer finer = solved(tailgate_task(), tailgate_requirements(), fine);
  const auto best_cell = [](const FourBarAnswer& s) {
    const RequirementFilter filter = filter_of(*s.given.family, s.region, s.requirements);
    return angle_of_versine(hill_tops(s.region, filter, Objective::min_transmission_angle, 1)[0].score);
  };
  EXPECT_GE(transmission_angle(coarse.linkages[0]), best_cell(coarse) - 1e-6);
  EXPECT_GE(transmission_angle(coarse.linkages[0]), best_cell(finer) - 1e-4);
  EXPECT_NEAR(transmission_angle(coarse.linkages[0]), transmission_angle(finer.linkages[0]), 1e-4);
}

double pivots_apart(const FourBar& a, const FourBar& b) {
  return std::max({std::abs(a.input_fixed - b.input_fixed), std::abs(a.input_moving - b.input_moving),
                   std::abs(a.output_fixed - b.output_fixed), std::abs(a.output_moving - b.output_moving)});
}

TEST(SolveMotion, LinkagesAreDistinctAndAppearOnceWhicheverSideDrives) {
  SynthesisOptions options;
  options.best = 40;
  const MotionAnswer answer = solved(tailgate_task(), {}, options);
  const double least = 1e-2 * answer.given.conditions.frame.scale;
  for (std::size_t i = 0; i < answer.linkages.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_GT(pivots_apart(answer.linkages[i].four_bar, answer.linkages[j].four_bar), least);
      EXPECT_GT(pivots_apart(answer.linkages[i].four_bar, answer.linkages[j].four_bar.swapped()), least);
    }
  for (const FourBarSolution& linkage : answer.linkages) {
    if (!linkage.swapped.defects.none()) continue;
    EXPECT_GE(linkage.report.min_transmission_angle, linkage.swapped.min_transmission_angle);
  }
}

TEST(SolveMotion, SizeLimitIsTenCharacteristicLengthsUnlessSwitchedOff) {
  const MotionAnswer limited = solved(tailgate_task());
  EXPECT_EQ(limited.requirements.max_length, 10 * limited.given.conditions.frame.scale);
  EXPECT_EQ(limited.requirements.min_length, 1e-3 * limited.given.conditions.frame.scale);
  Requirements unlimited;
  unlimited.max_length = Requirements::unlimited;
  unlimited.max_link_ratio = Requirements::unlimited;
  EXPECT_GT(solved(tailgate_task(), unlimited).meeting_requirements, limited.meeting_requirements);
}

TEST(SolveMotion, SaysWhichRequirementCostsMostWhenNothingIsLeft) {
  Requirements wanted = tailgate_requirements();
  wanted.min_transmission_angle = radians(89);
  const MotionAnswer answer = solved(tailgate_task(), wanted);
  EXPECT_EQ(answer.status, SolutionStatus::solved);
  EXPECT_TRUE(answer.linkages.empty());
  EXPECT_NE(answer.reason.message.find("min_transmission_angle_deg is the most restrictive"), std::string::npos)
      << answer.reason.message;
  ASSERT_FALSE(answer.relax.empty());
  wanted.min_transmission_angle = *answer.relax[0].value;
  EXPECT_EQ(solved(tailgate_task(), wanted).meeting_requirements, answer.relax[0].leaves);
}

TEST(SolveMotion, SaysWhyNothingIsFreeOfDefects) {
  const MotionAnswer answer = solved({testing::planar_case("foldable_table").poses});
  EXPECT_EQ(answer.counts.defect_free, 0);
  EXPECT_NE(answer.reason.message.find("is free of defects"), std::string::npos) << answer.reason.message;
  EXPECT_EQ(answer.reason.message.find(" 0 %"), std::string::npos) << answer.reason.message;
}

TEST(SolveMotion, DefectsMayBeAllowed) {
  Requirements wanted;
  wanted.no_defects = false;
  SynthesisOptions options;
  options.objective = Objective::link_ratio;
  const MotionAnswer answer = solved({testing::planar_case("foldable_table").poses}, wanted, options);
  ASSERT_FALSE(answer.linkages.empty());
  for (const FourBarSolution& linkage : answer.linkages) EXPECT_TRUE(linkage.verified_by_driving);
}

std::vector<PrescribedPose> turns_about(Point pole, const std::vector<double>& angles) {
  std::vector<PrescribedPose> poses;
  for (const double angle : angles) poses.push_back({{pole + direction(angle) * Point{3, 1}, angle}, {}});
  return poses;
}

TEST(SolveMotion, NamesTheDegeneracy) {
  const MotionAnswer one_pole = solved({turns_about({5, -7}, {0, 0.5, 1.2, 2})});
  EXPECT_EQ(one_pole.status, SolutionStatus::degenerate);
  EXPECT_NE(one_pole.reason.message.find("common pole, (5, -7)"), std::string::npos) << one_pole.reason.message;
  const MotionAnswer on_circle = solved({testing::planar_case("translations_on_circle").poses});
  EXPECT_EQ(on_circle.status, SolutionStatus::degenerate);
  EXPECT_TRUE(on_circle.given.warnings.empty());
  EXPECT_NE(on_circle.reason.message.find("(-2, 0) from it"), std::string::npos) << on_circle.reason.message;
  const MotionAnswer shifts = solved({testing::planar_case("pure_translations").poses});
  EXPECT_EQ(shifts.status, SolutionStatus::degenerate);
  EXPECT_NE(shifts.reason.message.find("pure translation"), std::string::npos) << shifts.reason.message;
}

TEST(SolveMotion, WarnsOfParallelAndOfClosePoses) {
  const MotionAnswer parallel = solved({testing::planar_case("three_parallel").poses});
  ASSERT_EQ(parallel.given.warnings.size(), 1u);
  EXPECT_EQ(parallel.given.warnings[0].code, "parallel_poses");
  EXPECT_NE(parallel.given.warnings[0].message.find("1, 2 and 3"), std::string::npos)
      << parallel.given.warnings[0].message;
  const MotionAnswer pairs = solved({testing::planar_case("two_translation_pairs").poses});
  EXPECT_EQ(pairs.given.warnings.size(), 2u);
  const MotionAnswer close = solved({testing::planar_case("tiny_1e-6").poses});
  ASSERT_FALSE(close.given.warnings.empty());
  EXPECT_EQ(close.given.warnings[0].code, "ill_conditioned");
  EXPECT_NE(close.given.warnings[0].message.find("derivatives"), std::string::npos);
}

bool warns(const MotionAnswer& answer, const std::string& code) {
  const auto& warnings = answer.warnings;
  return std::any_of(warnings.begin(), warnings.end(), [&](const Notice& warning) { return warning.code == code; });
}

TEST(SolveMotion, NearACommonPoleEveryLinkageIsOneAndAHingeIsNamed) {
  SynthesisOptions options;
  options.region_samples = 60;
  std::mt19937_64 random(4);
  Requirements any_length;
  any_length.min_length = 0;
  bool found = false;
  for (const double deviation : {1e-6, 1e-7, 1e-8, 1e-9}) {
    const MotionAnswer answer = solved({nearly_common_pole(random, deviation)}, any_length, options);
    EXPECT_TRUE(warns(answer, "near_common_pole")) << deviation;
    EXPECT_FALSE(warns(answer, "side_links_left_out")) << deviation;
    for (const FourBarSolution& linkage : answer.linkages) {
      EXPECT_LT(linkage.residual, 1e-6) << deviation;
      EXPECT_TRUE(linkage.verified_by_driving) << deviation;
      found = true;
    }
  }
  EXPECT_TRUE(found);
}

TEST(SolveMotion, LeavesOutSideLinksThatDoNotKeepTheirLengths) {
  SynthesisOptions options;
  options.region_samples = 60;
  std::mt19937_64 random(4);
  const MotionAnswer answer = solved({nearly_common_pole(random, 1e-12)}, {}, options);
  EXPECT_TRUE(warns(answer, "side_links_left_out"));
  EXPECT_TRUE(answer.linkages.empty());
}

// Positions 4e-5 apart that move apart at thousands: hundreds of the best are decided by rounding, and each is driven.
TEST(SolveMotion, LooksNoFurtherThanItCanConfirm) {
  const MotionTask task{{{{{-0.9834762526975566, -1.5898325833885882}, radians(-58.578334543)},
                          {{{355.7871666566817, -579.2178543672314}, -1.488927507862679}}},
                         {{{-0.983457057608122, -1.589866834416212}, radians(-58.580390056)},
                          {{{4845.0802607355145, 3560.571800467416}, -1.7960454907643078}}}}};
  SynthesisOptions options;
  options.region_samples = 126;
  options.best = 1;
  Requirements any;
  any.max_link_ratio = Requirements::unlimited;
  any.min_length = 0;
  const MotionAnswer answer = solved(task, any, options);
  EXPECT_TRUE(warns(answer, "linkages_left_out"));
  EXPECT_TRUE(answer.linkages.empty());
  EXPECT_LT(answer.left_out, 100);
}

TEST(SolveMotion, NamesTheSpacingThatShowsAHiddenStretch) {
  SynthesisOptions options;
  options.region_samples = 100;
  std::mt19937_64 random(1);
  const MotionTask task{nearly_mirrored(random, 1e-6)};
  EXPECT_TRUE(warns(solved(task, {}, options), "stretch_between_samples"));
  options.spacing = Spacing::arc_length;
  EXPECT_FALSE(warns(solved(task, {}, options), "stretch_between_samples"));
  EXPECT_TRUE(solved(tailgate_task()).given.warnings.empty());
}

TEST(SolveMotion, ReportsMistakesOfAllThreeParts) {
  Requirements wanted;
  wanted.max_link_ratio = 0;
  SynthesisOptions options;
  options.region_samples = 7;
  options.best = -1;
  const auto result = solve({{}, wanted, options});
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.errors().size(), 4u);
}

TEST(SolveMotion, WindowSamplesAPartOfTheMap) {
  SynthesisOptions options;
  options.window = MapWindow{{1.2, 1.4}, {1.0, 1.2}};
  options.region_samples = 50;
  const MotionAnswer answer = solved(tailgate_task(), {}, options);
  EXPECT_NEAR(answer.region.input_coordinates()[0], 1.202, 1e-12);
  EXPECT_NEAR(answer.region.output_coordinates()[49], 1.198, 1e-12);
  EXPECT_FALSE(answer.linkages.empty());
  for (const FourBarSolution& linkage : answer.linkages) {
    EXPECT_TRUE(linkage.input.coordinate >= 1.2 && linkage.input.coordinate <= 1.4);
    EXPECT_TRUE(linkage.output.coordinate >= 1.0 && linkage.output.coordinate <= 1.2);
  }
  options.window = MapWindow{{0.2, 0.1}, {0, 1}};
  EXPECT_FALSE(solve({tailgate_task(), {}, options}).ok());
}

TEST(SolveMotion, CanBeStopped) {
  std::atomic<bool> stop{true};
  Progress progress;
  progress.cancelled = &stop;
  const auto result = solve({tailgate_task()}, progress);
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.errors()[0].code, "cancelled");
}

TEST(SolveMotion, TellsHowFarItIs) {
  double last = 0;
  Progress progress;
  progress.report = [&](double done) {
    EXPECT_GE(done, last);
    last = done;
  };
  ASSERT_TRUE(solve({tailgate_task()}, progress).ok());
  EXPECT_EQ(last, 1);
}

// Which of five positions to free is a second half of the way.
TEST(SolveMotion, FivePositionsAreSolvedWithoutSteppingBack) {
  std::mt19937_64 random(3);
  MotionTask task{testing::random_poses(random, 5)};
  while (solved(task).relaxed.empty()) task.poses = testing::random_poses(random, 5);
  std::vector<double> reports;
  std::atomic<bool> stop = false;
  Progress progress;
  progress.report = [&](double done) { reports.push_back(done); };
  ASSERT_TRUE(solve({task}, progress).ok());
  EXPECT_TRUE(std::is_sorted(reports.begin(), reports.end()));
  EXPECT_EQ(reports.back(), 1);
  progress.cancelled = &stop;
  progress.report = [&](double done) { stop = done > 0.55; };
  const auto stopped = solve({task}, progress);
  ASSERT_FALSE(stopped.ok());
  EXPECT_EQ(stopped.errors()[0].code, "cancelled");
}

TEST(SolveMotion, SameInputSameOutput) {
  SynthesisOptions one_thread;
  one_thread.region.threads = 1;
  const MotionAnswer a = solved(tailgate_task(), tailgate_requirements()),
                     b = solved(tailgate_task(), tailgate_requirements(), one_thread);
  ASSERT_EQ(a.linkages.size(), b.linkages.size());
  for (std::size_t i = 0; i < a.linkages.size(); ++i) {
    EXPECT_EQ(a.linkages[i].four_bar.input_fixed, b.linkages[i].four_bar.input_fixed);
    EXPECT_EQ(a.linkages[i].input.coordinate, b.linkages[i].input.coordinate);
  }
}

// ---- mixed positions

MotionTask hood() {
  MotionTask task;
  task.poses = {{{{0, 0}, 0}, {{{0, 1}, -0.004}}}, {{{-30, 75}, radians(-25)}, {}}, {{{-75, 75}, radians(-55)}, {}}};
  return task;
}

Requirements hood_requirements() {
  Requirements wanted;
  wanted.min_transmission_angle = radians(30);
  wanted.max_link_ratio = 6;
  wanted.max_length = 400;
  wanted.ground_pivots_within = Box{-450, 60, -220, -30};
  wanted.moving_pivots_within = Box{-450, -10, -120, -10};
  return wanted;
}

TEST(SolveMotion, KeepsADirectionOfTravel) {
  const MotionTask task = hood();
  const MotionAnswer answer = solved(task, hood_requirements());
  EXPECT_EQ(answer.given.pattern, "PP-P-P");
  ASSERT_GE(answer.linkages.size(), 3u);
  for (const FourBarSolution& found : answer.linkages) {
    EXPECT_TRUE(found.verified_by_driving);
    ASSERT_TRUE(found.residual_derivatives);
    EXPECT_LT(*found.residual_derivatives, 1e-14);
    // The instant centre, where the grounded links meet, is the one that was prescribed: (250, 0).
    const FourBar& bars = found.four_bar;
    const Point a = bars.input_moving - bars.input_fixed, b = bars.output_moving - bars.output_fixed;
    const Point gap = bars.output_fixed - bars.input_fixed;
    const Point meet = bars.input_fixed + cross(gap, b) / cross(a, b) * a;
    EXPECT_NEAR(std::abs(meet - Point{250, 0}), 0, 1e-9 * 250);
    // Driven a little in its sense, the edge sets off upwards.
    const double sense = found.report.sense == DriveSense::cw ? -1 : 1;
    EXPECT_GT(sense * cross(a, Point{0, -0.004} * (bars.input_moving - Point{250, 0})), 0);
  }
}

TEST(SolveMotion, FinitePosesHaveNoResidualOfDerivatives) {
  EXPECT_FALSE(solved(tailgate_task()).linkages.front().residual_derivatives);
}

// y = x² with its rate at the beginning.
std::vector<AnglePair> pairs_with_rate() {
  const auto pair = [](double x) { return AnglePair{radians(60 * x), radians(70 * x * x), {}}; };
  std::vector<AnglePair> pairs = {pair(0.1), pair(0.5), pair(0.9)};
  pairs[0].derivatives = {{radians(60), radians(14)}};
  return pairs;
}

template <class KindAnswer, class KindTask>
void expect_rates_met(const KindTask& task) {
  const auto answer = solve({task});
  ASSERT_TRUE(answer.ok());
  const auto& linkages = std::get<KindAnswer>(*answer).linkages;
  ASSERT_FALSE(linkages.empty());
  for (const auto& found : linkages) EXPECT_LT(found.residual_derivatives.value_or(1), 1e-12);
}

TEST(SolveFunction, LinkagesSayHowWellTheyMeetRates) {
  FunctionTask planar;
  planar.pairs = pairs_with_rate();
  expect_rates_met<FunctionAnswer>(planar);
  SphericalFunctionTask spherical;
  spherical.pairs = pairs_with_rate();
  spherical.ground_angle = radians(60);
  expect_rates_met<SphericalFunctionAnswer>(spherical);
}

TEST(SolveMotion, AgainstTheDirectionIsADefectUnlessItDoesNotCount) {
  MotionTask against = hood();
  against.poses[0].derivatives[0] = {{0, -1}, 0.004};
  Requirements wanted = hood_requirements();
  const MotionAnswer forwards = solved(hood(), wanted), backwards = solved(against, wanted);
  EXPECT_TRUE(backwards.linkages.empty());
  EXPECT_EQ(forwards.counts.types, backwards.counts.types);
  EXPECT_EQ(forwards.counts.branch, backwards.counts.branch);
  wanted.respect_direction = false;
  const MotionAnswer either = solved(against, wanted);
  // With three poses every driver is in order one way, which is forwards or backwards.
  EXPECT_LE(std::abs(either.counts.defect_free - forwards.counts.defect_free - backwards.counts.defect_free), 4);
  ASSERT_EQ(either.linkages.size(), forwards.linkages.size());
  for (const FourBarSolution& found : either.linkages) {
    EXPECT_TRUE(found.verified_by_driving);
    EXPECT_EQ(find_defects(found.four_bar, against.poses).defects, Defects{Defects::order_bit});
  }
}

TEST(SolveMotion, OnePoseWithThreeDerivativesAsksNothingOfOrderAndBranch) {
  SynthesisOptions options;
  options.region_samples = 101;
  Requirements wanted;
  wanted.max_length = wanted.max_link_ratio = Requirements::unlimited;
  const MotionAnswer answer = solved({testing::planar_case("mixed_PPPP").poses}, wanted, options);
  EXPECT_EQ(answer.given.pattern, "PPPP");
  EXPECT_EQ(answer.counts.defect_free, answer.counts.pairs);
  EXPECT_EQ(answer.counts.order + answer.counts.branch + answer.counts.circuit, 0);
  ASSERT_FALSE(answer.linkages.empty());
  for (const FourBarSolution& found : answer.linkages) {
    EXPECT_TRUE(found.verified_by_driving);
    EXPECT_EQ(found.report.sweep, 0);
    EXPECT_NE(found.report.sense, DriveSense::none);
    EXPECT_NE(found.report.sense, DriveSense::either) << "only one sense goes the prescribed way";
    const double there = linkwright::transmission_angle(found.lengths, configuration_of(found.four_bar));
    EXPECT_NEAR(transmission_angle(found), there, 1e-7);
  }
  for (std::size_t row = 0; row < answer.region.rows(); ++row)
    EXPECT_EQ(answer.region.driver_sweep(row, (row + 1) % 101), 0);
}

TEST(SolveMotion, NamesTheDegeneracyOfMixedPositions) {
  // Turning about (5, −7): d = pole + e^{it}(d − pole).
  const Point pole{5, -7}, arm{3, 1}, i{0, 1};
  MotionTask turning{{{{pole + arm, 0}, {{i * arm, 1}, {-arm, 0}, {-i * arm, 0}}}}};
  const MotionAnswer one_pole = solved(turning);
  EXPECT_EQ(one_pole.status, SolutionStatus::degenerate);
  EXPECT_NE(one_pole.reason.message.find("common pole, (5, -7)"), std::string::npos) << one_pole.reason.message;

  const MotionTask shifting{{{{{0, 0}, 0.3}, {{{1, 0}, 0}, {{0, 2}, 0}, {{-4, 1}, 0}}}}};
  EXPECT_NE(solved(shifting).reason.message.find("pure translation"), std::string::npos);
  // On a circle of radius ½ about (0, ½): a parallelogram.
  const MotionTask rolling{{{{{0, 0}, 0.3}, {{{1, 0}, 0}, {{0, 2}, 0}, {{-4, 0}, 0}}}}};
  const std::string on_circle = solved(rolling).reason.message;
  EXPECT_NE(on_circle.find("(0, 0.5) from it"), std::string::npos) << on_circle;

  // Parallel poses between which the body turns are no translation.
  const MotionTask there_and_back{{{{{0, 0}, 0}, {{{0, 1}, 0.3}}}, {{{2, 1}, 0}, {{{0.2, -1}, -0.4}}}}};
  const MotionAnswer answer = solved(there_and_back);
  EXPECT_NE(answer.status, SolutionStatus::degenerate) << answer.reason.message;
  EXPECT_GT(answer.counts.pairs, 0);
}

// ---- a place of the map
// ----------------------------------------------------------------------------------------------

class SolveAtAPlace : public ::testing::Test {
 protected:
  SolveAtAPlace() { options.region_samples = 60; }
  [[nodiscard]] MotionAnswer at(MapPoint place) {
    options.at = place;
    return solved(tailgate_task(), wanted, options);
  }
  Requirements wanted = tailgate_requirements();
  SynthesisOptions options;
};

TEST_F(SolveAtAPlace, ListsTheLinkageThereAndNothingElse) {
  const MotionAnswer best = solved(tailgate_task(), wanted, options);
  const MapPoint place = best.point_of(best.linkages.at(3));
  const MotionAnswer picked = at(place);
  ASSERT_EQ(picked.linkages.size(), 1u);
  EXPECT_EQ(picked.linkages[0].four_bar.input_moving, best.linkages[3].four_bar.input_moving);
  EXPECT_EQ(picked.linkages[0].four_bar.output_fixed, best.linkages[3].four_bar.output_fixed);
  EXPECT_TRUE(picked.linkages[0].verified_by_driving);
  EXPECT_EQ(picked.fails, (std::vector<std::vector<RequirementKind>>{{}}));
  EXPECT_EQ(picked.status, SolutionStatus::solved);
  EXPECT_EQ(picked.reason.code, "picked");
  EXPECT_EQ(picked.counts.types, best.counts.types) << "the region as ever";
  EXPECT_EQ(picked.meeting_requirements, best.meeting_requirements);
}

TEST_F(SolveAtAPlace, NamesWhatIsFailedAsTheMapDoes) {
  const MotionAnswer best = solved(tailgate_task(), wanted, options);
  const RequirementFilter filter = filter_of(*best.family(), best.region, best.requirements);
  int failing = 0;
  for (std::size_t cell = 7; cell < 3600; cell += 311) {
    const std::size_t row = cell / 60, column = cell % 60;
    const MotionAnswer picked = at({best.region.input_coordinates()[row], best.region.output_coordinates()[column]});
    if (best.region.type(cell) == LinkageType::degenerate) {
      EXPECT_TRUE(picked.linkages.empty());
      continue;
    }
    ASSERT_EQ(picked.linkages.size(), 1u);
    unsigned bits = 0;
    for (const RequirementKind kind : picked.fails[0]) bits |= 1u << place_among(filter.kinds(), kind);
    EXPECT_EQ(bits, filter.failures(row, column));
    failing += bits != 0;
  }
  EXPECT_GT(failing, 3);
}

TEST_F(SolveAtAPlace, SaysWhyThereIsNothing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const MapPoint off : {MapPoint{-0.1, 0.5}, {0.5, 2.1}, {nan, 0.5}, {0.5, 0.5}}) {  // the last: one link twice
    const MotionAnswer picked = at(off);
    EXPECT_TRUE(picked.linkages.empty());
    EXPECT_TRUE(picked.fails.empty());
    EXPECT_EQ(picked.status, SolutionStatus::no_solution);
    EXPECT_EQ(picked.reason.code, "nothing_there");
    EXPECT_GT(picked.meeting_requirements, 0) << "the region as ever";
  }
}

TEST_F(SolveAtAPlace, AsksForNoBestAndRaisesNoAlarm) {
  options.best = 0;
  options.objective = Objective::size;
  wanted.no_defects = true;
  wanted.min_transmission_angle = 0;
  const MotionAnswer picked = at({1.3125, 1.1125});
  ASSERT_EQ(picked.linkages.size(), 1u);
  EXPECT_EQ(picked.linkages[0].report.type, LinkageType::triple_rocker_output);
  for (const Notice& warning : picked.warnings) EXPECT_NE(warning.code, "held_by_locking");
}

TEST_F(SolveAtAPlace, OfAFunctionHasItsError) {
  FunctionTask task;
  task.pairs = {{0, 0}, {0.5, 0.4}, {1, 0.7}, {1.6, 0.9}};
  const FunctionAnswer best = solved(task, {}, options);
  ASSERT_FALSE(best.linkages.empty());
  options.at = best.point_of(best.linkages.back());
  const FunctionAnswer picked = solved(task, {}, options);
  ASSERT_EQ(picked.linkages.size(), 1u);
  EXPECT_EQ(picked.linkages[0].four_bar.output_moving, best.linkages.back().four_bar.output_moving);
  EXPECT_TRUE(picked.linkages[0].function);
}

TEST(SolveSphericalFunction, ListsGeneratorsThatDrivingConfirms) {
  const SphericalFunctionAnswer answer = solved(testing::named_spherical_task("log", {1, 2}, 60, -70, 40));
  EXPECT_EQ(answer.status, SolutionStatus::solved);
  ASSERT_FALSE(answer.linkages.empty());
  EXPECT_TRUE(answer.pairs.empty());
  for (const SphericalSolution& found : answer.linkages) {
    EXPECT_TRUE(found.verified_by_driving);
    ASSERT_TRUE(found.function);
    EXPECT_TRUE(found.function->reaches_pairs);
    EXPECT_LT(found.function->precision_error, 1e-9);
    EXPECT_NEAR(found.angles.ground, radians(40), 1e-12);
  }
}

TEST(SolveSphericalFunction, RanksByStructuralErrorWhereAsked) {
  SynthesisOptions options;
  options.objective = Objective::structural_error;
  const SphericalFunctionTask task = testing::named_spherical_task("log", {1, 2}, 60, -70, 40);
  const SphericalFunctionAnswer answer = solved(task, {}, options), usual = solved(task);
  ASSERT_FALSE(answer.linkages.empty());
  for (std::size_t i = 0; i + 1 < answer.linkages.size(); ++i)
    EXPECT_LE(*answer.linkages[i].function->max_structural_error,
              *answer.linkages[i + 1].function->max_structural_error + 1e-12);
  for (const SphericalSolution& found : usual.linkages)
    EXPECT_GE(found.function->max_structural_error.value_or(10) + 1e-9,
              *answer.linkages[0].function->max_structural_error);
  const auto refused = solve({testing::spherical_function_case("stapler-function-4"), {}, options});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.errors()[0].code, "objective_of_function");
}

TEST(SolveSphericalFunction, FivePairsListEveryLinkageWhateverItsDefects) {
  const SphericalFunctionAnswer answer = solved(testing::spherical_function_case("function-five-real-5"));
  EXPECT_EQ(answer.pairs.size(), 5u);
  for (const SphericalSolution& found : answer.pairs) {
    ASSERT_TRUE(found.function);
    EXPECT_LT(found.residual, 1e-9);
  }
}

TEST(SolveSixBars, LooksCloserAtWindowsForHingesWhereTheMapShowsLittle) {
  Problem problem = testing::example("loader_bucket_chain.json", 300);
  const auto solved_now = [&] { return solve(problem).value(); };
  const Answer of_many = solved_now();
  const Findings& many = findings(of_many);
  EXPECT_GT(many.meeting_requirements, 40);
  EXPECT_FALSE(many.inside) << "the map has enough to climb from";
  problem.requirements.max_length = 1400;
  const Answer of_none = solved_now();
  const Findings& none = findings(of_none);
  ASSERT_TRUE(none.inside);
  EXPECT_GT(none.inside->looked_at, 1000);
}

TEST(SolveSixBars, LooksAtAWindowOnly) {
  Problem problem = testing::example("loader_bucket_chain.json", 160);
  problem.options.window = MapWindow{{0.2, 0.45}, {0.1, 0.4}};
  const Answer answer = solve(problem).value();
  const auto& six_bars = std::get<SixBarAnswer>(answer);
  EXPECT_GT(six_bars.region.input_coordinates().front(), 0.2);
  EXPECT_LT(six_bars.region.output_coordinates().back(), 0.4);
  for (const SixBarSolution& found : six_bars.linkages)
    EXPECT_TRUE(is_within(*six_bars.chain, problem.options.window, six_bars.chain->point_of(found.member)));
  problem.options.window.reset();
  const Answer whole = solve(problem).value();
  ASSERT_FALSE(std::get<SixBarAnswer>(whole).linkages.empty());
  const MapPoint best = six_bars.chain->point_of(std::get<SixBarAnswer>(whole).linkages.front().member);
  problem.options.window = MapWindow{{best.input - 0.02, best.input + 0.02}, {best.output - 0.02, best.output + 0.02}};
  const Answer near = solve(problem).value();
  ASSERT_FALSE(std::get<SixBarAnswer>(near).linkages.empty());
  EXPECT_GE(std::get<SixBarAnswer>(near).linkages.front().rating.min_transmission_angle(),
            0.99 * std::get<SixBarAnswer>(whole).linkages.front().rating.min_transmission_angle());
}

TEST_F(SolveAtAPlace, OfASearchIsRefused) {
  SixBarTask task;
  task.poses = tailgate_task().poses;
  task.box = Box{-500, 500, -500, 500};
  options.at = MapPoint{0.5, 0.5};
  const auto refused = solve({task, {}, options});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.errors()[0].code, "place_of_search");
  EXPECT_EQ(refused.errors()[0].place, "options.at");
}

}  // namespace
}  // namespace linkwright::solve_test
