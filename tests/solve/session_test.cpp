#include "linkwright/solve/session.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <optional>
#include <string>

#include "linkwright/synthesis/solve.hpp"
#include "support/file_support.hpp"

namespace linkwright::session_test {
namespace {

using testing::example;

constexpr int samples = 40;

MapRequest coarse() {
  MapRequest request;
  request.samples = samples;
  return request;
}

const char* const examples[] = {"tailgate",         "latch",
                                "nose_gear",        "sine_generator",
                                "flow_meter",       "folding_wing",
                                "straight_stage",   "universal_joint_like",
                                "bin_lid",          "film_claw",
                                "dough_mixer",      "windscreen_wiper",
                                "thread_take_up",   "walking_leg_path",
                                "packaging_feeder", "garage_door_point"};

TEST(Session, CountsWhatSolveCounts) {
  int compared = 0;
  for (const char* name : examples) {
    const Problem problem = example(std::string(name) + ".json", samples);
    const Answer solved = testing::answer_of(problem);
    if (findings(solved).region.rows() != samples) continue;  // layers share the samples of a session's map
    Session session(problem);
    const ColouredMap* map = session.explore(coarse());
    ASSERT_NE(map, nullptr) << name;
    EXPECT_EQ(map->census.meeting, findings(solved).meeting_requirements) << name;
    EXPECT_EQ(map->counts.types, findings(solved).counts.types) << name;
    ++compared;
  }
  EXPECT_GT(compared, 4);
}

TEST(Session, ALinkageIsWhatItsCellSays) {
  for (const char* name : examples) {
    Session session(example(std::string(name) + ".json", samples));
    const ColouredMap* map = session.explore(coarse());
    ASSERT_NE(map, nullptr) << name;
    const RegionMap& region = map->region;
    for (std::size_t cell = 0; cell < map->fails.size(); cell += 1 + map->fails.size() / 50) {
      const std::size_t columns = region.columns();
      const PickedLinkage picked =
          session.linkage({region.input_coordinates()[cell / columns], region.output_coordinates()[cell % columns]});
      if (map->fails[cell] == 0) {
        EXPECT_EQ(picked.fails, 0) << name << " " << cell;
      }
      EXPECT_EQ(picked.answer.has_value(), !picked.travel.states.empty()) << name << " " << cell;
      EXPECT_TRUE(picked.answer || picked.reason) << name << " " << cell;
      EXPECT_EQ(picked.positions.size(), picked.travel.state_of_position.size());
    }
  }
}

TEST(Session, KeepsWhatStillHoldsAndFollowsWhatChanges) {
  Problem problem = example("tailgate.json", samples);
  Session session(problem);
  const std::int64_t before = session.explore(coarse())->census.meeting;
  problem.requirements.max_link_ratio = Requirements::unlimited;
  session.set(problem);
  const ColouredMap* map = session.explore(coarse());
  EXPECT_GT(map->census.meeting, before);
  EXPECT_EQ(map->census.meeting, findings(testing::answer_of(problem)).meeting_requirements);
  auto& pose = std::get<MotionTask>(problem.task).poses[2].pose;
  pose.origin += Point{5, 0};
  session.set(problem);
  EXPECT_EQ(session.explore(coarse())->counts.types, findings(testing::answer_of(problem)).counts.types);
}

// Maps estimate the forces of loads; what is listed at a limit meets it in hand, too.
TEST(Session, SaysOfListedLinkagesThatTheyMeetWhatLoadsAreRequired) {
  Session session(example("tailgate_struts.json", samples));
  const auto best = session.best(4);
  ASSERT_TRUE(best.ok());
  const auto& found = std::get<MotionAnswer>(*best);
  ASSERT_FALSE(found.linkages.empty());
  for (const auto& linkage : found.linkages) EXPECT_EQ(session.linkage(found.point_of(linkage)).fails, 0);
}

TEST(Session, ImprovesVerifiesAndTracesTheBest) {
  Session session(example("tailgate.json", samples));
  const auto best = session.best(3);
  ASSERT_TRUE(best.ok());
  const auto& found = std::get<MotionAnswer>(*best);
  ASSERT_EQ(found.linkages.size(), 3u);
  const MapPoint place = found.point_of(found.linkages.back());
  EXPECT_TRUE(session.verify(place).verified);
  const auto answer = session.answer_at(place);
  ASSERT_TRUE(answer);
  EXPECT_EQ(linkage_count(*answer), 1u);
  EXPECT_EQ(session.trace(place, {}).size(), session.linkage(place).travel.states.size());
  const MapPoint aside = {place.input + 0.01, place.output};
  const auto better = session.improved(aside);
  EXPECT_TRUE(better || session.linkage(aside).fails != 0);
}

TEST(Session, ListsWhatIsPickedWhateverItMissesUnderTolerances) {
  Problem problem = example("tailgate.json", samples);
  const Answer usual = testing::answer_of(problem);
  const auto& known = std::get<MotionAnswer>(usual);
  const MapPoint place = known.point_of(known.linkages.front());
  Tolerances& tolerances = problem.options.tolerances.emplace();
  tolerances.length = LengthTolerances::all(1);
  tolerances.samples = 1000;
  problem.requirements.max_tolerance_error = 1e-6;
  Session session(problem);
  EXPECT_NE(session.linkage(place).fails, 0);
  const auto answer = session.answer_at(place), result = session.result_at(place);
  ASSERT_TRUE(answer && result);
  EXPECT_EQ(linkage_count(*answer), 1u);
  EXPECT_TRUE(findings(*answer).tolerance.empty());
  EXPECT_EQ(linkage_count(*result), 1u);
  ASSERT_EQ(findings(*result).tolerance.size(), 1u);
  EXPECT_TRUE(findings(*result).tolerance[0]);
  EXPECT_FALSE(findings(*result).options.at);
}

TEST(Session, SaysWhyThereIsNoMap) {
  Session session(example("loader_bucket.json", samples));
  EXPECT_EQ(session.explore(coarse()), nullptr);
  ASSERT_TRUE(session.why_nothing());
  EXPECT_EQ(session.why_nothing()->code, "chain_wanted");
}

/// A window round a place of the map where a slider stands in place of a link; nothing without one.
std::optional<MapWindow> window_of_sliders(const Problem& problem) {
  const auto answer = solve(problem);
  const RegionMap& map = findings(*answer).region;
  const auto valid = map.values(measures::valid);
  const auto cell = std::find(valid.begin(), valid.end(), 2.0F);
  if (cell == valid.end()) return std::nullopt;
  const auto index = static_cast<std::size_t>(cell - valid.begin());
  const LinkageFamily& family = *std::get<StraightLineAnswer>(*answer).family();
  const double input = family.axis_value(Side::input, map.input_coordinates()[index / map.columns()]),
               output = family.axis_value(Side::output, map.output_coordinates()[index % map.columns()]);
  constexpr double narrow = 1e-9;
  return MapWindow{{input - narrow, input + narrow}, {output - narrow, output + narrow}};
}

TEST(Session, SaysAsSolveDoesThatOnlySlidersAreThere) {
  int found = 0;
  for (const char* const name : {"straight_indicator", "straight_luffing_crane", "straight_stage",
                                 "straight_walking_leg", "straight_watt_suspension", "straight_scraper_as_made"}) {
    Problem problem = example(std::string(name) + ".json", 60);
    problem.options.window = window_of_sliders(problem);
    if (!problem.options.window) continue;
    problem.options.region_samples = SynthesisOptions::min_samples;
    const auto answer = solve(problem);
    if (!answer || findings(*answer).reason.code != "only_sliders") continue;
    ++found;
    Session session(problem);
    (void)session.explore(coarse());
    ASSERT_TRUE(session.why_nothing()) << name;
    EXPECT_EQ(session.why_nothing()->code, "only_sliders") << name;
  }
  EXPECT_GT(found, 0);
}

// With a free parameter no link depends on its own coordinate alone.
TEST(Session, HasNoLiveLinksWhereNoneAreDrawn) {
  Session session(example("flow_meter_as_made.json", samples));
  ASSERT_NE(session.explore(coarse()), nullptr);
  EXPECT_TRUE(session.links(Side::input).coordinate.empty());
  EXPECT_TRUE(session.live({0.5, 0.5}).input.empty());
}

}  // namespace
}  // namespace linkwright::session_test
