#include "planar/chosen_length.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "linkwright/core/angle.hpp"
#include "planar/three_pose_family.hpp"
#include "support/random_task.hpp"

namespace linkwright::chosen_length_test {
namespace {

const std::vector<PrescribedPose> poses = {{{{0, 0}, 0}, {}}, {{{1.5, 0.6}, 0.5}, {}}, {{{2.6, 1.9}, 1.2}, {}}};

struct Given {
  PoseConditions conditions = pose_conditions(poses);
  std::shared_ptr<const ThreePoseDyads> dyads = std::make_shared<const ThreePoseDyads>(conditions);
  Requirements requirements;

  Given() { requirements.max_length = default_max_length * conditions.frame.scale; }
  [[nodiscard]] FamilyOfLength family_of(double input) const {
    return [this, input](double output) {
      return std::make_unique<const SideLengthsFamily>(conditions.frame, poses, dyads, input, output);
    };
  }
  // The best score of a length's map, seen from outside.
  [[nodiscard]] double best(double input, double output) const {
    const auto family = family_of(input)(output);
    RegionMap map;
    family->classify(map, family->samples(Side::input, 100, Spacing::coordinate),
                     family->samples(Side::output, 100, Spacing::coordinate), true);
    const RequirementFilter filter = filter_of(*family, map, requirements);
    double largest = 0;
    for (std::size_t row = 0; row < map.rows(); ++row)
      for (std::size_t column = 0; column < map.columns(); ++column)
        if (filter.passes(row, column)) largest = std::max(largest, map.min_transmission_angle(map.index(row, column)));
    return largest;
  }
};

TEST(ChosenLength, IsBetterThanAnyOfTheLengthsInEqualRatios) {
  const Given given;
  const double scale = given.conditions.frame.scale;
  const ChosenLength chosen =
      chosen_length(given.family_of(2), given.conditions.frame, given.requirements, Objective::min_transmission_angle);
  EXPECT_GT(chosen.meeting, 0);
  EXPECT_GE(chosen.tried, ChosenLength::first_trials);
  EXPECT_LT(chosen.tried, ChosenLength::first_trials + 20);
  for (int trial = 0; trial < 25; trial += 1)
    EXPECT_GE(given.best(2, chosen.length), given.best(2, scale * std::pow(10, trial / 12.0 - 1))) << trial;
}

// Public report: the longest length was taken, and none found where there are two linkages.
TEST(ChosenLength, IsSearchedWhereLinkagesAre) {
  const std::vector<PrescribedPose> bracket = {{{{129, 266}, pi}, {}},
                                               {{{259, 237}, radians(154.99920423293614)}, {}},
                                               {{{277, 79}, radians(79.00372741911258)}, {}}};
  const PoseConditions conditions = pose_conditions(bracket);
  const auto dyads = std::make_shared<const ThreePoseDyads>(conditions);
  Requirements wanted;
  wanted.moving_pivots_within = Box{40, 132, 203, 243};
  wanted.max_length = default_max_length * conditions.frame.scale;
  const auto family_of = [&](double output) {
    return std::make_unique<const SideLengthsFamily>(conditions.frame, bracket, dyads, 134.33066801135183, output);
  };
  const ChosenLength chosen =
      chosen_length(family_of, conditions.frame, wanted, Objective::min_transmission_angle, {}, 134.33066801135183);
  EXPECT_GT(chosen.meeting, 0);
}

TEST(ChosenLength, KeepsToTheLinkRatio) {
  const Given given;
  const ChosenLength chosen = chosen_length(given.family_of(2), given.conditions.frame, given.requirements,
                                            Objective::min_transmission_angle, {}, 2);
  EXPECT_GE(chosen.within[0], 2 / given.requirements.max_link_ratio);
  EXPECT_LE(chosen.within[1], 2 * given.requirements.max_link_ratio);
}

// The length of a dyad is told by where its pivots are to lie, however small the window.
TEST(ChosenLength, KeepsToWhatWindowsLeave) {
  Given given;
  const ThreePoseDyads dyads(given.conditions);
  const WorkingFrame& frame = given.conditions.frame;
  for (const Point center : {Point{1.5, -0.7}, Point{-2, 3}, Point{0.3, 0.9}}) {
    const auto dyad = dyads.dyad_with(PivotKind::ground, frame.to_working(Homogeneous::of(center)));
    ASSERT_TRUE(dyad);
    const double length = frame.scale * std::abs(*finite_point(dyad->circle) - *finite_point(dyad->center));
    for (const double margin : {0.1, 1e-3}) {
      Requirements wanted = given.requirements;
      wanted.ground_pivots_within =
          Box{center.real() - margin, center.real() + margin, center.imag() - margin, center.imag() + margin};
      const auto within = lengths_in_windows(dyads, frame, wanted);
      ASSERT_TRUE(within);
      EXPECT_LT((*within)[0], length);
      EXPECT_GT((*within)[1], length);
      if (margin < 0.01) {
        EXPECT_LT((*within)[1] / (*within)[0], 1.1);
      }
    }
  }
  EXPECT_FALSE(lengths_in_windows(dyads, frame, given.requirements));
}

TEST(ChosenLength, FollowsTheObjective) {
  const Given given;
  const auto chosen = [&](Objective objective) {
    return chosen_length(given.family_of(2), given.conditions.frame, given.requirements, objective).length;
  };
  EXPECT_GE(given.best(2, chosen(Objective::min_transmission_angle)), given.best(2, chosen(Objective::size)));
  EXPECT_NE(chosen(Objective::min_transmission_angle), chosen(Objective::size));
  EXPECT_EQ(chosen(Objective::link_ratio), chosen(Objective::link_ratio));
}

TEST(ChosenLength, IsALengthEvenWhereNothingMeetsTheRequirements) {
  Given given;
  given.requirements.max_length = 1e-3;
  const ChosenLength chosen =
      chosen_length(given.family_of(2), given.conditions.frame, given.requirements, Objective::size);
  EXPECT_EQ(chosen.meeting, 0);
  EXPECT_GT(chosen.length, 0);
  EXPECT_LE(chosen.length, 1e-3) << "no longer than a link may be";
}

}  // namespace
}  // namespace linkwright::chosen_length_test
