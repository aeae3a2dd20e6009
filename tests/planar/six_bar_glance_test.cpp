#include "planar/six_bar_glance.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "linkwright/planar/six_bar_solution.hpp"
#include "support/draws.hpp"
#include "support/random_six_bar.hpp"

namespace linkwright::six_bar_glance_test {
namespace {

using Bodies = std::array<BodyPositions, 4>;

const BodyPositions& body(const Bodies& bodies, int i) { return bodies[static_cast<std::size_t>(i)]; }

/// The largest change of the distance of a link's hinges from position 1, as a share of how far away they are.
double change_of_length(const LinkHinges& link, const BodyPositions& x, const BodyPositions& k) {
  const double length = std::abs(link[1] - link[0]), reach = 1 + std::abs(link[0]) + std::abs(link[1]);
  double change = 0;
  for (std::size_t j = 0; j < 4; ++j)
    change = std::max(change, std::abs(std::abs(k.moved(link[1], j) - x.moved(link[0], j)) - length) / reach);
  return change;
}

TEST(LinksThroughPole, KeepTheirLengthInAllPositions) {
  std::mt19937_64 random(21);
  int links = 0, inexact = 0;
  for (int i = 0; i < testing::draws(2000); ++i) {
    const testing::ReachedTask task = testing::random_reached_task(random);
    for (const auto& [a, b] : {BodyPair{0, 2}, BodyPair{1, 3}, BodyPair{0, 3}})
      for (const LinkHinges& link : links_through_pole(body(task.bodies, a), body(task.bodies, b))) {
        ++links;
        const double change = change_of_length(link, body(task.bodies, a), body(task.bodies, b));
        EXPECT_LT(change, 1e-5);
        if (change > 1e-9) ++inexact;
      }
  }
  EXPECT_GT(links, testing::draws(2000) * 24);
  EXPECT_LT(inexact, links / 100);
}

TEST(LinksThroughPole, LieOnTheCurve) {
  std::mt19937_64 random(22);
  int links = 0, strays = 0;
  for (int i = 0; i < testing::draws(200); ++i) {
    const testing::ReachedTask task = testing::random_reached_task(random);
    const SixBarFamily family(task.chain, {BodyPair{0, 2}, BodyPair{1, 3}}, task.bodies);
    for (const LinkHinges& link : links_through_pole(body(task.bodies, 0), body(task.bodies, 2))) {
      const AddedLinks& curve = family.first();
      const auto tau = curve.curve->coordinate_of(Homogeneous::of(curve.conditions.frame.to_working(link[1])));
      ASSERT_TRUE(tau);
      const auto hinges = curve.hinges(*tau, task.chain.size());
      if (!hinges) continue;
      ++links;
      const double reach = 1 + std::abs(link[0]) + std::abs(link[1]);
      if (std::abs((*hinges)[0] - link[0]) > 1e-6 * reach || std::abs((*hinges)[1] - link[1]) > 1e-6 * reach) ++strays;
    }
  }
  EXPECT_GT(links, testing::draws(200) * 10);
  EXPECT_LT(strays, links / 100);  // where the curve comes close to itself, or its centre points are far away
}

TEST(LinksThroughPole, AreNoneOfBodiesThatDoNotTurnToEachOther) {
  BodyPositions still, shifted;
  for (std::size_t j = 0; j < 4; ++j) {
    still.at[j] = {0, 1};
    const auto step = static_cast<double>(j);
    shifted.at[j] = {Point{step, step * step}, 1};
  }
  EXPECT_TRUE(links_through_pole(still, shifted).empty());
}

const Box box{-6, 6, -6, 6};

SixBarGlance::Seen all_of(const testing::ReachedTask& task, const SixBarRow& row) {
  Requirements nothing;
  nothing.no_defects = false;
  return SixBarGlance(row.added, box, nothing).look_at(task.bodies);
}

SixBarMember member_of(const testing::ReachedTask& task, const SixBarRow& row, const std::array<LinkHinges, 2>& links) {
  const BodyPositions link_4 =
      positions_of_link(links[0], body(task.bodies, row.added[0].a), body(task.bodies, row.added[0].b));
  return six_bar_member(task.chain, row.added, task.bodies, links[0], link_4, links[1]);
}

TEST(SixBarGlance, CountsAllInTheBoxAndTheyClose) {
  std::mt19937_64 random(23);
  for (const SixBarRow& row : six_bar_rows()) {
    std::size_t seen = 0;
    for (int i = 0; i < testing::draws(60); ++i) {
      const testing::ReachedTask task = testing::random_reached_task(random);
      const auto [six_bars, all] = all_of(task, row);
      EXPECT_EQ(static_cast<std::size_t>(six_bars), all.size());
      seen += all.size();
      for (const auto& links : all) {
        for (const LinkHinges& link : links) EXPECT_TRUE(box.contains(link[0]) && box.contains(link[1]));
        const SixBarMember member = member_of(task, row, links);
        for (const SixBarTurns& turns : member.turns) EXPECT_LT(closure_error(member.six_bar, turns), 1e-4);
      }
    }
    EXPECT_GT(seen, 0u) << text(row.added[0]) << text(row.added[1]);
  }
}

TEST(SixBarGlance, PassesOverNoneThatMeetsTheRequirements) {
  std::mt19937_64 random(24);
  std::size_t passed_over = 0, meeting = 0;
  for (const SixBarRow& row : six_bar_rows())
    for (int i = 0; i < testing::draws(40); ++i) {
      const testing::ReachedTask task = testing::random_reached_task(random);
      Requirements wanted = with_defaults({}, task.chain);
      wanted.min_transmission_angle = 0.05;
      wanted.max_link_ratio = 1000;
      const auto promising = SixBarGlance(row.added, box, wanted).look_at(task.bodies).promising;
      const auto is_promising = [&](const auto& links) {
        return std::find(promising.begin(), promising.end(), links) != promising.end();
      };
      std::vector<SixBarMember> others;
      const auto all = all_of(task, row).promising;
      for (const auto& links : all)
        if (!is_promising(links)) others.push_back(member_of(task, row, links));
      passed_over += others.size();
      meeting += promising.size();
      const auto ratings = ratings_of(others);
      for (std::size_t k = 0; k < others.size(); ++k)
        EXPECT_FALSE(meets(wanted, others[k].six_bar, ratings[k])) << text(row.added[0]) << text(row.added[1]);
    }
  EXPECT_GT(passed_over, 1000u);
  EXPECT_GT(meeting, 1000u);
}

}  // namespace
}  // namespace linkwright::six_bar_glance_test
