#include "linkwright/planar/six_bar_solution.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/planar/six_bar_task.hpp"
#include "mechanism/six_bar_judge.hpp"
#include "support/draws.hpp"
#include "support/random_six_bar.hpp"

namespace linkwright::six_bar_solution_test {
namespace {

TEST(SixBarSolution, IsCheckedInTheUsersCoordinates) {
  std::mt19937_64 random(41);
  int free_ones = 0;
  for (const SixBarRow& row : six_bar_rows())
    for (int i = 0; i < 6; ++i) {
      const auto [task, member] = testing::random_six_bar(random, row);
      const SixBarSolution solution = solution_of(task.poses, task.chain, row, member);
      EXPECT_EQ(member.six_bar.topology(), row.topology);
      EXPECT_EQ(solution.lengths.size(), 10u);
      EXPECT_LT(solution.residual, 1e-10);
      EXPECT_LT(solution.pose_residual, 1e-12);
      const SixBarRating quick = rating_of(member, true);
      EXPECT_EQ(quick.drive.defects, solution.rating.drive.defects);
      if (!solution.rating.drive.defects.none() || solution.rating.drive.min_sine < 0.05) continue;
      ++free_ones;
      EXPECT_TRUE(solution.verified_by_driving) << text(row.added[0]) << text(row.added[1]) << i;
    }
  EXPECT_GT(free_ones, 10);
}

/// The six-bars of a chain over a coarse map, wild ones with long and short links among them.
std::vector<SixBarMember> members_of(const testing::ReachedTask& task, const SixBarRow& row, int samples) {
  const SixBarFamily family(task.chain, row.added, task.bodies);
  std::vector<SixBarMember> members;
  for (int i = 0; i < samples; ++i) {
    const auto first = family.with_first(family.first().curve->coordinate_length() * (i + 0.5) / samples);
    for (int k = 0; first && k < samples; ++k)
      if (const auto member =
              family.member(*first, family.second_tau(*first, family.second_axis_length() * (k + 0.5) / samples)))
        members.push_back(*member);
  }
  return members;
}

TEST(SixBarSolution, ManyAtOnceAreJudgedAsDrivingJudgesEach) {
  std::mt19937_64 random(43);
  constexpr int samples = 14;
  int free_ones = 0, order = 0, branch = 0, given_up = 0;
  double worst_sine = 0;
  for (int chain = 0; chain < testing::draws(20); ++chain)
    for (const SixBarRow& row : six_bar_rows()) {
      const testing::ReachedTask task = testing::random_reached_task(random);
      const std::vector<SixBarMember> members = members_of(task, row, samples);
      const std::vector<SixBarRating> ratings = ratings_of(members);
      ASSERT_EQ(ratings.size(), members.size());
      for (std::size_t i = 0; i < members.size(); ++i) {
        const SixBarDriveReport& judged = ratings[i].drive;
        if (ratings[i].shape.type == LinkageType::degenerate) continue;
        SixBarDriveOptions options;
        options.circuits = false;
        SixBarDriveReport driven = drive_six_bar(members[i].six_bar, members[i].turns, options);
        if (judged.defects != driven.defects) {  // two in a million: one of Newton's steps a step was not enough there
          options.exact_steps = true;
          driven = drive_six_bar(members[i].six_bar, members[i].turns, options);
        }
        if (!judged.completed && driven.steps > most_steps_of_many) {
          ++given_up;
          continue;
        }
        ASSERT_EQ(judged.completed, driven.completed) << text(row.added[0]) << " " << text(row.added[1]) << " " << i;
        ASSERT_EQ(judged.defects, driven.defects) << text(row.added[0]) << " " << text(row.added[1]) << " " << i;
        ASSERT_EQ(judged.sense, driven.sense);
        EXPECT_NEAR(judged.sweep, driven.sweep, 1e-4);
        (driven.defects.none() ? free_ones : driven.defects.bits & Defects::order_bit ? order : branch) += 1;
        worst_sine = std::max(worst_sine, std::abs(judged.min_sine - driven.min_sine));
      }
    }
  EXPECT_GT(free_ones, testing::draws(500));
  EXPECT_GE(order, testing::draws(20) / 20);
  EXPECT_GT(branch, testing::draws(20'000));
  EXPECT_LE(given_up, 5);
  EXPECT_LT(worst_sine, 0.02);  // driving looks at its steps only, the judge between its own, too
}

TEST(SixBarSolution, TheLeastSineIsThatOfDenseStepsOfTheDriver) {
  std::mt19937_64 random(44);
  constexpr int steps = 4000;
  int compared = 0;
  for (const SixBarRow& row : six_bar_rows())
    for (int chain = 0; chain < 4; ++chain) {
      const std::vector<SixBarMember> members = members_of(testing::random_reached_task(random), row, 6);
      const std::vector<SixBarRating> ratings = ratings_of(members);
      for (std::size_t i = 0; i < members.size(); ++i) {
        const SixBarDriveReport& drive = ratings[i].drive;
        if (!drive.completed || !drive.defects.none() || drive.min_sine < 0.01) continue;
        const double sense = drive.sense == DriveSense::cw ? -1 : 1;
        SixBarTurns turns = members[i].turns[0];
        double least = 1;
        for (int step = 0; step <= steps; ++step) {
          turns[SixBar::driver] = direction(sense * drive.sweep * step / steps);
          const auto found = closed(members[i].six_bar, turns);
          ASSERT_TRUE(found);
          turns = *found;
          least = std::min(least, six_bar_transmission(members[i].six_bar, turns).sine);
        }
        EXPECT_NEAR(drive.min_sine, least, 2e-3) << text(row.added[0]) << " " << text(row.added[1]);
        ++compared;
      }
    }
  EXPECT_GT(compared, 10);
}

TEST(SixBarSolution, EveryInstructionSetGivesTheSameBits) {
  std::mt19937_64 random(45);
  for (const SixBarRow& row : six_bar_rows()) {
    const std::vector<SixBarMember> members = members_of(testing::random_reached_task(random), row, 12);
    const std::vector<SixBarRating> ratings = ratings_of(members, Simd::scalar);
    for (const Simd simd : {Simd::baseline, Simd::avx2, Simd::avx512}) {
      if (!is_supported(simd)) continue;
      const std::vector<SixBarRating> others = ratings_of(members, simd);
      for (std::size_t i = 0; i < members.size(); ++i) {
        EXPECT_EQ(ratings[i].drive.defects, others[i].drive.defects);
        EXPECT_EQ(ratings[i].drive.min_sine, others[i].drive.min_sine) << name(simd);
      }
    }
  }
}

TEST(SixBarSolution, OfAnotherBodyIsNotVerified) {
  std::mt19937_64 random(42);
  for (const SixBarRow& row : six_bar_rows()) {
    auto [task, member] = testing::random_six_bar(random, row);
    task.poses[2].pose.origin += Point{0, 0.01};
    const SixBarSolution solution = solution_of(task.poses, task.chain, row, member);
    EXPECT_GT(solution.pose_residual, 1e-4);
    if (solution.rating.drive.defects.none()) {
      EXPECT_FALSE(solution.verified_by_driving);
    }
  }
}

TEST(SixBarSolution, MeasuresItsShape) {
  const SixBar six_bar = SixBar::of({Point{0, 0}, Point{0, 1}, Point{3, 2}}, {BodyPair{0, 2}, BodyPair{0, 3}},
                                    {Point{4, 0}, Point{4, 3}}, {Point{9, -4}, Point{8, 3}});
  const SixBarShape shape = shape_of(six_bar);
  EXPECT_DOUBLE_EQ(shape.longest, std::abs(Point{9, -4}));
  EXPECT_DOUBLE_EQ(shape.link_ratio, std::abs(Point{9, -4}));
  EXPECT_EQ(shape.type, LinkageType::crank_rocker);
  SixBar without_crank = six_bar;
  without_crank.joints[SixBar::b].point = 0;
  EXPECT_EQ(shape_of(without_crank).type, LinkageType::degenerate);
  EXPECT_EQ(SixBarRating{shape_of(without_crank)}.cell().type, LinkageType::degenerate);
}

TEST(SixBarSolution, MeetsRequirementsOrNot) {
  const SixBar six_bar = SixBar::of({Point{0, 0}, Point{0, 1}, Point{3, 2}}, {BodyPair{0, 2}, BodyPair{0, 3}},
                                    {Point{4, 0}, Point{4, 3}}, {Point{9, -4}, Point{8, 3}});
  SixBarRating rating{shape_of(six_bar)};
  rating.drive.completed = true;
  rating.drive.min_sine = 0.5;
  Requirements wanted;
  EXPECT_TRUE(meets(wanted, six_bar, rating));
  EXPECT_NEAR(rating.min_transmission_angle(), radians(30), 1e-12);
  EXPECT_NEAR(rating.versine(), 1 - std::cos(radians(30)), 1e-12);
  wanted.min_transmission_angle = radians(31);
  EXPECT_FALSE(meets(wanted, six_bar, rating));
  wanted = {};
  wanted.max_length = 9;
  EXPECT_FALSE(meets(wanted, six_bar, rating));
  wanted = {};
  wanted.max_link_ratio = 5;
  EXPECT_FALSE(meets(wanted, six_bar, rating));
  wanted = {};
  wanted.types = {LinkageType::double_crank};
  EXPECT_FALSE(meets(wanted, six_bar, rating));
  wanted = {};
  wanted.ground_pivots_within = Box{-1, 9, -5, 1};
  EXPECT_TRUE(meets(wanted, six_bar, rating));
  wanted.moving_pivots_within = Box{-1, 5, -5, 5};
  EXPECT_FALSE(meets(wanted, six_bar, rating)) << "z5 lies outside";
  rating.drive.defects.bits = Defects::order_bit;
  EXPECT_FALSE(meets({}, six_bar, rating));
}

TEST(SixBarSolution, TakesItsLongestLinkFromTheChain) {
  const ThreeLinkChain chain{{0, 0}, {0, 3}, {4, 3}, {}};
  EXPECT_DOUBLE_EQ(with_defaults(Requirements{}, chain).max_length.value_or(0), 50);
  Requirements wanted;
  wanted.max_length = 7;
  EXPECT_DOUBLE_EQ(with_defaults(wanted, chain).max_length.value_or(0), 7);
}

SixBar watt() {
  const auto row = six_bar_row({BodyPair{0, 2}, BodyPair{0, 3}});
  return SixBar::of({Point{0, 0}, Point{1, 0}, Point{3, 2}}, row->added, {Point{5, 0}, Point{4, 3}},
                    {Point{6, -4}, Point{8, 3}});
}

std::vector<PrescribedPose> as_it_lies(const SixBar& six_bar) { return {{{six_bar.at(SixBar::d), 0}, {}}}; }

TEST(SixBarAnalysis, OfOnePoseHasNoTravelButAllThatItCanDo) {
  const SixBarAnalysis found = analyze(watt(), as_it_lies(watt()));
  EXPECT_TRUE(found.travel.states.empty());
  EXPECT_FALSE(found.motion.states.empty());
  EXPECT_EQ(found.lengths.size(), watt().lengths().size());
  EXPECT_GT(found.transmission_angle, 0);
}

TEST(SixBarAnalysis, HingesOfALinkKeepTheirDistances) {
  const SixBar six_bar = watt();
  const SixBarMotion motion = tabulated_motion(six_bar, as_it_lies(six_bar));
  ASSERT_GT(motion.states.size(), 2u);
  for (const SixBarMotionState& state : motion.states)
    for (const SixBarLength& length : six_bar.lengths()) {
      const auto& [a, b] = length.joints;
      EXPECT_NEAR(std::abs(state.place.joints[a] - state.place.joints[b]), length.length, 1e-9);
    }
}

}  // namespace
}  // namespace linkwright::six_bar_solution_test
