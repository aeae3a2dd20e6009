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
