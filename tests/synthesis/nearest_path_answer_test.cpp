#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/synthesis/solve.hpp"
#include "support/solved.hpp"

namespace linkwright::nearest_path_answer_test {
namespace {

PathTask through(const std::vector<Point>& places, bool closed) {
  PathTask task;
  for (const Point place : places) task.points.push_back({place, {}, {}, {}});
  task.closed = closed;
  return task;
}

// A bean: no four-bar passes it exactly.
PathTask bean() {
  std::vector<Point> places;
  for (int k = 0; k < 16; ++k) {
    const double t = two_pi * k / 16;
    places.emplace_back(90 * std::cos(t), 48 * std::sin(t) + 18 * std::cos(2 * t + 0.3));
  }
  return through(places, true);
}

PathAnswer solved(const PathTask& task, const Requirements& wanted = {}) {
  SynthesisOptions options;
  options.objective = Objective::path_error;
  options.fit.effort = FitEffort::quick;
  return testing::solved_as<PathAnswer>(task, wanted, options);
}

bool has_warning(const PathAnswer& answer, std::string_view code) {
  return std::any_of(answer.warnings.begin(), answer.warnings.end(),
                     [&](const Notice& notice) { return notice.code == code; });
}

// The path by the bars alone: the input turned step by step, the coupler's other end where the circles meet that is
// nearer to the one before.
std::vector<Point> path_by_turning(const FourBar& bars, Point point, double from, double to, int steps) {
  const Point crank = bars.input_moving - bars.input_fixed;
  const Point arm = (point - bars.input_moving) / (bars.output_moving - bars.input_moving);
  const LinkLengths lengths = bars.lengths();
  Point before = bars.output_moving;
  std::vector<Point> path;
  for (int k = 0; k <= steps; ++k) {
    const double turn = from + (to - from) * k / steps;
    const Point a = bars.input_fixed + direction(turn) * crank;
    const Point d = bars.output_fixed - a;
    const double along = (std::norm(d) + lengths.coupler * lengths.coupler - lengths.output * lengths.output) / 2;
    const double across = std::sqrt(std::max(std::norm(d) * lengths.coupler * lengths.coupler - along * along, 0.0));
    const Point one = a + d * Point{along, across} / std::norm(d), other = a + d * Point{along, -across} / std::norm(d);
    before = std::abs(one - before) < std::abs(other - before) ? one : other;
    path.push_back(a + (before - a) * arm);
  }
  return path;
}

double nearest(const std::vector<Point>& path, Point place) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k + 1 < path.size(); ++k) {
    const Point side = path[k + 1] - path[k];
    const double share =
        std::clamp(std::real(std::conj(side) * (place - path[k])) / std::max(std::norm(side), 1e-300), 0.0, 1.0);
    least = std::min(least, std::abs(path[k] + share * side - place));
  }
  return least;
}

