// However small the windows are in which a linkage is known to have its hinges, it is found; and where the stretches of
// the curves say that there is none, no sample says otherwise.

#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <random>

#include "linkwright/core/angle.hpp"
#include "linkwright/files/problem_file.hpp"
#include "linkwright/synthesis/solve.hpp"
#include "support/draws.hpp"
#include "support/random_task.hpp"
#include "support/solved.hpp"

namespace linkwright::window_law_test {
namespace {

Box box_round(Point p, Point q, double margin) {
  return {std::min(p.real(), q.real()) - margin, std::max(p.real(), q.real()) + margin,
          std::min(p.imag(), q.imag()) - margin, std::max(p.imag(), q.imag()) + margin};
}

SynthesisOptions usual() {
  SynthesisOptions options;
  options.region_samples = 100;
  options.best = 3;
  return options;
}

// Windows round the pivots of a linkage of the map that meets the requirements.
void expect_found_in_windows(const MotionTask& task, std::mt19937_64& random, int& tried) {
  const MotionAnswer whole = testing::solved(task, {}, usual());
  if (!whole.family()) return;
  const RequirementFilter filter = filter_of(*whole.family(), whole.region, whole.requirements);
  std::vector<MapPoint> passing;
  for (std::size_t row = 0; row < whole.region.rows(); ++row)
    for (std::size_t column = 0; column < whole.region.columns(); ++column)
      if (filter.passes(row, column))
        passing.push_back({whole.region.input_coordinates()[row], whole.region.output_coordinates()[column]});
  if (passing.empty()) return;
  const auto links = whole.family()->dyad_pair(passing[random() % passing.size()]);
  const auto bars = four_bar_of(*links);
  const auto user = [&](Point p) { return whole.given.frame().to_user(p); };
  const double size = whole.characteristic_length;
  for (const double share : {0.05, 0.002, 1e-5}) {
    Requirements wanted;
    wanted.ground_pivots_within = box_round(user(bars->input_fixed), user(bars->output_fixed), share * size);
    if (random() % 2 == 0)
      wanted.moving_pivots_within = box_round(user(bars->input_moving), user(bars->output_moving), share * size);
    const MotionAnswer found = testing::solved(task, wanted, usual());
    ++tried;
    if (found.left_out > 0) continue;
    EXPECT_FALSE(found.linkages.empty()) << share << ": " << found.reason.message;
    for (const FourBarSolution& linkage : found.linkages) {
      EXPECT_TRUE(wanted.ground_pivots_within->contains(linkage.four_bar.input_fixed));
      EXPECT_TRUE(wanted.ground_pivots_within->contains(linkage.four_bar.output_fixed));
    }
  }
}

TEST(WindowLaw, LinkagesOfFourPositionsAreFoundInTheirWindows) {
  std::mt19937_64 random(2011);
  int tried = 0;
  for (int trial = 0; trial < testing::draws(120); ++trial)
    expect_found_in_windows({testing::random_poses(random), {}}, random, tried);
  if (testing::draws_are_many) {
    EXPECT_GT(tried, testing::draws(40));
  }
}

TEST(WindowLaw, LinkagesOfThreePositionsAreFoundInTheirWindows) {
  std::mt19937_64 random(2012);
  int tried = 0;
  for (int trial = 0; trial < testing::draws(20); ++trial) {
    const auto poses = testing::random_poses(random, 3);
    const double length = testing::uniform(random, 0.5, 4);
    expect_found_in_windows({poses, SideLengths{length, testing::uniform(random, 0.5, 4)}}, random, tried);
    expect_found_in_windows({poses, SideAngle{testing::uniform(random, -2, 2), true, length}}, random, tried);
  }
  EXPECT_GT(tried, testing::draws(40));
}

TEST(WindowLaw, AnEmptyWindowHoldsNoSampleOfTheCurve) {
  std::mt19937_64 random(2013);
  int empty = 0, entered = 0;
  for (int trial = 0; trial < testing::draws(150); ++trial) {
    const auto task = MotionTask{testing::random_poses(random), {}};
    const TaskFamily given = task_family(task, {}, {});
    if (!given.family) continue;
    const Point corner{testing::uniform(random, -4, 4), testing::uniform(random, -4, 4)};
    const Box box{corner.real(), corner.real() + testing::uniform(random, 0, 1), corner.imag(),
                  corner.imag() + testing::uniform(random, 0, 0.3)};
    const auto arcs = given.family->arcs_within(Side::input, {box, std::nullopt});
    ASSERT_TRUE(arcs);
    bool holds = false;
    for (const double tau : given.family->samples(Side::input, 3000, Spacing::arc_length)) {
      const auto links = given.family->dyad_pair({tau, tau});
      const auto center = links ? finite_point(links->input.center) : std::nullopt;
      if (!center || !box.contains(given.frame().to_user(*center))) continue;
      holds = true;
      EXPECT_TRUE(std::any_of(arcs->arcs.begin(), arcs->arcs.end(), [&](const AxisArc& arc) {
        return tau >= arc.from - 1e-9 && tau <= arc.to + 1e-9;
      })) << trial;
    }
    for (const AxisArc& arc : arcs->arcs) {
      const auto links = given.family->dyad_pair({(arc.from + arc.to) / 2, (arc.from + arc.to) / 2});
      ASSERT_TRUE(links);
      EXPECT_TRUE(box.contains(given.frame().to_user(*finite_point(links->input.center))));
    }
    EXPECT_TRUE(arcs->are_all);
    (arcs->arcs.empty() ? empty : entered) += 1;
    if (arcs->arcs.empty()) {
      EXPECT_FALSE(holds);
    }
  }
  EXPECT_GT(empty, testing::draws(10));
  if (testing::draws_are_many) {
    EXPECT_GT(entered, testing::draws(5));
  }
}

MotionAnswer solved_text(std::string_view text) {
  const auto problem = read_problem(text);
  EXPECT_TRUE(problem);
  return testing::solved(std::get<MotionTask>(problem->task), problem->requirements, problem->options);
}

// All pivots on the line through a pole but that one: the moving pivots that go with it fill a line of their own, which
// no place on the map has.
TEST(WindowLaw, WhatSamplesDoNotShowIsNotProved) {
  const MotionAnswer answer = solved_text(R"({"linkwright": 1, "task": {"kind": "motion", "mechanism": "four_bar",
    "poses": [{"x": 100, "y": 80, "theta_deg": 11.459155902616466},
              {"x": 2.995205519135702, "y": 128.02745308682097, "theta_deg": 61.459155902616466},
              {"x": -60, "y": 150, "theta_deg": 108.8619810748564}],
    "given": {"ground_pivot_on": {"point": [-50, 0], "direction_deg": 0}}},
    "requirements": {"no_defects": false, "max_link_ratio": 1e6, "max_length": 1e5, "min_length": 0,
      "moving_pivots_within": {"x": [-63.317, -62.317], "y": [-29.62174, -28.62174]}}})");
  EXPECT_FALSE(answer.inside && answer.inside->is_empty);
  EXPECT_EQ(answer.reason.code, "none_left");
  EXPECT_EQ(answer.reason.message.find("free of defects"), std::string::npos) << "defects are allowed";
}

