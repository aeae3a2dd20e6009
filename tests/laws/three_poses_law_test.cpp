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

Point input_arm(const FourBar& bars) { return bars.input_moving - bars.input_fixed; }
Point output_arm(const FourBar& bars) { return bars.output_moving - bars.output_fixed; }

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
  for (const auto& [center, arm] : {std::pair{found.four_bar.input_fixed, input_arm(found.four_bar)},
                                    std::pair{found.four_bar.output_fixed, output_arm(found.four_bar)}}) {
    const Point ray = given.at_infinity ? given.point : given.point - center;
    EXPECT_NEAR(cross(arm / std::abs(arm), ray) / (1 + std::abs(ray)), 0, 1e-9);
  }
}

void expect_at(const std::optional<GivenPivot>& given, Point center, Point circle) {
  if (!given) return;
  const Point found = given->kind == PivotKind::ground ? center : circle;
  EXPECT_LT(std::abs(found - given->point), 1e-9 * (1 + std::abs(given->point)));
}

void expect_kept(const GivenPivots& given, const FourBarSolution& found) {
  expect_at(given.input, found.four_bar.input_fixed, found.four_bar.input_moving);
  expect_at(given.output, found.four_bar.output_fixed, found.four_bar.output_moving);
}

void expect_on(const std::optional<LineAtAngle>& line, Point pivot) {
  if (line) {
    EXPECT_NEAR(line->to_line(pivot).imag(), 0, 1e-9 * (1 + std::abs(pivot)));
  }
}

void expect_kept(const PivotLines& given, const FourBarSolution& found) {
  for (const Point pivot : {found.four_bar.input_fixed, found.four_bar.output_fixed}) expect_on(given.ground, pivot);
  for (const Point pivot : {found.four_bar.input_moving, found.four_bar.output_moving}) expect_on(given.moving, pivot);
}

GivenPivot drawn_pivot(std::mt19937_64& random, PivotKind kind) {
  return {kind, {uniform(random, -2, 2), uniform(random, -2, 2)}};
}

LineAtAngle drawn_line(std::mt19937_64& random) {
  return {Point{uniform(random, -1, 1), uniform(random, -1, 1)}, uniform(random, -pi, pi)};
}

// One link's pivot of either kind, or one of each link.
std::vector<ThreePoseGiven> given_pivots(std::mt19937_64& random) {
  constexpr PivotKind ground = PivotKind::ground, moving = PivotKind::moving;
  std::vector<ThreePoseGiven> all;
  for (const PivotKind kind : {ground, moving}) {
    all.emplace_back(GivenPivots{drawn_pivot(random, kind), {}});
    all.emplace_back(GivenPivots{{}, drawn_pivot(random, kind)});
  }
  all.emplace_back(PivotLines{drawn_line(random), {}});
  all.emplace_back(PivotLines{{}, drawn_line(random)});
  return all;
}

