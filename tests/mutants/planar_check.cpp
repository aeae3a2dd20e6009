// Judges one build of find_defects by what shares nothing with it: driving, the type from the lengths, a dense sweep.
// Prints the number of disagreements; exits with 1 when there are any. mutants.py builds it with wrong
// signs.

#include <cmath>
#include <cstdio>
#include <random>

#include "linkwright/mechanism/defects.hpp"
#include "linkwright/mechanism/drive_through.hpp"
#include "linkwright/mechanism/position.hpp"
#include "mechanism/transmission_angle.hpp"
#include "support/random_four_bar.hpp"

namespace linkwright {
namespace {

using testing::RandomFourBars;

struct Trial {
  FourBar bars;
  std::vector<PrescribedPose> poses;
};

// A wrong sign may hide while the frame lies along an axis.
void turn_drawing(Trial& trial, double angle, Point shift) {
  FourBar& bars = trial.bars;
  for (Point* pivot : {&bars.input_fixed, &bars.input_moving, &bars.output_fixed, &bars.output_moving})
    *pivot = direction(angle) * *pivot + shift;
  for (PrescribedPose& pose : trial.poses) {
    pose.pose.origin = direction(angle) * pose.pose.origin + shift;
    pose.pose.angle += angle;
  }
}

// Poses that a linkage passes, in or out of order, on one assembly or on both.
Trial random_trial(RandomFourBars& random) {
  const LinkLengths lengths = random.lengths();
  const int kind = random.below(3);
  const Assembly assembly = random.assembly();
  const double start = random.input_angle(lengths), step = random.uniform(-1, 1);
  Trial trial;
  for (int i = 0; i < 4; ++i) {
    const double angle = kind == 0 ? start + i * step : i == 0 ? start : random.input_angle(lengths);
    const Assembly here = kind == 2 && i > 0 ? random.assembly() : assembly;
    if (!assemble(lengths, angle, here)) continue;
    const FourBar at = testing::four_bar_at(lengths, angle, here);
    if (trial.poses.empty()) trial.bars = at;
    trial.poses.push_back({testing::coupler_pose(at), {}});
  }
  turn_drawing(trial, random.uniform(-3, 3), {random.uniform(-2, 2), random.uniform(-2, 2)});
  return trial;
}

// What a clean report promises: the sweep ends at the last pose, and the angle on the way.
bool sweep_agrees(const Trial& trial, const DefectReport& report) {
  const LinkLengths lengths = trial.bars.lengths();
  const double start = configuration_of(trial.bars).input_angle;
  const double sweep = report.sense == DriveSense::cw ? -report.sweep : report.sweep;
  const auto end = assemble(lengths, start + sweep, assembly_of(trial.bars));
  if (!end) return false;
  const Point wanted = displaced(trial.bars.output_moving, trial.poses.front().pose, trial.poses.back().pose);
  if (std::abs(placed(trial.bars, *end).output_moving - wanted) > 1e-6) return false;
  if (report.sense == DriveSense::either) return true;  // the better of two ways
  const double least = least_transmission_angle(lengths, start, start + sweep);
  return std::abs(report.min_transmission_angle - least) < 1e-5;
}

bool agrees(const Trial& trial) {
  const DefectReport report = find_defects(trial.bars, trial.poses);
  if (report.type != linkage_type(trial.bars.lengths())) return false;
  if (report.type == LinkageType::change_point || report.type == LinkageType::degenerate) return true;
  const DriveThroughReport drive = drive_through(trial.bars, trial.poses);
  if (!drive.completed) return true;
  if (report.defects != drive.defects) return false;
  const double turn = report.min_transmission_angle_full_turn;
  if (std::abs(turn - least_transmission_angle_full_turn(trial.bars.lengths())) > 1e-5) return false;
  return !report.defects.none() || sweep_agrees(trial, report);
}

}  // namespace
}  // namespace linkwright

int main() {
  linkwright::testing::RandomFourBars random(4);
  int disagreements = 0;
  for (int i = 0; i < 2000; ++i) {
    const linkwright::Trial trial = linkwright::random_trial(random);
    if (trial.poses.size() >= 2 && !linkwright::agrees(trial)) ++disagreements;
  }
  std::printf("%d disagreements\n", disagreements);
  return disagreements == 0 ? 0 : 1;
}