// A curve that enters a window by a millionth of the task between samples.
TEST(WindowLaw, AWindowThatACurveTouchesIsMet) {
  const MotionAnswer answer = solved_text(R"({"linkwright": 1, "task": {"kind": "motion", "mechanism": "four_bar",
    "poses": [{"x": -20.1453694136351, "y": -35.2858128369896, "theta_deg": -104.432119590753},
              {"x": -63.9045854426554, "y": -8.78911015258235, "theta_deg": 81.9048644897945},
              {"x": 81.7211889152524, "y": -41.324380224159, "theta_deg": -8.2819303574048}],
    "given": {"side_lengths": [92.039832642836, 92.039832642836]}},
    "requirements": {"no_defects": false, "max_link_ratio": 1e12, "max_length": 1e9, "min_length": 0,
      "ground_pivots_within": {"x": [32, 42], "y": [24.293486185786858, 29]}}})");
  EXPECT_FALSE(answer.linkages.empty()) << answer.reason.message;
}

// The curve enters just where its axis ends: two positions are parallel.
TEST(WindowLaw, AWindowAtTheEndOfAnAxisIsMet) {
  const MotionAnswer answer = solved_text(R"({"linkwright": 1, "task": {"kind": "motion", "mechanism": "four_bar",
    "poses": [{"x": 31.5966792563, "y": 91.353820865, "theta_deg": 0},
              {"x": 4.59661866722, "y": -83.5967851739, "theta_deg": 0},
              {"x": -92.5941060128, "y": 73.475081901, "theta_deg": -38.8271953738}],
    "given": {"side_lengths": [183.964049611, 183.964049611]}},
    "requirements": {"no_defects": false, "max_link_ratio": 1e12, "max_length": 1e9, "min_length": 0,
      "ground_pivots_within": {"x": [452.815585, 452.815636], "y": [409.542417, 409.542468]}}})");
  EXPECT_FALSE(answer.linkages.empty()) << answer.reason.message;
}

