#include "linkwright/mechanism/linkage_type.hpp"

#include <gtest/gtest.h>
#include <limits>
#include <random>

#include "linkwright/mechanism/position.hpp"
#include "support/random_four_bar.hpp"

namespace linkwright::linkage_type_test {
namespace {

TEST(LinkageType, TextbookLinkages) {
  // Grashof's law in its four inversions of 2, 5, 6, 7 and the four triple rockers of 3, 5, 6, 9.
  EXPECT_EQ(linkage_type({7, 2, 5, 6}), LinkageType::crank_rocker);
  EXPECT_EQ(linkage_type({7, 6, 5, 2}), LinkageType::rocker_crank);
  EXPECT_EQ(linkage_type({2, 7, 5, 6}), LinkageType::double_crank);
  EXPECT_EQ(linkage_type({7, 5, 2, 6}), LinkageType::double_rocker);
  EXPECT_EQ(linkage_type({9, 3, 5, 6}), LinkageType::triple_rocker_ground);
  EXPECT_EQ(linkage_type({3, 9, 5, 6}), LinkageType::triple_rocker_input);
  EXPECT_EQ(linkage_type({3, 5, 9, 6}), LinkageType::triple_rocker_coupler);
  EXPECT_EQ(linkage_type({3, 5, 6, 9}), LinkageType::triple_rocker_output);
  EXPECT_EQ(linkage_type({4, 2, 4, 2}), LinkageType::change_point);
  EXPECT_EQ(linkage_type({4, 2, 4, 0}), LinkageType::degenerate);
}

TEST(LinkageType, InputIsACrankExactlyWhereItsRangeIsAFullTurn) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> length(0.1, 1);
  for (int trial = 0; trial < 20'000; ++trial) {
    const LinkLengths l{length(random), length(random), length(random), length(random)};
    const LinkageType type = linkage_type(l);
    const auto ranges = input_ranges(l);
    const bool full_turn = ranges.size() == 1 && ranges[0].is_full_turn();
    ASSERT_NE(type, LinkageType::degenerate);
    if (type == LinkageType::change_point || ranges.empty()) continue;
    EXPECT_EQ(input_is_crank(type), full_turn);
  }
}

TEST(LinkageType, GrashofMeansShortestPlusLongestBelowTheOthers) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> length(0.1, 1);
  for (int trial = 0; trial < 20'000; ++trial) {
    const LinkLengths l{length(random), length(random), length(random), length(random)};
    const bool grashof = 2 * (l.shortest() + l.longest()) < l.perimeter();
    EXPECT_EQ(is_grashof(linkage_type(l)), grashof);
  }
}

TEST(LinkageType, SwappingTheDriverExchangesCrankRockerAndRockerCrank) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> length(0.1, 1);
  for (int trial = 0; trial < 5'000; ++trial) {
    const LinkLengths l{length(random), length(random), length(random), length(random)};
    EXPECT_EQ(linkage_type(l.swapped()), swapped(linkage_type(l)));
  }
}

TEST(LinkageType, ScaleDoesNotMatter) {
  for (const double scale : {1e-6, 1.0, 1e6}) {
    EXPECT_EQ(linkage_type({7 * scale, 2 * scale, 5 * scale, 6 * scale}), LinkageType::crank_rocker);
    EXPECT_EQ(linkage_type({4 * scale, 2 * scale, 4 * scale, 2 * scale}), LinkageType::change_point);
  }
}

TEST(LinkageType, NotANumberIsDegenerate) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(linkage_type({nan, 1, 1, 1}), LinkageType::degenerate);
  EXPECT_EQ(linkage_type({1, 1, infinity, 1}), LinkageType::degenerate);
}

TEST(LinkageType, NamesRoundTrip) {
  for (std::size_t i = 0; i < linkage_type_names.size(); ++i) {
    const auto type = static_cast<LinkageType>(i);
    EXPECT_EQ(linkage_type_named(name(type)), type);
  }
  EXPECT_FALSE(linkage_type_named("crank"));
}

TEST(ChangePointKind, BarkersSixKinds) {
  EXPECT_EQ(change_point_kind({6, 2, 5, 3}), ChangePointKind::crank_rocker);  // 2 + 6 = 5 + 3
  EXPECT_EQ(change_point_kind({6, 3, 5, 2}), ChangePointKind::rocker_crank);
  EXPECT_EQ(change_point_kind({2, 6, 3, 5}), ChangePointKind::double_crank);
  EXPECT_EQ(change_point_kind({6, 3, 2, 5}), ChangePointKind::double_rocker);
  EXPECT_EQ(change_point_kind({4, 2, 4, 2}), ChangePointKind::parallelogram_or_kite);
  EXPECT_EQ(change_point_kind({4, 4, 2, 2}), ChangePointKind::parallelogram_or_kite);
  EXPECT_EQ(change_point_kind({3, 3, 3, 3}), ChangePointKind::rhombus);
  EXPECT_EQ(change_point_kind({7, 2, 5, 6}), ChangePointKind::none);
}

}  // namespace
}  // namespace linkwright::linkage_type_test
