#include "linkwright/mechanism/defects.hpp"

#include <cmath>
#include <complex>
#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/position.hpp"
#include "mechanism/transmission_angle.hpp"
#include "support/random_four_bar.hpp"

namespace linkwright::defects_test {
namespace {

using testing::coupler_pose;
using testing::four_bar_at;
using testing::RandomFourBars;

struct Stop {
  double input_deg;
  Assembly assembly = Assembly::positive;
};

std::vector<PrescribedPose> poses_of(const LinkLengths& lengths, const std::vector<Stop>& stops) {
  std::vector<PrescribedPose> poses;
  for (const Stop& stop : stops)
    poses.push_back({coupler_pose(four_bar_at(lengths, radians(stop.input_deg), stop.assembly)), {}});
  return poses;
}

DefectReport report_of(const LinkLengths& lengths, const std::vector<Stop>& stops) {
  return find_defects(four_bar_at(lengths, radians(stops[0].input_deg), stops[0].assembly), poses_of(lengths, stops));
}

const LinkLengths crank_rocker{7, 2, 5, 6}, double_rocker{7, 5, 2, 6}, triple_rocker{3, 5, 9, 6};

TEST(FindDefects, CrankVisitsItsStopsInOrder) {
  const DefectReport up = report_of(crank_rocker, {{10}, {80}, {200}, {300}});
  EXPECT_EQ(up.type, LinkageType::crank_rocker);
  EXPECT_TRUE(up.defects.none());
  EXPECT_EQ(up.sense, DriveSense::ccw);
  EXPECT_NEAR(degrees(up.sweep), 290, 1e-9);
  const DefectReport down = report_of(crank_rocker, {{10}, {-80}, {-200}, {-300}});
  EXPECT_EQ(down.sense, DriveSense::cw);
  EXPECT_NEAR(degrees(down.sweep), 310 - 0, 1e-9);
}

TEST(FindDefects, ShuffledStopsAreAnOrderDefectOnly) {
  const DefectReport report = report_of(crank_rocker, {{10}, {200}, {80}, {300}});
  EXPECT_EQ(report.defects.bits, Defects::order_bit);
  EXPECT_EQ(report.sense, DriveSense::none);
  EXPECT_EQ(report.sweep, 0);
  EXPECT_EQ(report.min_transmission_angle, 0);
}

TEST(FindDefects, CrankMayPassTheStartOfItsTurn) {
  EXPECT_TRUE(report_of(crank_rocker, {{300}, {350}, {40}, {100}}).defects.none());
}

TEST(FindDefects, OtherAssemblyOfAGrashofLinkageIsAnotherCircuit) {
  const DefectReport report = report_of(crank_rocker, {{10}, {80, Assembly::negative}, {200}, {300}});
  EXPECT_EQ(report.defects.bits, Defects::branch_bit | Defects::circuit_bit);
}

TEST(FindDefects, OtherAssemblyOfATripleRockerIsAnotherBranch) {
  const double middle = degrees((input_ranges(triple_rocker)[0].from + input_ranges(triple_rocker)[0].to) / 2);
  const DefectReport report = report_of(triple_rocker, {{middle}, {middle + 10, Assembly::negative}, {middle + 20}});
  EXPECT_EQ(report.defects.bits, Defects::branch_bit);
}

TEST(FindDefects, RockerMustNotBeAskedToTurnOn) {
  // In cyclic order, yet a rocker cannot leave its arc: 2 → 3 would need a full turn.
  const auto range = input_ranges(double_rocker)[0];
  const double a = degrees(range.from), w = degrees(range.to - range.from);
  const DefectReport report = report_of(double_rocker, {{a + 0.4 * w}, {a + 0.7 * w}, {a + 0.1 * w}});
  EXPECT_EQ(report.defects.bits, Defects::order_bit);
}

TEST(FindDefects, ExactlyOneSenseForThreePosesAndBothForTwo) {
  EXPECT_EQ(report_of(crank_rocker, {{10}, {80}}).sense, DriveSense::either);
  EXPECT_EQ(report_of(crank_rocker, {{10}, {80}, {90}}).sense, DriveSense::ccw);
}

TEST(FindDefects, ParallelogramThatMustPassItsFlatStopsThere) {
  const LinkLengths parallelogram{4, 2, 4, 2};
  EXPECT_EQ(report_of(parallelogram, {{30}, {60}, {90}}).type, LinkageType::change_point);
  EXPECT_TRUE(report_of(parallelogram, {{30}, {60}, {90}}).defects.none());
  const auto across = report_of(parallelogram, {{-30, Assembly::negative}, {20}, {60}});
  EXPECT_TRUE(across.defects.branch());
}

TEST(FindDefects, DegenerateLinkagesHaveNoDefects) {
  const FourBar bars{{0, 0}, {0, 0}, {3, 0}, {3, 1}};
  const std::vector<PrescribedPose> poses = {{{{0, 0}, 0}, {}}, {{{1, 0}, 1}, {}}};
  const DefectReport report = find_defects(bars, poses);
  EXPECT_EQ(report.type, LinkageType::degenerate);
  EXPECT_TRUE(report.defects.none());
  EXPECT_EQ(report.sense, DriveSense::none);
}

TEST(FindDefects, TransmissionAngleIsTheLeastOfADenseDrive) {
  RandomFourBars random(21);
  int compared = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    const LinkLengths lengths = random.lengths();
    const double start = random.input_angle(lengths), sweep = random.uniform(-3, 3);
    const Assembly assembly = random.assembly();
    std::vector<PrescribedPose> poses;
    bool reachable = true;
    for (int i = 0; i < 4 && reachable; ++i) {
      reachable = assemble(lengths, start + sweep * i / 3, assembly).has_value();
      if (reachable) poses.push_back({coupler_pose(four_bar_at(lengths, start + sweep * i / 3, assembly)), {}});
    }
    if (!reachable) continue;
    const DefectReport report = find_defects(four_bar_at(lengths, start, assembly), poses);
    if (!report.defects.none() || report.type == LinkageType::change_point) continue;
    ++compared;
    EXPECT_EQ(report.sense, sweep > 0 ? DriveSense::ccw : DriveSense::cw);
    EXPECT_NEAR(report.sweep, std::abs(sweep), 1e-9);
    double least = pi;
    for (int i = 0; i <= 3000; ++i)
      if (const auto c = assemble(lengths, start + sweep * i / 3000, assembly))
        least = std::min(least, transmission_angle(lengths, *c));
    const double closed = report.min_transmission_angle;
    EXPECT_LE(closed, least + 1e-7);
    EXPECT_NEAR(closed, least, 2e-3);
  }
  EXPECT_GT(compared, 1000);
}

// Of the coupler and the output link at a pose, in more digits than find_defects has.
long double exact_angle(const FourBar& bars, const Pose& first, const Pose& pose) {
  using Long = std::complex<long double>;
  const auto longer = [](Point p) { return Long(p.real(), p.imag()); };
  const long double turned = static_cast<long double>(pose.angle) - first.angle;
  const Long turn(std::cos(turned), std::sin(turned));
  const auto at_pose = [&](Point p) { return longer(pose.origin) + turn * (longer(p) - longer(first.origin)); };
  const Long coupler = at_pose(bars.output_moving) - at_pose(bars.input_moving),
             output = at_pose(bars.output_moving) - longer(bars.output_fixed), product = coupler * std::conj(output);
  return std::atan2(std::abs(product.imag()), std::abs(product.real()));
}

// Cosines lose half of the digits of a small angle, and all of them where the links differ much in length.
TEST(FindDefects, TransmissionAngleKeepsItsDigitsNearADeadPointAndBetweenLongAndShortLinks) {
  RandomFourBars random(31);
  int compared = 0;
  long double smallest = 1;
  for (int i = 0; i < 4000; ++i) {
    LinkLengths lengths = random.lengths();
    const double size = std::pow(10, random.uniform(0, 4));
    const double difference = random.uniform(-1, 1) * (lengths.coupler + lengths.output);
    lengths.ground *= size;
    lengths.input = lengths.ground + difference;
    for (const AngleRange& range : input_ranges(lengths)) {
      const double width = range.to - range.from;
      if (range.is_full_turn() || width > 1.5) continue;
      const double end = range.to - width * std::pow(10, random.uniform(-9, -1)), start = (range.from + 3 * end) / 4;
      if (std::floor(start / pi) != std::floor(end / pi)) continue;  // less along the frame
      const auto at = [&](double angle) { return four_bar_at(lengths, angle, Assembly::positive); };
      const std::vector<PrescribedPose> poses = {{coupler_pose(at(start)), {}}, {coupler_pose(at(end)), {}}};
      const DefectReport report = find_defects(at(start), poses);
      if (!report.defects.none() || report.sweep > width) continue;
      const long double exact = std::min(exact_angle(at(start), poses[0].pose, poses[0].pose),
                                         exact_angle(at(start), poses[0].pose, poses[1].pose));
      ++compared;
      smallest = std::min(smallest, exact);
      EXPECT_NEAR(report.min_transmission_angle, static_cast<double>(exact), 4e-15 * size + 1e-14) << i;
    }
  }
  EXPECT_GT(compared, 300);
  EXPECT_LT(smallest, 1e-3);
}

TEST(FindDefects, FullTurnTransmissionAngleIsThatOfTheTurn) {
  RandomFourBars random(22);
  for (int trial = 0; trial < 2000; ++trial) {
    const LinkLengths lengths = random.lengths();
    const double start = random.input_angle(lengths);
    const FourBar bars = four_bar_at(lengths, start, Assembly::positive);
    const DefectReport report = find_defects(bars, std::vector<PrescribedPose>{{coupler_pose(bars), {}}});
    EXPECT_NEAR(report.min_transmission_angle_full_turn, least_transmission_angle_full_turn(lengths), 1e-6);
  }
}

TEST(DriveSense, HasNames) {
  EXPECT_EQ(name(drive_sense(true, false)), "ccw");
  EXPECT_EQ(name(drive_sense(false, true)), "cw");
  EXPECT_EQ(name(drive_sense(true, true)), "either");
  EXPECT_EQ(name(drive_sense(false, false)), "");
}

}  // namespace
}  // namespace linkwright::defects_test
