#include "linkwright/mechanism/six_bar_position.hpp"

#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "linkwright/core/angle.hpp"
#include "support/random_six_bar.hpp"
#include "support/random_task.hpp"

namespace linkwright::six_bar_position_test {
namespace {

using nlohmann::json;

/// Crank, ternary coupler, rocker and a second dyad: angles of the bodies in the published drive's order of bodies
/// (crank, link 5, output, rocker, ternary), three numbers each.
struct PublishedStep {
  double crank, link, output, rocker, ternary;
  explicit PublishedStep(const json& step)
      : crank(step["q"][2]), link(step["q"][5]), output(step["q"][8]), rocker(step["q"][11]), ternary(step["q"][14]) {}
};

/// Stephenson III: a rocker on the ternary coupler, and a dyad of link 3 (guided) and link 5 to the ground.
SixBar published_six_bar(const PublishedStep& at) {
  const Point a{0, 0}, rocker_pivot{6, 0}, output_pivot{3, 1};
  const Point b = a + 1.5 * direction(at.crank);
  const Point d = b + direction(at.ternary) * Point{1.5, 1}, z4 = b + direction(at.ternary) * Point{3, 0};
  const Point z5 = d + 2.0 * direction(at.link);
  return SixBar::of({a, b, d}, {BodyPair{0, 2}, BodyPair{0, 3}}, {rocker_pivot, z4}, {output_pivot, z5});
}

SixBarTurns turns_between(const PublishedStep& from, const PublishedStep& to) {
  return {Point{1},
          direction(to.crank - from.crank),
          direction(to.ternary - from.ternary),
          direction(to.link - from.link),
          direction(to.rocker - from.rocker),
          direction(to.output - from.output)};
}

TEST(SixBarPosition, FollowsAPublishedDrive) {
  const json content = json::parse(std::ifstream(LINKWRIGHT_DATA_DIR "/six_bar/published_drive.json"));
  const json& steps = content["published"]["steps"];
  const PublishedStep first(steps[0]);
  const SixBar six_bar = published_six_bar(first);
  EXPECT_EQ(six_bar.topology(), SixBarTopology::stephenson_3);
  SixBarTurns at{1, 1, 1, 1, 1, 1};
  ASSERT_EQ(steps.size(), 8u);
  for (const json& step : steps) {
    const PublishedStep stated(step);
    const SixBarTurns wanted = turns_between(first, stated);
    EXPECT_LT(closure_error(six_bar, wanted), 1e-9);
    SixBarTurns guess = wanted;
    for (std::size_t body = 2; body < guess.size(); ++body) guess[body] *= direction(0.05);
    const auto found = closed(six_bar, guess);
    ASSERT_TRUE(found);
    for (std::size_t body = 1; body < at.size(); ++body) EXPECT_LT(std::abs((*found)[body] - wanted[body]), 1e-9);
  }
}

TEST(SixBarPosition, KeepsEveryLengthWhereTheLoopsClose) {
  std::mt19937_64 random(21);
  for (const SixBarRow& row : six_bar_rows()) {
    const auto [task, member] = testing::random_six_bar(random, row);
    SixBarTurns guess = member.turns[0];
    guess[1] = direction(1e-6);  // some are near a dead point
    const auto turns = closed(member.six_bar, guess);
    ASSERT_TRUE(turns) << text(row.added[0]) << text(row.added[1]);
    EXPECT_EQ((*turns)[1], guess[1]) << "the driver stays where it is put";
    EXPECT_LT(closure_error(member.six_bar, *turns), 1e-12);
    const auto joints = joints_at(member.six_bar, *turns);
    for (const SixBarLength& length : member.six_bar.lengths())
      EXPECT_NEAR(std::abs(joints[length.joints[1]] - joints[length.joints[0]]) / length.length, 1, 1e-11);
  }
}

TEST(SixBarPosition, KnowsWhichSixBarsAreTwoDyadsToTheDriver) {
  std::mt19937_64 random(22);
  for (const SixBarRow& row : six_bar_rows()) {
    const auto [task, member] = testing::random_six_bar(random, row);
    const bool second_dyad_on_three = row.added[0] == BodyPair{0, 3} || row.added[0] == BodyPair{1, 3};
    const bool hangs_together = second_dyad_on_three && row.added[1] != BodyPair{0, 2} &&
                                row.added[1] != BodyPair{0, 4} && row.added[1] != BodyPair{1, 4};
    EXPECT_EQ(six_bar_transmission(member.six_bar, member.turns[0]).dyadic, !hangs_together)
        << text(row.added[0]) << text(row.added[1]);
  }
}

TEST(SixBarPosition, MeasuresTheTransmissionAngleOfDyads) {
  std::mt19937_64 random(23);
  const SixBarRow row = six_bar_rows()[0];  // 0-2, 0-3
  for (int i = 0; i < 20; ++i) {
    const auto [task, member] = testing::random_six_bar(random, row);
    for (const SixBarTurns& turns : member.turns) {
      const auto p = joints_at(member.six_bar, turns);
      const auto sine_at = [&](std::size_t joint, std::size_t one, std::size_t other) {
        return std::abs(std::sin(std::arg((p[one] - p[joint]) / (p[other] - p[joint]))));
      };
      const double first = sine_at(SixBar::z4, SixBar::b, SixBar::c4),
                   second = sine_at(SixBar::z5, SixBar::d, SixBar::c5);
      EXPECT_NEAR(six_bar_transmission(member.six_bar, turns).sine, std::min(first, second), 1e-9);
    }
  }
}

TEST(SixBarPosition, GivesUpWhereNothingCloses) {
  const SixBar six_bar = SixBar::of({Point{0, 0}, Point{1, 0}, Point{1.5, 0.5}}, {BodyPair{0, 2}, BodyPair{0, 3}},
                                    {Point{4, 0}, Point{2, 1}}, {Point{4, 1}, Point{3, 1}});
  EXPECT_FALSE(closed(six_bar, {1, direction(pi), 1, 1, 1, 1})) << "the crank points away: links 2 and 4 are too short";
}

}  // namespace
}  // namespace linkwright::six_bar_position_test
