#include "approximate/coupler_circuit.hpp"

#include <algorithm>
#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/coupler_curve.hpp"
#include "linkwright/mechanism/drive_through.hpp"
#include "linkwright/mechanism/four_bar_analysis.hpp"
#include "linkwright/mechanism/linkage_type.hpp"
#include "support/random_four_bar.hpp"

namespace linkwright::coupler_circuit_test {
namespace {

struct Motion {
  CouplerLinkage linkage;
  FourBar bars;
  std::vector<LoopState> states;
  std::vector<Point> points;
};

LoopState state_of(const FourBar& bars) {
  const LinkLengths lengths = bars.lengths();
  return {(bars.input_moving - bars.input_fixed) / lengths.input,
          (bars.output_moving - bars.input_moving) / lengths.coupler};
}

// States of a whole cycle, by the tree's own motion.
Motion drawn_motion(testing::RandomFourBars& draw, int count) {
  Motion m;
  do {
    m.bars = draw.four_bar();
  } while (change_point_margin(m.bars.lengths()) < 0.02);
  const LinkLengths lengths = m.bars.lengths();
  const Point p{draw.uniform(-1, 1), draw.uniform(-1, 1)};
  m.linkage = {m.bars.input_fixed, m.bars.output_fixed, lengths.input, lengths.coupler, lengths.output, p};
  for (const MotionState& at : motion_cycle(m.bars, traced_point(m.linkage, state_of(m.bars)), count)) {
    m.states.push_back(state_of(at.four_bar));
    m.points.push_back(at.coupler_point);
  }
  m.states.pop_back();  // the first again
  m.points.pop_back();
  return m;
}

TEST(CouplerCircuit, IsTheCycleOfTheMotion) {
  testing::RandomFourBars draw(1);
  for (int k = 0; k < 200; ++k) {
    const Motion m = drawn_motion(draw, 40);
    const CircuitDrive drive = drive_along_circuit(m.linkage, m.states, m.points, true, 1e-9);
    EXPECT_TRUE(drive.one_circuit) << k;
    EXPECT_TRUE(drive.in_order) << k;
    const LinkageType type = linkage_type(m.bars.lengths());
    EXPECT_EQ(drive.of(CurveDriver::e).no_dead_point, input_is_crank(type)) << k;
    EXPECT_EQ(drive.of(CurveDriver::e).full_turn, input_is_crank(type)) << k;
    EXPECT_EQ(drive.of(CurveDriver::g).full_turn, input_is_crank(swapped(type))) << k;
    if (!input_is_crank(type)) continue;
    EXPECT_NEAR(std::asin(drive.of(CurveDriver::e).min_sine),
                analyze(m.bars, m.points[0]).min_transmission_angle_full_turn, 0.02);
  }
}

TEST(CouplerCircuit, SeesStatesOutOfOrder) {
  testing::RandomFourBars draw(2);
  for (int k = 0; k < 100; ++k) {
    Motion m = drawn_motion(draw, 12);
    std::swap(m.states[3], m.states[7]);
    std::swap(m.points[3], m.points[7]);
    const CircuitDrive drive = drive_along_circuit(m.linkage, m.states, m.points, true, 1e-9);
    EXPECT_TRUE(drive.one_circuit) << k;
    EXPECT_FALSE(drive.in_order) << k;
  }
}

TEST(CouplerCircuit, TakesGoingBackForNoiseUpToAllOfItTogether) {
  testing::RandomFourBars draw(5);
  for (int k = 0; k < 100; ++k) {
    const Motion m = drawn_motion(draw, 400);
    const auto drive_to = [&](const std::vector<std::size_t>& picked, double noise) {
      std::vector<LoopState> states;
      std::vector<Point> points;
      for (const std::size_t j : picked) {
        states.push_back(m.states[j]);
        points.push_back(m.points[j]);
      }
      return drive_along_circuit(m.linkage, states, points, false, noise);
    };
    std::vector<std::size_t> to_and_fro;
    double step = 0, back = 0;
    for (std::size_t j = 0; j <= 100; ++j) to_and_fro.push_back(j);
    for (std::size_t j = 100; j-- > 0;) {
      const double side = std::abs(m.points[j + 1] - m.points[j]);
      step = std::max(step, side);
      back += side;
      to_and_fro.push_back(j);
    }
    if (3 * step > 0.5 * back) continue;
    EXPECT_FALSE(drive_to(to_and_fro, 3 * step).in_order)
        << k << ": each step back is within the noise, together they are not";
    const CircuitDrive noisy = drive_to({0, 10, 12, 11, 10, 20, 40}, 3 * step);
    EXPECT_TRUE(noisy.in_order) << k;
    const CircuitDrive straight = drive_to({0, 10, 20, 40}, 3 * step);
    const auto side = [&](std::size_t a, std::size_t b) { return std::abs(m.points[a] - m.points[b]); };
    const double polygon = side(0, 10) + side(10, 20) + side(20, 40);
    const double to_and_back = side(10, 12) + side(12, 11) + side(11, 10);
    EXPECT_NEAR(noisy.path_length_ratio * (polygon + to_and_back), straight.path_length_ratio * polygon, 1e-9 * polygon)
        << "the path is as long whatever the points do";
  }
}

TEST(CouplerCircuit, CountsTurnsOnBetweenSparseStates) {
  testing::RandomFourBars draw(6);
  int tried = 0;
  while (tried < 50) {
    const Motion m = drawn_motion(draw, 360);
    if (!input_is_crank(linkage_type(m.bars.lengths()))) continue;
    ++tried;
    std::vector<LoopState> states;
    std::vector<Point> points;
    for (const std::size_t j : {0, 20, 250, 300}) {
      states.push_back(m.states[j]);
      points.push_back(m.points[j]);
    }
    const std::vector<double> turns =
        drive_along_circuit(m.linkage, states, points, true, 1e-9).of(CurveDriver::e).turns;
    ASSERT_EQ(turns.size(), 5u);
    const double sense = turns[1] > 0 ? 1 : -1;
    for (std::size_t k = 0; k + 1 < turns.size(); ++k) EXPECT_GT(sense * (turns[k + 1] - turns[k]), 0) << tried;
    EXPECT_NEAR(sense * turns[4], two_pi, 0.03) << tried;
    EXPECT_GT(sense * (turns[2] - turns[1]), pi / 2) << tried;
  }
}

TEST(CouplerCircuit, SeesAStateOnTheOtherCircuit) {
  testing::RandomFourBars draw(3);
  int tried = 0;
  while (tried < 100) {
    Motion m = drawn_motion(draw, 12);
    if (!is_grashof(linkage_type(m.bars.lengths()))) continue;
    ++tried;
    // Mirrored at the ground link the same input has the coupler on the other side.
    const Point ground = (m.linkage.b0 - m.linkage.a0) / std::abs(m.linkage.b0 - m.linkage.a0);
    const auto mirrored = [&](Point v) { return ground * ground * std::conj(v); };
    m.states[5] = {mirrored(m.states[5].e), mirrored(m.states[5].u)};
    EXPECT_FALSE(drive_along_circuit(m.linkage, m.states, m.points, true, 1e-9).one_circuit) << tried;
  }
}

TEST(CouplerCircuit, AgreesWithTheDriveThroughPoses) {
  testing::RandomFourBars draw(4);
  int with = 0, without = 0;
  for (int k = 0; k < 150; ++k) {
    const Motion m = drawn_motion(draw, 60);
    std::vector<std::size_t> picked;
    while (picked.size() < 4) {
      const auto j = static_cast<std::size_t>(draw.below(static_cast<int>(m.states.size())));
      if (std::find(picked.begin(), picked.end(), j) == picked.end()) picked.push_back(j);
    }
    std::vector<LoopState> states;
    std::vector<Point> points;
    std::vector<PrescribedPose> poses;
    for (const std::size_t j : picked) {
      states.push_back(m.states[j]);
      points.push_back(m.points[j]);
      poses.push_back({{m.linkage.a0 + m.linkage.a * m.states[j].e, std::arg(m.states[j].u)}, {}});
    }
    const FourBar first = placed(m.linkage, states.front()).bars;
    const DriveThroughReport report = drive_through(first, poses);
    if (!report.completed) continue;
    const CircuitDrive drive = drive_along_circuit(m.linkage, states, points, false, 0);
    const bool can = drive.in_order && drive.of(CurveDriver::e).no_dead_point;
    EXPECT_EQ(can, report.defects.none()) << k;
    ++(can ? with : without);
  }
  EXPECT_GT(with, 10);
  EXPECT_GT(without, 10);
}

}  // namespace
}  // namespace linkwright::coupler_circuit_test
