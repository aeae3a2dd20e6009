#include "linkwright/machine/moving_linkage.hpp"

#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/files/csv_table.hpp"
#include "support/machine_cases.hpp"

namespace linkwright::moving_linkage_test {
namespace {

double size_of(const MovingLinkage& linkage) { return linkage.longest_link(); }

TEST(MovingLinkage, HingesStayTogetherOverTheTravel) {
  for (const AnyStoredLinkage& stored : testing::stored_linkages_of_examples()) {
    const MovingLinkage linkage = moving_linkage(stored);
    ASSERT_GT(linkage.travel.size(), 100u) << linkage.title;
    for (const MovingState& state : linkage.travel)
      for (const Hinge& hinge : linkage.hinges) {
        const Vector3 one = state.bodies[static_cast<std::size_t>(hinge.bodies[0])].apply_to_point(hinge.point);
        const Vector3 other = state.bodies[static_cast<std::size_t>(hinge.bodies[1])].apply_to_point(hinge.point);
        ASSERT_LT(norm(one - other), 1e-11 * size_of(linkage)) << linkage.title << ' ' << hinge.name;
      }
  }
}

TEST(MovingLinkage, TheGuidedBodyPassesThePosesOfTheTask) {
  int checked = 0;
  for (const AnyStoredLinkage& any : testing::stored_linkages_of_examples()) {
    const MovingLinkage linkage = moving_linkage(any);
    const std::vector<PrescribedPose>* poses = nullptr;
    if (const auto* four_bar = std::get_if<StoredLinkage>(&any)) poses = &four_bar->poses;
    if (const auto* six_bar = std::get_if<StoredSixBar>(&any)) poses = &six_bar->poses;
    if (poses == nullptr || poses->empty()) continue;
    for (std::size_t k = 0; k < poses->size(); ++k) {
      const MovingState* state = linkage.at_position(static_cast<int>(k));
      ASSERT_NE(state, nullptr) << linkage.title << ' ' << k;
      const Displacement& there = state->bodies[static_cast<std::size_t>(linkage.guided)];
      EXPECT_LT(norm(there.apply_to_point(in_space((*poses)[0].pose.origin)) - in_space((*poses)[k].pose.origin)),
                1e-8 * size_of(linkage))
          << linkage.title;
      const Rotation turn = Rotation::about_z((*poses)[k].pose.angle - (*poses)[0].pose.angle);
      EXPECT_LT(angle_between(there.rotation, turn), 1e-8) << linkage.title;
      ++checked;
    }
  }
  EXPECT_GT(checked, 20);
}

TEST(MovingLinkage, ASphericalCouplerPassesTheOrientationsOfTheTask) {
  int checked = 0;
  for (const AnyStoredLinkage& any : testing::stored_linkages_of_examples()) {
    const auto* stored = std::get_if<StoredSphericalFourBar>(&any);
    if (stored == nullptr) continue;
    const MovingLinkage linkage = moving_linkage(any);
    for (std::size_t k = 0; k < stored->orientations.size(); ++k) {
      const MovingState* state = linkage.at_position(static_cast<int>(k));
      ASSERT_NE(state, nullptr);
      const UnitQuaternion turn = UnitQuaternion(stored->orientations[k].orientation) *
                                  UnitQuaternion(stored->orientations[0].orientation).inverse();
      EXPECT_LT(angle_between(state->bodies[2].rotation, Rotation(turn)), 1e-8);
      ++checked;
    }
  }
  EXPECT_GT(checked, 8);
}

TEST(MovingLinkage, TheTaskIsAStretchOfTheTravelFromFirstToLastPosition) {
  for (const AnyStoredLinkage& stored : testing::stored_linkages_of_examples()) {
    const MovingLinkage linkage = moving_linkage(stored);
    ASSERT_FALSE(linkage.task.empty()) << linkage.title;
    std::vector<int> met;
    for (std::size_t k = 0; k < linkage.task.size(); ++k) {
      const MovingState& state = linkage.travel[linkage.task[k]];
      if (state.position) met.push_back(*state.position);
      if (k == 0) continue;
      const MovingState& before = linkage.travel[linkage.task[k - 1]];
      EXPECT_LT(std::abs(wrap_signed(state.driver_turn - before.driver_turn)), 0.0044 + 1e-9) << linkage.title;
    }
    std::vector<int> all;
    for (int k = 0; k < linkage.positions; ++k) all.push_back(k);
    if (linkage.title.starts_with("straight"))
      std::sort(met.begin(), met.end());  // the middle of the stroke comes first
    EXPECT_EQ(met, all) << linkage.title;
  }
}

TEST(MovingLinkage, TheDriverTurnsAsItSays) {
  for (const AnyStoredLinkage& stored : testing::stored_linkages_of_examples()) {
    const MovingLinkage linkage = moving_linkage(stored);
    const Vector3 axis = linkage.spherical ? linkage.hinges[0].point : Vector3{0, 0, 1};
    for (const MovingState& state : linkage.travel) {
      const Rotation turn(UnitQuaternion::about(axis, state.driver_turn));
      ASSERT_LT(angle_between(turn, state.bodies[1].rotation), 1e-9) << linkage.title;
    }
  }
}

TEST(MovingLinkage, ALinkageWithoutATaskStandsInItsFirstPosition) {
  StoredLinkage stored;
  stored.four_bar = {{0, 0}, {0, 1}, {4, 0}, {3.5, 2.5}};
  const MovingLinkage linkage = moving_linkage(AnyStoredLinkage(stored));
  EXPECT_TRUE(linkage.full_turn);
  EXPECT_EQ(linkage.positions, 1);
  EXPECT_EQ(linkage.task.size(), 1u);
  EXPECT_DOUBLE_EQ(linkage.longest_link(), 4);
  EXPECT_DOUBLE_EQ(linkage.shortest_link(), 1);
  EXPECT_EQ(linkage.millimetres(), 1);
}

TEST(MovingLinkage, KnowsItsUnitOfLength) {
  MovingLinkage linkage;
  linkage.length_unit = "in";
  EXPECT_EQ(linkage.millimetres(), 25.4);
  linkage.length_unit = "furlong";
  EXPECT_EQ(linkage.millimetres(), 1);
}

TEST(MovingLinkage, OfPositionsBeyondADeadPointThereIsNoStretch) {
  StoredLinkage stored;
  stored.four_bar = {{0, 0}, {0, 1}, {4, 0}, {3.5, 2.5}};
  stored.poses = {{{{0, 1}, 0}, {}}, {{{50, 1}, 0}, {}}};  // far beyond any reach
  EXPECT_TRUE(moving_linkage(AnyStoredLinkage(stored)).task.empty());
}

}  // namespace
}  // namespace linkwright::moving_linkage_test
