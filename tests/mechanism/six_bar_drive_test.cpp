#include "linkwright/mechanism/six_bar_drive.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/drive_through.hpp"
#include "linkwright/mechanism/six_bar_check.hpp"
#include "linkwright/planar/six_bar_solution.hpp"
#include "support/random_six_bar.hpp"
#include "support/random_task.hpp"

namespace linkwright::six_bar_drive_test {
namespace {

using testing::RandomSixBar;

/// Senses in which dense steps of the driver meet all poses in order: bits 1 ccw, 2 cw.
int senses_by_dense_steps(const RandomSixBar& given) {
  int senses = 0;
  for (const int sense : {+1, -1}) {
    const SixBarCheck check = check_by_driving(given.member.six_bar, given.task.poses, sense);
    EXPECT_LT(check.worst_length, 1e-8);
    if (check.visited == std::vector<int>{1, 2, 3}) senses |= sense > 0 ? 1 : 2;
  }
  return senses;
}

int bits_of(DriveSense sense) {
  return (sense == DriveSense::ccw || sense == DriveSense::either ? 1 : 0) |
         (sense == DriveSense::cw || sense == DriveSense::either ? 2 : 0);
}

/// Too near a dead point for steps of the driver to tell on which side of it a pose lies.
bool is_borderline(const SixBarMember& member) {
  constexpr double half_a_degree = 0.01;
  const auto sine = sine_upper_bound(member.six_bar, member.turns);
  const double measure = six_bar_transmission(member.six_bar, member.turns[0]).dyadic ? 1 : 10;
  return sine && *sine < half_a_degree * measure;
}

TEST(SixBarDrive, AgreesWithDenseStepsOfTheHinges) {
  std::mt19937_64 random(31);
  int free_ones = 0, others = 0;
  for (const SixBarRow& row : six_bar_rows())
    for (int i = 0; i < 24; ++i) {
      const RandomSixBar given = testing::random_six_bar(random, row);
      if (is_borderline(given.member)) continue;
      SixBarDriveOptions options;
      options.circuits = false;
      const SixBarDriveReport report = drive_six_bar(given.member.six_bar, given.member.turns, options);
      EXPECT_TRUE(report.completed);
      EXPECT_EQ(bits_of(report.sense), senses_by_dense_steps(given))
          << text(row.added[0]) << " " << text(row.added[1]) << " " << i << ", sine " << report.min_sine;
      ++(report.defects.none() ? free_ones : others);
    }
  EXPECT_GT(free_ones, 20);
  EXPECT_GT(others, 100);
}

/// Position 1 and so many others of a six-bar without defects on its way to the last one; `count` divides 600.
std::vector<SixBarTurns> positions_on_the_way(const SixBarMember& member, int count) {
  constexpr int steps = 600;
  const SixBarDriveReport report = drive_six_bar(member.six_bar, member.turns);
  std::vector<SixBarTurns> positions = {member.turns[0]};
  SixBarTurns turns = positions.front();
  for (int i = 1; i <= steps; ++i) {
    turns[SixBar::driver] = direction((report.sense == DriveSense::cw ? -1 : 1) * report.sweep * i / steps);
    turns = closed(member.six_bar, turns).value();
    if (i % (steps / count) == 0) positions.push_back(turns);
  }
  return positions;
}

TEST(SixBarDrive, HundredsOfPositionsAndFewAreJudgedWhereDrivingGivesUp) {
  std::mt19937_64 random(35);
  SixBarDriveOptions impatient;
  impatient.circuits = false;
  impatient.max_steps = 1;
  int judged = 0;
  for (int i = 0; i < 40; ++i) {
    const SixBarMember member = testing::random_six_bar(random, six_bar_rows()[0]).member;
    const SixBarDriveReport all = drive_six_bar(member.six_bar, member.turns);
    if (!all.defects.none() || all.min_sine < 0.05) continue;
    for (const int count : {1, 2, 3, 600}) {
      const std::vector<SixBarTurns> wanted = positions_on_the_way(member, count);
      const SixBarDriveReport report = drive_six_bar(member.six_bar, wanted, impatient);
      if (!report.completed) continue;
      ++judged;
      EXPECT_TRUE(report.defects.none()) << count;
    }
  }
  EXPECT_GT(judged, 3);
}

TEST(SixBarDrive, PositionsThatDoNotCloseAreNotJudged) {
  std::mt19937_64 random(36);
  for (int i = 0; i < 40; ++i) {
    SixBarMember member = testing::random_six_bar(random, six_bar_rows()[0]).member;
    if (!drive_six_bar(member.six_bar, member.turns).defects.none()) continue;
    for (std::size_t j = 0; j < member.turns.size(); ++j) member.turns[j][5] *= direction(0.02);
    EXPECT_FALSE(drive_six_bar(member.six_bar, member.turns).defects.none());
  }
}

TEST(SixBarDrive, ExactStepsSayTheSame) {
  std::mt19937_64 random(32);
  for (const SixBarRow& row : six_bar_rows())
    for (int i = 0; i < 10; ++i) {
      const auto [task, member] = testing::random_six_bar(random, row);
      SixBarDriveOptions quick, exact;
      quick.circuits = exact.circuits = false;
      exact.exact_steps = true;
      const SixBarDriveReport one = drive_six_bar(member.six_bar, member.turns, quick),
                              other = drive_six_bar(member.six_bar, member.turns, exact);
      EXPECT_EQ(one.defects, other.defects);
      EXPECT_EQ(one.sense, other.sense);
      EXPECT_NEAR(one.min_sine, other.min_sine, 2e-3);
      EXPECT_NEAR(one.sweep, other.sweep, 1e-9);
    }
}

TEST(SixBarDrive, DyadsKeepTheSignsOfTheirJointsWhereThereIsNoBranchDefect) {
  std::mt19937_64 random(33);
  int dyadic = 0;
  for (const SixBarRow& row : six_bar_rows())
    for (int i = 0; i < 10; ++i) {
      const RandomSixBar given = testing::random_six_bar(random, row);
      const auto first = six_bar_transmission(given.member.six_bar, given.member.turns[0]);
      if (!first.dyadic || senses_by_dense_steps(given) == 0) continue;
      ++dyadic;
      for (const SixBarTurns& turns : given.member.turns)
        EXPECT_EQ(six_bar_transmission(given.member.six_bar, turns).joint_positive, first.joint_positive);
    }
  EXPECT_GT(dyadic, 5);
}

/// A four-bar with its coupler's dyad to the ground added so far away that it never matters: circuits are the
/// four-bar's.
struct FourBarInSixBar {
  SixBar six_bar;
  FourBar four_bar;
};

TEST(SixBarDrive, TellsCircuitsAsTheFourBarInItDoes) {
  // Crank-rocker 0-1-2-4; links 3 and 5 are a dyad from the coupler's end, long enough never to stretch.
  const Point a{0, 0}, b{0, 1}, c4{4, 0};
  const double coupler = 4, output = 2.5;
  const Point d_local{2, 0.5};
  const auto coupler_end = [&](Point pin, int side) {
    const double reach = std::abs(c4 - pin);
    const double along = (reach * reach + coupler * coupler - output * output) / (2 * reach);
    return pin + (c4 - pin) / reach * Point{along, side * std::sqrt(coupler * coupler - along * along)};
  };
  const Point c5{2, -20};
  const double l3 = 15, l5 = 12;
  const auto configuration = [&](double angle, int side, int second) {
    const Point pin = a + direction(angle), z4 = coupler_end(pin, side);
    const Point d = pin + (z4 - pin) / coupler * d_local;
    const double reach = std::abs(c5 - d), along = (reach * reach + l3 * l3 - l5 * l5) / (2 * reach);
    const Point z5 = d + (c5 - d) / reach * Point{along, second * std::sqrt(l3 * l3 - along * along)};
    return std::array<Point, 4>{pin, d, z4, z5};
  };
  const auto first = configuration(pi / 2, +1, +1);
  const SixBar six_bar = SixBar::of({a, b, first[1]}, {BodyPair{0, 2}, BodyPair{0, 3}}, {c4, first[2]}, {c5, first[3]});
  const auto turns = [&](double angle, int side, int second) -> SixBarTurns {
    const auto p = configuration(angle, side, second);
    return {Point{1},
            p[0] / first[0],
            (p[2] - p[0]) / (first[2] - first[0]),
            (p[3] - p[1]) / (first[3] - first[1]),
            (p[2] - c4) / (first[2] - c4),
            (p[3] - c5) / (first[3] - c5)};
  };
  const auto verdict = [&](const std::vector<SixBarTurns>& wanted) { return drive_six_bar(six_bar, wanted); };
  const auto straight = verdict({turns(pi / 2, 1, 1), turns(2, 1, 1), turns(3, 1, 1), turns(6.5, 1, 1)});
  EXPECT_TRUE(straight.completed);
  EXPECT_TRUE(straight.defects.none());
  EXPECT_EQ(straight.sense, DriveSense::ccw);
  EXPECT_NEAR(straight.sweep, 6.5 - pi / 2, 1e-9);
  const auto back = verdict({turns(pi / 2, 1, 1), turns(1, 1, 1), turns(-1, 1, 1), turns(-2, 1, 1)});
  EXPECT_EQ(back.sense, DriveSense::cw);
  EXPECT_NEAR(back.sweep, pi / 2 + 2, 1e-9);
  const auto muddled = verdict({turns(pi / 2, 1, 1), turns(3, 1, 1), turns(2, 1, 1), turns(6, 1, 1)});
  EXPECT_EQ(muddled.defects.bits, Defects::order_bit);
  const unsigned circuit = Defects::circuit_bit | Defects::branch_bit;
  EXPECT_EQ(verdict({turns(pi / 2, 1, 1), turns(2, -1, 1), turns(3, 1, 1), turns(6, 1, 1)}).defects.bits, circuit);
  EXPECT_EQ(verdict({turns(pi / 2, 1, 1), turns(2, 1, -1), turns(3, 1, 1), turns(6, 1, 1)}).defects.bits, circuit);
}

TEST(SixBarDrive, FindsABranchOnTheSameCircuitBeyondADeadPoint) {
  // A triple rocker has one circuit: both assemblies of its coupler and output link.
  std::mt19937_64 random(34);
  int same_circuit = 0, other_circuit = 0;
  for (int i = 0; i < 60 && (same_circuit < 3 || other_circuit < 3); ++i) {
    const RandomSixBar given = testing::random_six_bar(random, six_bar_rows()[static_cast<std::size_t>(i) % 11]);
    const SixBarDriveReport report = drive_six_bar(given.member.six_bar, given.member.turns);
    if (!report.completed || !report.defects.branch()) continue;
    SixBarDriveOptions without;
    without.circuits = false;
    EXPECT_EQ(drive_six_bar(given.member.six_bar, given.member.turns, without).defects.bits, Defects::branch_bit);
    ++(report.defects.circuit() ? other_circuit : same_circuit);
  }
  EXPECT_GE(same_circuit, 3);
  EXPECT_GE(other_circuit, 3);
}

TEST(SixBarDrive, HasNoVerdictOverNothing) {
  EXPECT_FALSE(drive_six_bar({}, {}).completed);
  const std::array<SixBarTurns, 2> wanted{};
  EXPECT_FALSE(drive_six_bar({}, wanted).completed);
}

}  // namespace
}  // namespace linkwright::six_bar_drive_test
