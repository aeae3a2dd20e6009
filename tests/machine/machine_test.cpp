#include "linkwright/machine/machine.hpp"

#include <gtest/gtest.h>

#include "support/machine_cases.hpp"

namespace linkwright::machine_test {
namespace {

TEST(Machine, HasAPlateToEachBodyAndAPinToEachHinge) {
  for (const Machine& made : testing::machines()) {
    const std::size_t bodies = made.linkage.bodies.size(), hinges = made.linkage.hinges.size();
    ASSERT_EQ(made.parts.size(), bodies + hinges);
    for (std::size_t k = 0; k < bodies; ++k) EXPECT_EQ(made.parts[k].name, made.linkage.bodies[k]);
    for (std::size_t k = 0; k < hinges; ++k) {
      const Part& pin = made.parts[bodies + k];
      EXPECT_EQ(pin.name, "pin_" + made.linkage.hinges[k].name);
      EXPECT_TRUE(std::holds_alternative<RoundPin>(pin.shape));
    }
  }
}

TEST(Machine, HolesLieAsFarApartAsTheLinksAreLong) {
  for (const Machine& made : testing::machines())
    for (std::size_t body = 0; body < made.linkage.bodies.size(); ++body) {
      const auto hinges = made.linkage.hinges_of(static_cast<int>(body));
      if (const auto* plate = std::get_if<FlatPlate>(&made.parts[body].shape)) {
        ASSERT_GE(plate->holes.size(), hinges.size());
        for (std::size_t k = 0; k < hinges.size(); ++k)
          EXPECT_EQ(in_space(plate->holes[k]), made.linkage.hinges[hinges[k]].point);
      } else {
        const auto& shell = std::get<ShellPlate>(made.parts[body].shape);
        EXPECT_EQ(shell.from, made.linkage.hinges[hinges[0]].point);
        EXPECT_EQ(shell.to, made.linkage.hinges[hinges[1]].point);
      }
    }
}

TEST(Machine, PinsReachThroughBothOfTheirPlates) {
  for (const Machine& made : testing::machines()) {
    const std::size_t bodies = made.linkage.bodies.size();
    for (std::size_t k = 0; k < made.linkage.hinges.size(); ++k) {
      const auto& pin = std::get<RoundPin>(made.parts[bodies + k].shape);
      for (const int body : made.linkage.hinges[k].bodies)
        if (const auto* plate = std::get_if<FlatPlate>(&made.parts[static_cast<std::size_t>(body)].shape)) {
          EXPECT_LE(pin.from.z, plate->low);
          EXPECT_GE(pin.to.z, plate->high);
        }
    }
  }
}

TEST(Machine, OfAPointThatIsTracedThePlateReachesIt) {
  int traced = 0;
  for (const Machine& made : testing::machines())
    if (made.linkage.traced) {
      EXPECT_EQ(std::get<FlatPlate>(made.parts[2].shape).holes.size(), 3u);
      ++traced;
    }
  EXPECT_GT(traced, 0);
}

TEST(Machine, WithoutLayersFreeOfCollisionsItSaysWhatMeets) {
  StoredLinkage drag_link;
  drag_link.four_bar = {{0, 0}, {3, 0}, {1, 0}, {1, 3}};
  const Machine made = machine(moving_linkage(AnyStoredLinkage(drag_link))).value();
  EXPECT_FALSE(made.layers.crossings.empty());
  EXPECT_NE(collision_text(made).find("comes nearer"), std::string::npos);
  EXPECT_EQ(collision_text(testing::machines().front()), "");
}

}  // namespace
}  // namespace linkwright::machine_test
