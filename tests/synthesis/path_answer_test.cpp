#include <algorithm>
#include <gtest/gtest.h>
#include <set>

#include "linkwright/core/angle.hpp"
#include "linkwright/synthesis/solve.hpp"
#include "support/path_case.hpp"
#include "support/solved.hpp"

namespace linkwright::path_answer_test {
namespace {

PathAnswer solved(const PathTask& task, const Requirements& wanted = {}, const SynthesisOptions& options = {}) {
  return testing::solved_as<PathAnswer>(task, wanted, options);
}

SynthesisOptions coarse() {
  SynthesisOptions options;
  options.region_samples = 60;
  return options;
}

// Of the answer's linkages nothing is believed: the bars alone are closed at every point with the crank as given.
void expect_passes(const FourBarSolution& found, const PathTask& task) {
  const FourBar& bars = found.four_bar;
  const LinkLengths lengths = bars.lengths();
  const Point arm = (found.path->point - bars.input_moving) / (bars.output_moving - bars.input_moving);
  for (const PathPoint& there : task.points) {
    const Point a =
        bars.input_fixed + direction(*there.input - *task.points[0].input) * (bars.input_moving - bars.input_fixed);
    const Point b = a + (there.point - a) / arm;
    const double size = lengths.longest() + std::abs(found.path->point - bars.input_moving);
    EXPECT_NEAR(std::abs(b - a), lengths.coupler, 1e-9 * size);
    EXPECT_NEAR(std::abs(b - bars.output_fixed), lengths.output, 1e-9 * size);
  }
}

TEST(PathAnswer, ListsTheBestOfTheMapEachDriven) {
  const testing::PathCase c = testing::path_case("film_claw_timed");
  const PathAnswer answer = solved(c.task, {}, coarse());
  EXPECT_EQ(answer.status, SolutionStatus::solved);
  EXPECT_EQ(answer.pattern, "P-P-P-P");
  EXPECT_EQ(answer.counts.pairs, 60 * 59);
  ASSERT_EQ(answer.linkages.size(), 10u);
  EXPECT_TRUE(answer.pairs.empty());
  EXPECT_EQ(answer.left_out, 0);
  for (const FourBarSolution& found : answer.linkages) {
    EXPECT_TRUE(found.verified_by_driving);
    ASSERT_TRUE(found.path);
    EXPECT_LT(found.path->position_error, 1e-9 * answer.characteristic_length);
    EXPECT_LT(found.path->timing_error, 1e-9);
    EXPECT_FALSE(found.residual_derivatives);
    expect_passes(found, c.task);
  }
  EXPECT_TRUE(std::is_sorted(answer.linkages.begin(), answer.linkages.end(), [](const auto& a, const auto& b) {
    return a.report.min_transmission_angle > b.report.min_transmission_angle;
  }));
}

// Of two cognates the smaller is listed, and not the other.
TEST(PathAnswer, ListsOneOfTwoCognates) {
  const PathAnswer answer = solved(testing::path_case("dough_mixer_timed_full_turn").task, {}, coarse());
  ASSERT_GT(answer.linkages.size(), 5u);
  for (const FourBarSolution& found : answer.linkages) {
    EXPECT_GE(found.path->cognate_size, 1);
    for (const FourBarSolution& other : answer.linkages)
      EXPECT_GT(std::abs(other.four_bar.input_fixed - found.path->cognate.value().input_fixed), 1e-3)
          << "the cognate of one is another";
  }
}

// Where the smaller does not keep a window the larger is there.
TEST(PathAnswer, ListsTheLargerCognateWhereTheSmallerIsNotAllowed) {
  const PathTask task = testing::path_case("film_claw_timed").task;
  Requirements wanted;
  wanted.full_turn = true;
  const PathAnswer all = solved(task, wanted, coarse());
  const auto size = [](const FourBarSolution& found) { return found.path->cognate_size; };
  const auto apart = std::max_element(all.linkages.begin(), all.linkages.end(),
                                      [&](const auto& a, const auto& b) { return size(a) < size(b); });
  ASSERT_NE(apart, all.linkages.end());
  ASSERT_GT(size(*apart), 1.1);
  const FourBar larger = apart->path->cognate.value();
  const double around = 0.02 * larger.lengths().ground;
  const auto [x, y] = std::pair(std::minmax({larger.input_fixed.real(), larger.output_fixed.real()}),
                                std::minmax({larger.input_fixed.imag(), larger.output_fixed.imag()}));
  wanted.ground_pivots_within = Box{x.first - around, x.second + around, y.first - around, y.second + around};
  const PathAnswer inside = solved(task, wanted, coarse());
  ASSERT_FALSE(inside.linkages.empty());
  EXPECT_TRUE(std::any_of(inside.linkages.begin(), inside.linkages.end(),
                          [&](const FourBarSolution& found) { return size(found) < 1; }));
}

TEST(PathAnswer, AFullTurnIsARequirement) {
  const PathTask task = testing::path_case("film_claw_timed").task;
  const PathAnswer any = solved(task, {}, coarse());
  Requirements wanted;
  wanted.full_turn = true;
  const PathAnswer turning = solved(task, wanted, coarse());
  EXPECT_LT(turning.meeting_requirements, any.meeting_requirements);
  EXPECT_GT(turning.meeting_requirements, 0);
  EXPECT_EQ(turning.counts.defect_free, any.counts.defect_free) << "counts do not depend on requirements";
  for (const FourBarSolution& found : turning.linkages) {
    EXPECT_TRUE(found.path->full_turn);
    EXPECT_TRUE(input_is_crank(found.report.type));
  }
  wanted.types = {LinkageType::double_rocker};
  const PathAnswer none = solved(task, wanted, coarse());
  EXPECT_EQ(none.meeting_requirements, 0);
  EXPECT_TRUE(none.linkages.empty());
  EXPECT_FALSE(none.reason.message.empty());
}

TEST(PathAnswer, OfFivePositionsListsAllLinkages) {
  const testing::PathCase c = testing::path_case("stirrer_timed_five");
  const PathAnswer answer = solved(c.task);
  ASSERT_EQ(answer.pairs.size(), 12u);
  std::set<std::pair<double, double>> places;
  for (const FourBarSolution& found : answer.pairs) {
    places.insert({found.input.coordinate, found.output.coordinate});
    EXPECT_TRUE(found.verified_by_driving);
    expect_passes(found, c.task);
  }
  EXPECT_EQ(places.size(), 12u);
  const auto clean = [](const FourBarSolution& f) { return f.report.defects.none(); };
  EXPECT_EQ(std::count_if(answer.pairs.begin(), answer.pairs.end(), clean), answer.counts.defect_free);
  std::int64_t wanted = 0;
  for (const auto& linkage : c.json.at("linkages")) {
    const auto& defects = linkage.at("defects");
    wanted += !defects["order"] && !defects["branch"] && !defects["circuit"];
  }
  EXPECT_EQ(answer.counts.defect_free, wanted);
  EXPECT_FALSE(answer.linkages.empty());
  for (const FourBarSolution& found : answer.linkages) EXPECT_TRUE(clean(found));
}

TEST(PathAnswer, OfMixedPositionsKeepsTheDerivatives) {
  const testing::PathCase c = testing::path_case("packaging_feeder_timed_five_mixed");
  const PathAnswer answer = solved(c.task);
  EXPECT_EQ(answer.pattern, "PP-P-PP");
  ASSERT_EQ(answer.pairs.size(), 2u);
  for (const FourBarSolution& found : answer.pairs) {
    ASSERT_TRUE(found.residual_derivatives);
    EXPECT_LT(*found.residual_derivatives, 1e-12);
    EXPECT_TRUE(found.verified_by_driving);
  }
}

TEST(PathAnswer, ListsWhatIsAtAPlace) {
  const testing::PathCase c = testing::path_case("thread_takeup_timed_mixed");
  SynthesisOptions options = coarse();
  const auto& wanted = c.json.at("linkages")[0];
  options.at = {wanted.at("input_coordinate").get<double>(), wanted.at("output_coordinate").get<double>()};
  const PathAnswer answer = solved(c.task, {}, options);
  ASSERT_EQ(answer.linkages.size(), 1u);
  EXPECT_NEAR(std::abs(answer.linkages[0].four_bar.output_fixed - testing::bars_of(wanted).output_fixed), 0, 1e-7);
}

TEST(PathAnswer, SaysWhyThereIsNothing) {
  const auto items = testing::path_case("nasty_timed").json.at("items");
  const PathAnswer pole = solved(testing::path_task(items[0].at("task")));
  EXPECT_EQ(pole.status, SolutionStatus::degenerate);
  EXPECT_EQ(pole.reason.code, "common_pole");
}

// An error of the point is no error of the coupler's turn.
TEST(PathAnswer, TolerancesAreOfThePointAlone) {
  SynthesisOptions options = coarse();
  options.best = 2;
  Tolerances& tolerances = options.tolerances.emplace();
  tolerances.length = LengthTolerances::all(0.02);
  tolerances.samples = 4000;
  tolerances.turning_length = 0;
  const PathTask task = testing::path_case("film_claw_timed").task;
  const PathAnswer without = solved(task, {}, options);
  options.tolerances->turning_length = 1000;
  const PathAnswer with = solved(task, {}, options);
  ASSERT_EQ(with.tolerance.size(), 2u);
  ASSERT_TRUE(with.tolerance[0] && without.tolerance[0]);
  EXPECT_GT(with.tolerance[0]->error, 0);
  EXPECT_EQ(with.tolerance[0]->error, without.tolerance[0]->error);
}

// ---- points alone ---------------------------------------------------------------------------------------------------

Requirements turning() {
  Requirements wanted;
  wanted.full_turn = true;
  wanted.min_transmission_angle = radians(25);
  return wanted;
}

TEST(PathAnswer, PointsAloneHaveTheBestOfEveryPlaceDriven) {
  const PathTask task = testing::path_case("dough_mixer_five_points").task;
  const PathAnswer answer = solved(task, turning(), coarse());
  EXPECT_EQ(answer.status, SolutionStatus::solved);
  EXPECT_EQ(answer.counts.pairs, 60 * 60);
  ASSERT_EQ(answer.linkages.size(), 10u);
  for (const FourBarSolution& found : answer.linkages) {
    EXPECT_TRUE(found.verified_by_driving);
    ASSERT_TRUE(found.path);
    EXPECT_TRUE(found.path->full_turn);
    EXPECT_FALSE(found.path->cognate);
    EXPECT_EQ(found.path->elbows.size(), 7u);
    EXPECT_EQ(found.path->input.size(), 5u);
    EXPECT_LT(found.path->position_error, 1e-9 * answer.characteristic_length);
    EXPECT_EQ(found.four_bar.input_fixed, *task.pivots.input);
    EXPECT_GE(found.report.min_transmission_angle, radians(25));
    EXPECT_TRUE(found.input.coordinate >= 1 && found.input.coordinate < 97);
  }
}

// The map shows another linkage of a place where others are required, and it is not said that there is none.
TEST(PathAnswer, RequirementsChooseAmongTheLinkagesOfAPlace) {
  const PathTask task = testing::path_case("dough_mixer_five_points").task;
  Requirements wanted;
  const PathAnswer any = solved(task, wanted, coarse());
  wanted.types = {LinkageType::triple_rocker_input};
  const PathAnswer rocking = solved(task, wanted, coarse());
  const auto rockers = [](const PathAnswer& answer) {
    return answer.counts.types[static_cast<std::size_t>(LinkageType::triple_rocker_input)];
  };
  EXPECT_GT(rockers(rocking), rockers(any) + 100);
  EXPECT_GT(rocking.meeting_requirements, 100);
  for (const FourBarSolution& found : rocking.linkages) EXPECT_EQ(found.report.type, LinkageType::triple_rocker_input);
}

TEST(PathAnswer, APlaceListsAllThatMeetTheRequirements) {
  const PathTask task = testing::path_case("dough_mixer_five_points").task;
  SynthesisOptions options = coarse();
  options.at = MapPoint{0.5, 0.4};
  const PathAnswer there = solved(task, {}, options);
  ASSERT_GT(there.linkages.size(), 1u);
  EXPECT_EQ(there.fails.size(), there.linkages.size());
  for (const FourBarSolution& found : there.linkages) {
    EXPECT_NEAR(found.input.coordinate - std::floor(found.input.coordinate), 0.5, 1e-12);
    EXPECT_TRUE(found.verified_by_driving);
    options.at = there.point_of(found);
    const PathAnswer alone = solved(task, {}, options);
    ASSERT_EQ(alone.linkages.size(), 1u);
    EXPECT_EQ(alone.linkages.front().four_bar.output_fixed, found.four_bar.output_fixed);
  }
}

TEST(PathAnswer, BothPivotsLeaveAMapOfArms) {
  const PathTask task = testing::path_case("wiper_pivots_three_points").task;
  const PathAnswer answer = solved(task, {}, coarse());
  ASSERT_EQ(answer.linkages.size(), 10u);
  for (const FourBarSolution& found : answer.linkages) {
    EXPECT_LT(std::abs(found.four_bar.input_fixed - *task.pivots.input), 1e-9);
    EXPECT_LT(std::abs(found.four_bar.output_fixed - *task.pivots.output), 1e-9);
    EXPECT_TRUE(found.verified_by_driving);
    EXPECT_EQ(found.path->elbows.size(), 3u);
  }
}

TEST(PathAnswer, AnArmOfTheOutputLinkIsDrivenByTheOther) {
  PathTask task = testing::path_case("dough_mixer_five_points").task;
  std::swap(task.pivots.input, task.pivots.output);
  const PathAnswer answer = solved(task, {}, coarse());
  ASSERT_FALSE(answer.linkages.empty());
  for (const FourBarSolution& found : answer.linkages) {
    EXPECT_EQ(found.four_bar.output_fixed, *task.pivots.output);
    EXPECT_TRUE(found.verified_by_driving);
    EXPECT_LT(found.path->position_error, 1e-9 * answer.characteristic_length);
  }
}

}  // namespace
}  // namespace linkwright::path_answer_test