// Of those each task has one linkage, or two dyads, if any.
std::vector<ThreePoseGiven> given_all(std::mt19937_64& random) {
  constexpr PivotKind ground = PivotKind::ground, moving = PivotKind::moving;
  return {GivenPivots{drawn_pivot(random, ground), drawn_pivot(random, ground)},
          GivenPivots{drawn_pivot(random, moving), drawn_pivot(random, moving)},
          GivenPivots{drawn_pivot(random, moving), drawn_pivot(random, ground)},
          PivotLines{drawn_line(random), drawn_line(random)}};
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
  const auto place = [&](Point p) { return turn * p + shift; };
  const auto line = [&](const std::optional<LineAtAngle>& of) {
    return of ? std::optional(LineAtAngle(place(of->point), of->angle + angle)) : std::nullopt;
  };
  if (const auto* lines = std::get_if<PivotLines>(&given)) return PivotLines{line(lines->ground), line(lines->moving)};
  if (const auto* pivots = std::get_if<GivenPivots>(&given)) {
    GivenPivots there = *pivots;
    for (auto* pivot : {&there.input, &there.output})
      if (*pivot) (*pivot)->point = place((*pivot)->point);
    return there;
  }
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

TEST(ThreePosesLaw, GivenPivotsAreKeptAndTheirLinkagesAreDrivenThroughThePositions) {
  std::mt19937_64 random(21);
  std::array<int, 6> found{};
  int mixed = 0;
  for (int trial = 0; trial < 6; ++trial)
    for (const std::vector<int>& pattern : {std::vector<int>{1, 1, 1}, {2, 1}, {1, 2}, {3}}) {
      const auto poses = testing::random_poses(random, pattern);
      const auto all = given_pivots(random);
      for (std::size_t kind = 0; kind < all.size(); ++kind)
        for (const FourBarSolution& linkage : solved({poses, all[kind]}).linkages) {
          EXPECT_TRUE(linkage.verified_by_driving);
          EXPECT_LT(linkage.residual, 1e-9);
          std::visit([&](const auto& given) { expect_kept(given, linkage); }, all[kind]);
          ++found[kind];
          mixed += pattern.size() < 3;
          if (pattern.size() < 3) {
            EXPECT_LT(linkage.residual_derivatives.value_or(1), 1e-9);
          }
        }
    }
  for (const int count : found) EXPECT_GT(count, 5);
  EXPECT_GT(mixed, 40);
}

TEST(ThreePosesLaw, WhatIsWhollyGivenHasItsOneLinkage) {
  std::mt19937_64 random(22);
  std::array<int, 4> found{};
  Requirements any;
  any.no_defects = false;
  any.max_link_ratio = Requirements::unlimited;
  any.max_length = Requirements::unlimited;
  any.min_length = any.min_link_angle = 0;
  for (int trial = 0; trial < 10; ++trial)
    for (const std::vector<int>& pattern : {std::vector<int>{1, 1, 1}, {2, 1}, {1, 2}, {3}}) {
      const auto poses = testing::random_poses(random, pattern);
      const auto all = given_all(random);
      for (std::size_t kind = 0; kind < all.size(); ++kind) {
        const MotionAnswer answer = testing::solved(MotionTask{poses, all[kind]}, any, small());
        if (kind < 3) {
          EXPECT_EQ(answer.counts.pairs, 1);
        }
        for (const FourBarSolution& linkage : answer.linkages) {
          EXPECT_LT(linkage.residual, 1e-8);
          if (linkage.report.defects.none()) {
            EXPECT_TRUE(linkage.verified_by_driving);
          }
          std::visit([&](const auto& given) { expect_kept(given, linkage); }, all[kind]);
          ++found[kind];
        }
      }
    }
  for (std::size_t kind = 0; kind < 3; ++kind) EXPECT_GT(found[kind], 35);
  EXPECT_GT(found[3], 10);
}

TEST(ThreePosesLaw, NeitherUnitNorPlaceMattersToGivenPivots) {
  std::mt19937_64 random(23);
  for (int trial = 0; trial < 4; ++trial) {
    const auto poses = testing::random_poses(random, 3);
    const double scale = trial % 2 == 0 ? 1e-4 : 1e4, angle = trial < 2 ? 0 : uniform(random, -pi, pi);
    const Point shift = scale * Point{30, -20};
    auto all = given_pivots(random);
    for (ThreePoseGiven& given : given_all(random)) all.push_back(given);
    for (const ThreePoseGiven& given : all) {
      const MotionAnswer before = solved({poses, given});
      const MotionAnswer after =
          solved({testing::moved(poses, scale, angle, shift), moved(given, scale, angle, shift)});
      EXPECT_EQ(before.status, after.status);
      // Maps of the plane have their axes along the drawing's, which a turn of it does not take with it.
      const auto* pivots = std::get_if<GivenPivots>(&given);
      if (angle != 0 && pivots && !(pivots->input && pivots->output)) continue;
      for (std::size_t type = 0; type < before.counts.types.size(); ++type)
        EXPECT_LE(std::abs(before.counts.types[type] - after.counts.types[type]), borderline_cells);
      EXPECT_LE(std::abs(before.counts.defect_free - after.counts.defect_free), borderline_cells);
    }
  }
}

}  // namespace
}  // namespace linkwright::three_poses_law_test
