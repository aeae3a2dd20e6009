// What holds for the four-bars through any three poses, whatever else is given.

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "linkwright/core/angle.hpp"
#include "linkwright/synthesis/solve.hpp"
#include "support/random_task.hpp"
#include "support/solved.hpp"

namespace linkwright::three_poses_law_test {
namespace {

using testing::uniform;

SynthesisOptions small() {
  SynthesisOptions options;
  options.region_samples = 30;
  options.best = 1;
  return options;
}

MotionAnswer solved(const MotionTask& task) { return testing::solved(task, {}, small()); }

Point input_arm(const FourBar& bars) { return bars.input_circle - bars.input_center; }
Point output_arm(const FourBar& bars) { return bars.output_circle - bars.output_center; }

// What was given, seen in a linkage; user's frame.
void expect_kept(const SideLengths& given, const FourBarSolution& found) {
  EXPECT_NEAR(found.lengths.input / given.input, 1, 1e-9);
  EXPECT_NEAR(found.lengths.output / given.output.value_or(found.lengths.output), 1, 1e-9);
}

void expect_kept(const SideAngle& given, const FourBarSolution& found) {
  EXPECT_NEAR(found.lengths.input / given.input_length.value_or(found.lengths.input), 1, 1e-9);
  const double between = std::arg(output_arm(found.four_bar) / input_arm(found.four_bar));
  EXPECT_NEAR(std::remainder(between - given.angle, given.directed ? two_pi : pi), 0, 1e-9);
}

void expect_kept(const InstantCenter& given, const FourBarSolution& found) {
  for (const auto& [center, arm] : {std::pair{found.four_bar.input_center, input_arm(found.four_bar)},
                                    std::pair{found.four_bar.output_center, output_arm(found.four_bar)}}) {
    const Point ray = given.at_infinity ? given.point : given.point - center;
    EXPECT_NEAR(cross(arm / std::abs(arm), ray) / (1 + std::abs(ray)), 0, 1e-9);
  }
}

// Lengths as fit the poses of random_poses.
std::vector<ThreePoseGiven> givens(std::mt19937_64& random) {
  const double length = uniform(random, 1, 3), other = uniform(random, 1, 3), angle = uniform(random, -pi, pi);
  const Point center{uniform(random, -2, 2), uniform(random, -2, 2)};
  return {SideLengths{length, other},      SideLengths{length, {}},      SideAngle{angle, true, length},
          SideAngle{angle, false, length}, InstantCenter{center, false}, InstantCenter{center, true}};
}

ThreePoseGiven moved(const ThreePoseGiven& given, double scale, double angle, Point shift) {
  const Point turn = scale * direction(angle);
  if (const auto* lengths = std::get_if<SideLengths>(&given))
    return SideLengths{scale * lengths->input,
                       lengths->output ? std::optional(scale * *lengths->output) : std::nullopt};
  if (const auto* side = std::get_if<SideAngle>(&given))
    return SideAngle{side->angle, side->directed,
                     side->input_length ? std::optional(scale * *side->input_length) : std::nullopt};
  const auto& center = std::get<InstantCenter>(given);
  return InstantCenter{center.at_infinity ? turn * center.point : turn * center.point + shift, center.at_infinity};
}

TEST(ThreePosesLaw, LinkagesKeepWhatIsGivenAndAreDrivenThroughThePoses) {
  std::mt19937_64 random(1);
  std::array<int, 6> found{};
  for (int trial = 0; trial < 4; ++trial) {
    const auto poses = testing::random_poses(random, 3);
    const auto all = givens(random);
    for (std::size_t kind = 0; kind < all.size(); ++kind) {
      const MotionAnswer answer = solved({poses, all[kind]});
      EXPECT_EQ(answer.given.pattern, "P-P-P");
      for (const FourBarSolution& linkage : answer.linkages) {
        // Two grounded links on one ray from an instant centre are flat in position 1: a dead point there has no sign.
        if (linkage.report.type == LinkageType::change_point) continue;
        EXPECT_TRUE(linkage.verified_by_driving);
        EXPECT_LT(linkage.residual, 1e-9);
        std::visit([&](const auto& given) { expect_kept(given, linkage); }, all[kind]);
        ++found[kind];
      }
    }
  }
  for (const int count : found) EXPECT_GT(count, 1);
}

TEST(ThreePosesLaw, MixedPositionsAreTakenToo) {
  std::mt19937_64 random(3);
  int found = 0;
  for (int trial = 0; trial < 5; ++trial)
    for (const std::vector<int>& pattern : {std::vector<int>{2, 1}, {1, 2}, {3}}) {
      const auto poses = testing::random_poses(random, pattern);
      for (const ThreePoseGiven& given :
           {ThreePoseGiven{SideLengths{1.5, 2}}, ThreePoseGiven{SideAngle{0.6, false, 2}}})
        for (const FourBarSolution& linkage : solved({poses, given}).linkages) {
          EXPECT_TRUE(linkage.verified_by_driving);
          EXPECT_LT(linkage.residual, 1e-9);
          EXPECT_LT(linkage.residual_derivatives.value_or(1), 1e-9);
          ++found;
        }
    }
  EXPECT_GT(found, 15);
}

// Cells whose verdict rounding may turn.
constexpr std::int64_t borderline_cells = 8;

TEST(ThreePosesLaw, NeitherUnitNorPlaceMatters) {
  std::mt19937_64 random(5);
  for (int trial = 0; trial < 2; ++trial) {
    const auto poses = testing::random_poses(random, 3);
    for (const ThreePoseGiven& given : givens(random)) {
      const MotionAnswer before = solved({poses, given});
      const double scale = trial % 2 == 0 ? 1e-4 : 1e4, angle = uniform(random, -pi, pi);
      const Point shift = scale * Point{30, -20};
      const MotionAnswer after =
          solved({testing::moved(poses, scale, angle, shift), moved(given, scale, angle, shift)});
      EXPECT_EQ(before.status, after.status);
      EXPECT_NEAR(after.given.frame().scale / (scale * before.given.frame().scale), 1, 1e-9);
      // Axes of directions begin at the drawing's 0°, so that its turn moves the samples.
      if (!std::holds_alternative<InstantCenter>(given)) continue;
      for (std::size_t type = 0; type < before.counts.types.size(); ++type)
        EXPECT_LE(std::abs(before.counts.types[type] - after.counts.types[type]), borderline_cells);
      EXPECT_LE(std::abs(before.counts.defect_free - after.counts.defect_free), borderline_cells);
    }
  }
}

TEST(ThreePosesLaw, BothLengthsTheOtherWayRoundAreTheSameBarsDrivenFromTheOtherSide) {
  std::mt19937_64 random(6);
  for (int trial = 0; trial < 3; ++trial) {
    const auto poses = testing::random_poses(random, 3);
    const MotionAnswer here = solved({poses, SideLengths{1.5, 2.5}}), there = solved({poses, SideLengths{2.5, 1.5}});
    const auto of = [](const MotionAnswer& answer, LinkageType type) {
      return answer.counts.types[static_cast<std::size_t>(type)];
    };
    for (const auto& [type, other] : {std::pair{LinkageType::crank_rocker, LinkageType::rocker_crank},
                                      std::pair{LinkageType::double_crank, LinkageType::double_crank},
                                      std::pair{LinkageType::double_rocker, LinkageType::double_rocker}})
      EXPECT_EQ(of(here, type), of(there, other));
    EXPECT_EQ(here.counts.circuit, there.counts.circuit);
  }
}

}  // namespace
}  // namespace linkwright::three_poses_law_test