// Of one task: what is required lies elsewhere on the map, or beyond the ends of τ on a curve that closes.
TEST(WindowLaw, APartOfTheMapProvesNothingOfTheWhole) {
  const MotionTask task{{{{{8.4, 10.4}, 0}, {}},
                         {{{15.75307999925125, 6.635448633158675}, radians(1.6616734751610893)}, {}},
                         {{{22.17995730186216, 14.34686035802784}, radians(43.4681702286939)}, {}},
                         {{{12.61818756779844, 15.25966971714668}, radians(-270.3228804174674)}, {}}},
                        {}};
  Requirements wanted;
  wanted.ground_pivots_within = Box{8.5, 24, 4.485, 4.515};
  SynthesisOptions options = usual();
  options.window = MapWindow{{0, 0.02}, {0, 0.02}};
  const MotionAnswer part = testing::solved(task, wanted, options);
  EXPECT_TRUE(part.linkages.empty());
  EXPECT_FALSE(part.inside && part.inside->is_empty);
  options.window.reset();
  const MotionAnswer whole = testing::solved(task, wanted, options);
  ASSERT_FALSE(whole.linkages.empty());
  const MapPoint best = whole.point_of(whole.linkages.front());
  const double length = whole.family()->axis(Side::input).coordinate_length();
  for (const double turns : {-2.0, -1.0, 1.0, 3.0}) {
    const double by = turns * length;
    options.window =
        MapWindow{{best.input + by - 0.02, best.input + by + 0.02}, {best.output + by - 0.02, best.output + by + 0.02}};
    const MotionAnswer beyond = testing::solved(task, wanted, options);
    ASSERT_FALSE(beyond.linkages.empty()) << beyond.reason.message;
    EXPECT_NEAR(beyond.linkages.front().report.min_transmission_angle,
                whole.linkages.front().report.min_transmission_angle, 1e-4);
  }
}

// The same window on every axis that closes, of every kind that has one.
TEST(WindowLaw, AWindowBeyondTheEndOfAClosedAxisIsThatAWholeTurnAway) {
  const auto poses =
      R"([{"x": 2429.04, "y": -1214.52, "theta_deg": -45}, {"x": 3643.56, "y": 4858.08, "theta_deg": -45},
                         {"x": -2429.04, "y": 4858.08, "theta_deg": 90}])";
  const auto problem = read_problem(fmt::format(
      R"({{"linkwright": 1, "task": {{"kind": "motion", "mechanism": "four_bar", "poses": {},
          "given": {{"side_angle_deg": 150, "directed": false, "input_length": 3262.6}}}}}})",
      poses));
  ASSERT_TRUE(problem);
  const auto& task = std::get<MotionTask>(problem->task);
  SynthesisOptions options = usual();
  options.window = MapWindow{{0.6, 0.8}, {1.1, 1.3}};
  const MotionAnswer here = testing::solved(task, {}, options);
  ASSERT_FALSE(here.linkages.empty());
  for (const double turns : {-2.0, 2.0, 4.0}) {
    options.window = MapWindow{{0.6 + turns, 0.8 + turns}, {1.1 - turns, 1.3 - turns}};
    const MotionAnswer beyond = testing::solved(task, {}, options);
    EXPECT_EQ(beyond.status, SolutionStatus::solved);
    EXPECT_EQ(beyond.meeting_requirements, here.meeting_requirements);
    ASSERT_FALSE(beyond.linkages.empty()) << beyond.reason.message;
    EXPECT_NEAR(beyond.linkages.front().report.min_transmission_angle,
                here.linkages.front().report.min_transmission_angle, 1e-4);
  }
}

template <class KindAnswer>
void expect_the_same_whole_turns_away(std::string_view text) {
  auto problem = read_problem(text);
  ASSERT_TRUE(problem);
  problem->options = usual();
  problem->options.window = MapWindow{{0.1, 0.6}, {0.1, 0.6}};
  const auto here = std::get<KindAnswer>(solve(*problem).value());
  ASSERT_FALSE(here.linkages.empty());
  const double turn = here.family()->axis(Side::input).coordinate_length();
  for (const double by : {-2 * turn, -turn, turn}) {
    problem->options.window = MapWindow{{0.1 + by, 0.6 + by}, {0.1, 0.6}};
    const auto beyond = std::get<KindAnswer>(solve(*problem).value());
    EXPECT_NEAR(static_cast<double>(beyond.meeting_requirements), static_cast<double>(here.meeting_requirements), 1);
    ASSERT_FALSE(beyond.linkages.empty()) << beyond.reason.message;
    EXPECT_NEAR(beyond.linkages.front().report.min_transmission_angle,
                here.linkages.front().report.min_transmission_angle, 1e-3);
  }
}