TEST(NearestPathAnswer, TellsTheDistancesThatTurningTheCrankShows) {
  const PathTask task = bean();
  const PathAnswer answer = solved(task);
  ASSERT_FALSE(answer.linkages.empty());
  EXPECT_TRUE(has_warning(answer, "path_fitted"));
  for (const FourBarSolution& found : answer.linkages) {
    ASSERT_TRUE(found.fit && found.path);
    EXPECT_TRUE(found.verified_by_driving && found.report.defects.none());
    EXPECT_TRUE(found.path->full_turn);
    EXPECT_EQ(found.report.sweep, two_pi) << "a closed path is run all along";
    EXPECT_EQ(found.report.min_transmission_angle, found.report.min_transmission_angle_full_turn);
    const std::vector<Point> path = path_by_turning(found.four_bar, found.path->point, 0, two_pi, 20'000);
    double squares = 0, largest = 0;
    ASSERT_EQ(found.fit->at.size(), task.points.size());
    for (std::size_t j = 0; j < task.points.size(); ++j) {
      const double distance = nearest(path, task.points[j].point);
      EXPECT_NEAR(found.fit->at[j].distance, distance, 1e-4 * largest + 1e-4);
      squares += distance * distance;
      largest = std::max(largest, distance);
    }
    EXPECT_NEAR(found.fit->error.rms, std::sqrt(squares / 16), 1e-4);
    EXPECT_NEAR(found.fit->error.max, largest, 1e-4);
    EXPECT_LT(found.fit->error.rms_over_diagonal, 0.05);
  }
  EXPECT_TRUE(std::is_sorted(answer.linkages.begin(), answer.linkages.end(),
                             [](const auto& a, const auto& b) { return a.fit->error.rms < b.fit->error.rms - 1e-9; }));
}

TEST(NearestPathAnswer, StandsAtEachPointWhereItIsSaidTo) {
  const PathTask task = bean();
  const PathAnswer answer = solved(task);
  ASSERT_FALSE(answer.linkages.empty());
  const FourBarSolution& best = answer.linkages.front();
  for (const FittedPath::Nearest& at : best.fit->at) {
    const Point there = path_by_turning(best.four_bar, best.path->point, 0, at.input, 4000).back();
    EXPECT_NEAR(std::abs(there - task.points[at.point].point), at.distance, 1e-9 * best.lengths.longest());
  }
}

TEST(NearestPathAnswer, HasRealisationsThatTraceTheSamePath) {
  const PathAnswer answer = solved(bean());
  ASSERT_FALSE(answer.linkages.empty());
  const FourBarSolution& best = answer.linkages.front();
  ASSERT_EQ(best.fit->realisations.size(), 3u);
  const Point point = best.path->point;
  const std::vector<Point> path = path_by_turning(best.four_bar, point, 0, two_pi, 20'000);
  for (const FourBar& other : best.fit->realisations)
    for (const double turn : {-0.05, 0.05}) {
      const std::vector<Point> some = path_by_turning(other, point, 0, turn, 50);
      EXPECT_LT(nearest(path, some.back()), 1e-4);
      EXPECT_GT(std::abs(some.back() - point), 1e-3);
    }
}

TEST(NearestPathAnswer, KeepsWhatIsRequired) {
  Requirements wanted;
  wanted.min_transmission_angle = radians(35);
  wanted.max_link_ratio = 6;
  wanted.max_length = 350;
  const PathAnswer answer = solved(bean(), wanted);
  ASSERT_FALSE(answer.linkages.empty());
  for (const FourBarSolution& found : answer.linkages) {
    EXPECT_GE(found.report.min_transmission_angle, radians(35));
    EXPECT_LE(found.lengths.longest() / found.lengths.shortest(), 6);
    EXPECT_LE(found.lengths.longest(), 350);
  }
  EXPECT_GE(answer.linkages.front().fit->error.rms, solved(bean()).linkages.front().fit->error.rms - 1e-6)
      << "less is asked there";
}

TEST(NearestPathAnswer, SaysByHowMuchAToleranceIsMissed) {
  PathTask task = bean();
  task.tolerance = 1e-3;
  const PathAnswer answer = solved(task);
  ASSERT_FALSE(answer.linkages.empty());
  EXPECT_FALSE(answer.linkages.front().fit->outside.empty());
  const auto missed = std::find_if(answer.warnings.begin(), answer.warnings.end(),
                                   [](const Notice& notice) { return notice.code == "path_tolerance_missed"; });
  ASSERT_NE(missed, answer.warnings.end());
  EXPECT_GT(std::get<double>(missed->values.front().value), 1);
  task.tolerance = 50;
  const PathAnswer wide = solved(task);
  EXPECT_TRUE(wide.linkages.front().fit->outside.empty());
  EXPECT_FALSE(has_warning(wide, "path_tolerance_missed"));
}

TEST(NearestPathAnswer, BringsBackAPathThatAFourBarTraces) {
  const FourBar bars{{0, 0}, {30, 0}, {100, 10}, {80, 85}};
  const Point point{70, 40};
  std::vector<Point> places = path_by_turning(bars, point, 0, two_pi, 24);
  places.pop_back();
  const PathAnswer answer = solved(through(places, true));
  ASSERT_FALSE(answer.linkages.empty());
  EXPECT_LT(answer.linkages.front().fit->error.rms_over_diagonal, 1e-9);
}

TEST(NearestPathAnswer, SaysThatFewPointsAreReachedExactly) {
  const PathAnswer answer = solved(through({{0, 0}, {40, 25}, {85, 30}, {120, 10}, {140, -30}, {130, -70}}, false));
  EXPECT_TRUE(has_warning(answer, "exactly_solvable"));
  ASSERT_FALSE(answer.linkages.empty());
  EXPECT_LT(answer.linkages.front().fit->error.rms_over_diagonal, 1e-6);
}

}  // namespace
}  // namespace linkwright::nearest_path_answer_test
