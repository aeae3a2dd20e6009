#include "linkwright/planar/chain_family.hpp"

#include <gtest/gtest.h>

#include "linkwright/region/requirement_filter.hpp"

namespace linkwright::chain_family_test {
namespace {

SixBarTask task_with(std::array<BodyPair, 2> added) {
  SixBarTask task;
  task.poses = {{{{0, 0}, 0}, {}}, {{{0.8, 0.3}, 0.25}, {}}, {{{1.5, 0.9}, 0.6}, {}}, {{{2, 1.7}, 1}, {}}};
  task.chain = ThreeLinkChain{{-2.5, -1.5}, {-2, 2.2}, {1, 0.9}, {}};
  task.added = added;
  return task;
}

TEST(ChainFamily, NeedsAChainThatReachesAllPoses) {
  SixBarTask task = task_with({BodyPair{0, 2}, BodyPair{0, 3}});
  EXPECT_NE(ChainFamily::of(task), nullptr);
  task.chain->b = {-2.4, -1.4};
  EXPECT_EQ(ChainFamily::of(task), nullptr);
  task.chain.reset();
  EXPECT_EQ(ChainFamily::of(task), nullptr);
}

TEST(ChainFamily, HasACurveOfLinksToEachAxisUnlessLink5HangsOnLink4) {
  const auto apart = ChainFamily::of(task_with({BodyPair{0, 2}, BodyPair{0, 3}}));
  EXPECT_FALSE(apart->second_is_share());
  EXPECT_EQ(apart->axis(Side::output).coordinate_length(), apart->links(Side::output)->curve->coordinate_length());
  const auto hung = ChainFamily::of(task_with({BodyPair{0, 2}, BodyPair{4, 3}}));
  EXPECT_TRUE(hung->second_is_share());
  EXPECT_EQ(hung->links(Side::output), nullptr);
  EXPECT_EQ(hung->axis(Side::output).coordinate_length(), 1);
}

TEST(ChainFamily, KnowsThePointOfEachMember) {
  for (const BodyPair link_5 : {BodyPair{0, 3}, BodyPair{4, 3}}) {
    const auto family = ChainFamily::of(task_with({BodyPair{0, 2}, link_5}));
    int members = 0;
    for (const double u : family->samples(Side::input, 7, Spacing::coordinate))
      for (const double v : family->samples(Side::output, 7, Spacing::coordinate))
        if (const auto member = family->member({u, v})) {
          ++members;
          EXPECT_NEAR(family->point_of(*member).input, u, 1e-12);
          EXPECT_NEAR(family->point_of(*member).output, v, 1e-12);
        }
    EXPECT_GT(members, 20);
  }
}

TEST(ChainFamily, IsFilteredByWhereItsHingesLie) {
  const auto family = ChainFamily::of(task_with({BodyPair{0, 2}, BodyPair{0, 3}}));
  RegionMap map;
  family->classify(map, family->samples(Side::input, 8, Spacing::coordinate),
                   family->samples(Side::output, 8, Spacing::coordinate), true);
  Requirements wanted;
  wanted.no_defects = false;
  wanted.max_link_ratio = wanted.max_length.emplace(Requirements::unlimited);
  wanted.moving_pivots_within = Box{-4, 4, -4, 4};
  const RequirementFilter filter = filter_of(*family, map, wanted);
  int inside = 0;
  for (std::size_t row = 0; row < map.rows(); ++row)
    for (std::size_t column = 0; column < map.columns(); ++column) {
      const auto member = family->member({map.input_coordinates()[row], map.output_coordinates()[column]});
      if (!member || map.type(map.index(row, column)) == LinkageType::degenerate) continue;
      bool holds = true;
      for (const SixBarJoint& joint : member->six_bar.joints)
        holds = holds && (is_on_ground(joint) || wanted.moving_pivots_within->contains(joint.point));
      EXPECT_EQ(filter.passes(row, column), holds);
      inside += holds ? 1 : 0;
    }
  EXPECT_GT(inside, 0);
}

}  // namespace
}  // namespace linkwright::chain_family_test
