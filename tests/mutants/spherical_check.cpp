// Judges one build of the spherical find_defects by what shares nothing with it: driving, the type from the angles, a
// dense sweep. Prints the number of disagreements; exits with 1 when there are any.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/spherical_defects.hpp"
#include "linkwright/mechanism/spherical_position.hpp"

namespace linkwright {
namespace {

struct Trial {
  SphericalFourBar bars;
  std::vector<PrescribedOrientation> orientations;
};

// Orientations that a linkage passes, in or out of order, on one assembly or on both, half the time one of short links.
class Trials {
 public:
  [[nodiscard]] Trial next() {
    SphericalFourBar bars = random_bars();
    const auto ranges = input_ranges(bars.angles());
    const int kind = static_cast<int>(random_() % 3);
    const double start = configuration_of(bars).input_angle, step = uniform(-1, 1);
    Trial trial{bars, {}};
    for (int i = 0; i < 4; ++i) {
      const AngleRange& range = ranges[random_() % ranges.size()];
      const double angle = i == 0      ? start
                           : kind == 0 ? start + i * step
                                       : range.from + (range.to - range.from) * uniform(0.001, 0.999);
      const Assembly here = kind == 2 && i > 0 && random_() % 2 == 0 ? opposite(assembly_of(bars)) : assembly_of(bars);
      const auto there = assemble(bars.angles(), angle, here);
      if (there) trial.orientations.push_back({coupler_turn(bars, placed(bars, *there)), {}});
    }
    return trial;
  }

 private:
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  Vector3 axis(double spread) {
    std::normal_distribution<double> normal(0, spread);
    const double x = normal(random_), y = normal(random_);
    return normalized(Vector3{x, y, spread < 1 ? 1 : normal(random_)});
  }
  SphericalFourBar random_bars() {
    const double spread = random_() % 2 == 0 ? 1 : 0.4;
    SphericalFourBar bars;
    const auto is_short = [](double arc) { return std::min(arc, pi - arc) < 0.05; };
    do bars = {axis(spread), axis(spread), axis(spread), axis(spread)};
    while (std::ranges::any_of(bars.angles().all(), is_short) || transmission_angle(bars) < 0.02);
    return bars;
  }

  std::mt19937_64 random_{4};
};

// What a clean report promises: the sweep ends at the last orientation, and the angle on the way.
bool sweep_agrees(const Trial& trial, const DefectReport& report) {
  const double start = configuration_of(trial.bars).input_angle;
  const double sweep = report.sense == DriveSense::cw ? -report.sweep : report.sweep;
  double least = pi / 2;
  constexpr int steps = 400;
  for (int k = 0; k <= steps; ++k) {
    const auto there = assemble(trial.bars.angles(), start + sweep * k / steps, assembly_of(trial.bars));
    if (!there) return false;
    const SphericalFourBar bars = placed(trial.bars, *there);
    least = std::min(least, transmission_angle(bars));
    const Vector3 wanted = trial.orientations.back().orientation.apply(trial.bars.output_moving);
    if (k == steps && norm(bars.output_moving - wanted) > 1e-6) return false;
  }
  if (report.sense == DriveSense::either) return true;  // the better of two ways
  return std::abs(report.min_transmission_angle - least) < 5e-3;
}

bool agrees(const Trial& trial) {
  const DefectReport report = find_defects(trial.bars, trial.orientations);
  if (report.type != linkage_type(trial.bars.angles())) return false;
  const DriveThroughReport drive = drive_through(trial.bars, trial.orientations);
  if (!drive.completed) return true;
  if (report.defects != drive.defects) return false;
  return !report.defects.none() || sweep_agrees(trial, report);
}

}  // namespace
}  // namespace linkwright

int main() {
  linkwright::Trials trials;
  int disagreements = 0;
  for (int i = 0; i < 1000; ++i) {
    const linkwright::Trial trial = trials.next();
    if (trial.orientations.size() >= 2 && !linkwright::agrees(trial)) ++disagreements;
  }
  std::printf("%d disagreements\n", disagreements);
  return disagreements == 0 ? 0 : 1;
}
