#include "straight_line/line_travel.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/synthesis/answer.hpp"
#include "mechanism/transmission_angle.hpp"
#include "support/file_support.hpp"

namespace linkwright::line_travel_test {
namespace {

struct Found {
  StraightLineAnswer answer;
  [[nodiscard]] const StraightLineFamily& family() const { return *answer.lines; }
  [[nodiscard]] const StraightLineSolution& best() const { return answer.linkages.front(); }
};
Found best_of_stage() {
  return {std::get<StraightLineAnswer>(testing::answer_of(testing::example("straight_stage.json", 60)))};
}

TEST(LineTravel, PassesTheEndsOfTheUsableLengthAndWhereTheLinkageLies) {
  const Found found = best_of_stage();
  const Travel travel = travel_of(found.family(), found.best());
  ASSERT_EQ(travel.state_of_position.size(), 3u);
  ASSERT_TRUE(travel.reaches_all_positions());
  const TravelState& lies = travel.states[static_cast<std::size_t>(travel.state_of_position[1])];
  EXPECT_LT(std::abs(lies.body.origin - found.best().linkage.point), 1e-9);
  const UsableLine& usable = found.best().counted(found.family().measuring().measure);
  const Point from = travel.states[static_cast<std::size_t>(travel.state_of_position[0])].body.origin,
              to = travel.states[static_cast<std::size_t>(travel.state_of_position[2])].body.origin;
  EXPECT_NEAR(std::abs(to - from), usable.length(), 1e-3 * usable.length());
}

TEST(LineTravel, ItsProfileKeepsToTheDeviationOverTheUsableLength) {
  const Found found = best_of_stage();
  const auto profile = profile_of(found.family(), found.best());
  ASSERT_EQ(profile.size(), 201u);
  int inside = 0;
  for (const ProfilePlace& there : profile) {
    if (there.s < found.best().usable.from || there.s > found.best().usable.to) continue;
    EXPECT_LE(std::abs(there.e), found.best().deviation * (1 + 1e-9));
    ++inside;
  }
  EXPECT_GT(inside, 50);
}

TEST(LineTravel, ReportsWhatEitherDriverDoes) {
  const Problem problem = testing::problem_from(
      R"({"linkwright": 1, "task": {"kind": "straight_line", "mechanism": "four_bar", "case": "four_point_pivots",
      "line": {"point": [0, 120], "direction_deg": 0}, "ground_pivots": {"input": [0, 0], "output": [90, 20]}}})");
  const StraightLineFamily family(std::get<StraightLineTask>(problem.task), problem.options.line);
  int cranks = 0, drive = 0, lock = 0;
  for (const double input : family.samples(Side::input, 24, Spacing::coordinate))
    for (const double output : family.samples(Side::output, 24, Spacing::coordinate)) {
      const auto found = make_straight_line(family, {input, output});
      if (!found) continue;
      const DefectReport report = report_of(family, found->linkage, found->judged()),
                         swapped = report_of(family, found->linkage.swapped(), found->judged());
      if (input_is_crank(report.type)) {
        EXPECT_EQ(report.min_transmission_angle_full_turn, least_transmission_angle_full_turn(found->lengths));
        ++cranks;
      }
      (swapped.defects.none() ? drive : lock) += 1;
      if (swapped.defects.none()) {
        EXPECT_GT(swapped.min_transmission_angle, 0);
      }
    }
  EXPECT_GT(cranks, 10);
  EXPECT_GT(drive, 10);
  EXPECT_GT(lock, 10);
}

}  // namespace
}  // namespace linkwright::line_travel_test