TEST(WindowLaw, SoItIsOfFunctions) {
  const std::string_view pairs = R"("pairs": [{"input_deg": 0, "output_deg": 0}, {"input_deg": 20, "output_deg": 30},
      {"input_deg": 45, "output_deg": 55}, {"input_deg": 70, "output_deg": 75}])";
  expect_the_same_whole_turns_away<FunctionAnswer>(
      fmt::format(R"({{"linkwright": 1, "task": {{"kind": "function", "mechanism": "four_bar", {}}},
        "requirements": {{"no_defects": false}}}})",
                  pairs));
  expect_the_same_whole_turns_away<SphericalFunctionAnswer>(
      fmt::format(R"({{"linkwright": 1, "task": {{"kind": "function", "mechanism": "spherical_four_bar",
        "ground_angle_deg": 70, {}}}, "requirements": {{"no_defects": false}}}})",
                  pairs));
}

// Lengths tried in equal ratios pass it by on both sides.
TEST(WindowLaw, AnOpenLengthIsFoundBetweenThoseTried) {
  const MotionAnswer answer = solved_text(R"({"linkwright": 1, "task": {"kind": "motion", "mechanism": "four_bar",
    "poses": [{"x": -1.9303060737770954, "y": 1.3784446613414894, "theta_deg": 35.417675248},
              {"x": -1.0865903964788604, "y": -0.24559328009620043, "theta_deg": -130.79051363},
              {"x": -0.21823178117297573, "y": 1.8964289352242865, "theta_deg": -130.79051363}],
    "given": {"side_angle_deg": 140.90445656848254, "directed": false}},
    "requirements": {"types": ["double_crank"], "no_defects": false, "max_link_ratio": 20,
      "max_length": 9.113622726558205, "min_length": 0.0005,
      "ground_pivots_within": {"x": [-1.1803774635774194, -0.6384394682214738], "y": [0.501182789047, 1.532868]},
      "moving_pivots_within": {"x": [-1.476417416072349, -1.25253539481], "y": [0.066102868807, 1.6728993612694]}},
    "options": {"region_samples": 65, "objective": "size"}})");
  EXPECT_FALSE(answer.linkages.empty()) << answer.reason.message;
}

TEST(WindowLaw, AProvedNoneSaysSo) {
  Requirements wanted;
  wanted.ground_pivots_within = Box{1e4, 1e4 + 1, 1e4, 1e4 + 1};
  std::mt19937_64 random(2014);
  const MotionAnswer answer = testing::solved(MotionTask{testing::random_poses(random), {}}, wanted, usual());
  ASSERT_TRUE(answer.inside);
  EXPECT_TRUE(answer.inside->is_empty);
  EXPECT_EQ(answer.reason.code, "windows_empty");
  EXPECT_EQ(answer.missed_boxes.size(), 1u);
}

// Public report: "none", where the curve passes through a window 0.03 high.
TEST(WindowLaw, AThinWindowIsMet) {
  const std::vector<PrescribedPose> poses = {
      {{{8.4, 10.4}, 0}, {}},
      {{{15.75307999925125, 6.635448633158675}, radians(1.6616734751610893)}, {}},
      {{{22.17995730186216, 14.34686035802784}, radians(43.4681702286939)}, {}},
      {{{12.61818756779844, 15.25966971714668}, radians(-270.3228804174674)}, {}}};
  Requirements wanted;
  SynthesisOptions options;
  for (const double half : {0.015, 1e-4, 0.0}) {
    wanted.ground_pivots_within = Box{8.5, 24, 4.5 - half, 4.5 + half};
    const MotionAnswer answer = testing::solved(MotionTask{poses, {}}, wanted, options);
    ASSERT_FALSE(answer.linkages.empty()) << half;
    EXPECT_NEAR(degrees(answer.linkages[0].report.min_transmission_angle), 15.07, 0.2) << half;
    EXPECT_TRUE(answer.linkages[0].verified_by_driving);
  }
}

}  // namespace
}  // namespace linkwright::window_law_test
