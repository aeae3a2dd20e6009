#include "linkwright/machine/plate_layers.hpp"

#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <set>

#include "machine/hull_distance.hpp"
#include "machine/plate_corners.hpp"
#include "support/draws.hpp"
#include "support/machine_cases.hpp"

namespace linkwright::plate_layers_test {
namespace {

StoredLinkage crank_rocker() {
  StoredLinkage stored;
  stored.four_bar = {{0, 0}, {0, 1}, {4, 0}, {3.5, 2.5}};
  return stored;
}

TEST(PlateSizes, ComeFromTheLongestLink) {
  const MovingLinkage linkage = moving_linkage(AnyStoredLinkage(crank_rocker()));
  const PlateSizes sizes = plate_sizes(linkage, {}).value();
  EXPECT_DOUBLE_EQ(sizes.thickness, 0.24);
  EXPECT_DOUBLE_EQ(sizes.pin, 0.2);
  EXPECT_DOUBLE_EQ(sizes.width, 0.48);
  WantedSizes wanted;
  wanted.width = 0.7;
  wanted.pin = 0.3;
  wanted.clearance = 0;
  const PlateSizes given = plate_sizes(linkage, wanted).value();
  EXPECT_EQ(given.width, 0.7);
  EXPECT_EQ(given.hole(), 0.3);
}

TEST(PlateSizes, MistakesSayTheWayOut) {
  const MovingLinkage linkage = moving_linkage(AnyStoredLinkage(crank_rocker()));
  const auto code = [&](WantedSizes wanted) {
    const auto sizes = plate_sizes(linkage, wanted);
    return sizes ? std::string("none") : sizes.errors().front().code;
  };
  WantedSizes wanted;
  wanted.pin = 1.5;
  EXPECT_EQ(code(wanted), "pins_overlap");
  wanted = {};
  wanted.width = 0.2;
  EXPECT_EQ(code(wanted), "pin_too_wide");
  for (const double bad : {-1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    wanted = {};
    wanted.thickness = bad;
    EXPECT_EQ(code(wanted), "size_out_of_range") << bad;
  }
  const auto& sphere = testing::machines();
  for (const Machine& made : sphere) {
    if (!made.linkage.spherical) continue;
    wanted = {};
    wanted.thickness = 60;
    EXPECT_EQ(plate_sizes(made.linkage, wanted).errors().front().code, "sphere_too_small");
  }
}

/// Looks at every tenth of the states with points spread over both plates.
bool collide_somewhere(const Machine& made, int one, int other, const std::vector<std::size_t>& states) {
  const auto points = [&](int body, const MovingState& state) {
    const std::vector<Vector3> corners = plate_corners(made.linkage, body);
    std::vector<Vector3> all;
    for (int k = 0; k <= 40; ++k) {
      Vector3 p = (1 - k / 40.0) * corners.front() + k / 40.0 * corners.back();
      if (made.linkage.spherical) p = normalized(p);
      all.push_back(state.bodies[static_cast<std::size_t>(body)].apply_to_point(p));
    }
    return all;
  };
  for (std::size_t k = 0; k < states.size(); k += 10) {
    const MovingState& state = made.linkage.travel[states[k]];
    for (const Vector3 p : points(one, state))
      for (const Vector3 q : points(other, state)) {
        const double apart = made.linkage.spherical ? made.sizes.radius * angle_between(p, q) : norm(p - q);
        if (apart < made.sizes.width) return true;
      }
  }
  return false;
}

TEST(PlateLayers, WhatSharesALayerNeverMeets) {
  for (const Machine& made : testing::machines()) {
    const std::vector<int>& layer = made.layers.layer;
    EXPECT_EQ(layer[0], 0);
    EXPECT_TRUE(made.layers.crossings.empty()) << made.linkage.title << ": " << collision_text(made);
    for (const Hinge& hinge : made.linkage.hinges)
      EXPECT_NE(layer[static_cast<std::size_t>(hinge.bodies[0])], layer[static_cast<std::size_t>(hinge.bodies[1])]);
    for (std::size_t a = 1; a < layer.size(); ++a)
      for (std::size_t b = a + 1; b < layer.size(); ++b) {
        if (layer[a] != layer[b]) continue;
        EXPECT_FALSE(collide_somewhere(made, static_cast<int>(a), static_cast<int>(b), made.linkage.task))
            << made.linkage.title;
      }
  }
}

TEST(PlateLayers, OfACrankThatPassesItsRockersPivotThePinEndsBelow) {
  // The coupler passes over both fixed pivots of a short ground link: no pin may stand in its way.
  StoredLinkage drag_link;
  drag_link.four_bar = {{0, 0}, {3, 0}, {1, 0}, {1, 3}};
  const MovingLinkage linkage = moving_linkage(AnyStoredLinkage(drag_link));
  ASSERT_TRUE(linkage.full_turn);
  const PlateLayers layers = plate_layers(linkage, plate_sizes(linkage, {}).value());
  EXPECT_FALSE(layers.crossings.empty());  // the links go round each other's pins: no straight plates can
  for (const Crossing& crossing : layers.crossings) EXPECT_GE(crossing.to_turn, crossing.from_turn);
}

TEST(HullDistance, IsThatOfManyPoints) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const auto draw = [&](int count) {
    std::vector<Vector3> hull;
    for (int k = 0; k < count; ++k) hull.push_back({coordinate(random), coordinate(random), 0});
    return hull;
  };
  for (int trial = 0; trial < testing::draws(300); ++trial) {
    const std::vector<Vector3> a = draw(2 + trial % 3), b = draw(1 + trial % 4);
    double least = 10;
    std::uniform_real_distribution<double> share(0, 1);
    const auto inside = [&](const std::vector<Vector3>& hull) {
      Vector3 sum{};
      double weights = 0;
      for (const Vector3 corner : hull) {
        const double weight = std::pow(share(random), 4);
        sum = sum + weight * corner;
        weights += weight;
      }
      return sum / weights;
    };
    for (int k = 0; k < 2000; ++k) least = std::min(least, norm(inside(a) - inside(b)));
    const double exact = hull_distance(a, b);
    EXPECT_LE(exact, least + 1e-12);
    EXPECT_GT(exact, least - 0.15);
  }
}

TEST(ArcDistance, IsThatOfManyPoints) {
  std::mt19937_64 random(8);
  std::normal_distribution<double> coordinate;
  const auto axis = [&] { return normalized(Vector3{coordinate(random), coordinate(random), coordinate(random)}); };
  for (int trial = 0; trial < testing::draws(300); ++trial) {
    std::vector<Vector3> a = {axis(), axis()}, b = {axis(), axis()};
    if (trial % 5 == 0) b.pop_back();
    double least = 4;
    for (int i = 0; i <= 200; ++i)
      for (int k = 0; k <= 200; ++k) {
        const Vector3 p = normalized((1 - i / 200.0) * a.front() + i / 200.0 * a.back());
        const Vector3 q = normalized((1 - k / 200.0) * b.front() + k / 200.0 * b.back());
        least = std::min(least, angle_between(p, q));
      }
    const double exact = arc_distance(a, b);
    EXPECT_LE(exact, least + 1e-12);
    EXPECT_GT(exact, least - 0.05);
  }
}

}  // namespace
}  // namespace linkwright::plate_layers_test
