#include "linkwright/files/position_error.hpp"

#include <array>
#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/files/csv_table.hpp"

namespace linkwright::position_error_test {
namespace {

/// Pivots rounded to whole units: as it moves it passes none of its poses but the first.
StoredLinkage rounded() {
  StoredLinkage linkage{{{21, 7}, {12, -1}, {9, 19}, {-2, 8}}, "", "mm", {}, ""};
  const std::array<std::array<double, 3>, 4> poses = {{{8.4, 10.4, 0},
                                                       {15.75307999925125, 6.635448633158675, 1.6616734751610893},
                                                       {22.17995730186216, 14.34686035802784, 43.4681702286939},
                                                       {12.61818756779844, 15.25966971714668, -270.3228804174674}}};
  for (const auto& [x, y, theta] : poses) linkage.poses.push_back({{{x, y}, radians(theta)}, {}});
  return linkage;
}

TEST(PositionError, OfRoundedPivotsIsTold) {
  const StoredLinkage linkage = rounded();
  const auto errors = position_errors(linkage);
  ASSERT_EQ(errors.size(), 3u);
  for (const auto& [position, error] : errors) {
    ASSERT_TRUE(error) << position;
    EXPECT_GT(error->distance + error->angle, 0.01) << position;
    EXPECT_LT(error->distance, 0.4) << position;
    EXPECT_LT(degrees(error->angle), 3) << position;
  }
  const std::string words = position_error_words(linkage);
  EXPECT_EQ(words.find("as it moves the linkage misses position 2 by "), 0u) << words;
  EXPECT_NE(words.find(" mm and "), std::string::npos);
}

TEST(PositionError, IsThatOfRowsWhoseLinksKeepTheirLengths) {
  const StoredLinkage linkage = rounded();
  const LinkLengths lengths = linkage.four_bar.lengths();
  int positions = 0;
  for (const CycleState& state : tabulated_cycle(linkage)) {
    positions += state.pose >= 0;
    const LinkLengths there = state.four_bar.lengths();
    EXPECT_NEAR(there.input, lengths.input, 1e-9);
    EXPECT_NEAR(there.coupler, lengths.coupler, 1e-9);
    EXPECT_NEAR(there.output, lengths.output, 1e-9);
  }
  EXPECT_EQ(positions, 4);
}

TEST(PositionError, IsNothingWithoutPositions) {
  StoredLinkage linkage = rounded();
  linkage.poses.resize(1);
  EXPECT_TRUE(position_errors(linkage).empty());
  EXPECT_EQ(position_error_words(linkage), "");
}

TEST(PositionError, OfAPoseOnAnotherCircuitIsNone) {
  StoredLinkage linkage{{{0, 0}, {0, 2}, {4, 0}, {3, 3.5}}, "", "", {}, ""};
  const LinkLengths lengths = linkage.four_bar.lengths();
  const Configuration start = configuration_of(linkage.four_bar);
  const auto other = assemble(lengths, start.input_angle + 0.4, Assembly::negative);
  linkage.poses = {{{{0, 2}, 0}, {}},
                   {{placed(linkage.four_bar, *other).input_moving, other->coupler_angle - start.coupler_angle}, {}}};
  const auto errors = position_errors(linkage);
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_FALSE(errors[0].error);
  EXPECT_EQ(position_error_words(linkage), "as it moves the linkage does not come to position 2");
}

}  // namespace
}  // namespace linkwright::position_error_test
