#include "linkwright/mechanism/six_bar_drive.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/tolerance.hpp"
#include "six_bar_judge.hpp"
#include "six_bar_walk.hpp"

namespace linkwright {
namespace {

/// Sines of the transmission at a place of a walk.
struct Sample {
  double arc = 0;
  std::array<double, 2> sine{};
};

/// A walk with what it passed.
struct SampledWalk : SixBarProgress {
  using SixBarProgress::SixBarProgress;
  std::vector<Sample> samples;
  int steps = 0;
};

/// Where a walk ends beside a return to position 1 and a meeting of all configurations.
enum class Until { dead_point, return_only };

class Walker {
 public:
  Walker(const SixBarLoops& loops, std::span<const SixBarTurns> wanted, const SixBarDriveOptions& options)
      : loops_(loops), wanted_(wanted), options_(options) {}

  /// Least sines at the configurations wanted.
  [[nodiscard]] std::array<double, 2> sines_at_wanted() const;
  /// From position 1, first with the driver turning counter-clockwise (`sense` +1) or clockwise (−1). Nothing where
  /// the curve cannot be followed.
  [[nodiscard]] std::optional<SampledWalk> walk(int sense, Until until) const;

 private:
  [[nodiscard]] std::optional<SixBarStrand> advanced(const SixBarStrand& here, const TurnVector& way) const;

  SixBarLoops loops_;
  std::span<const SixBarTurns> wanted_;
  SixBarDriveOptions options_;
};

std::array<double, 2> Walker::sines_at_wanted() const {
  std::array<double, 2> least = {1, 1};
  for (const SixBarTurns& turns : wanted_) {
    const std::array<double, 2> sine = sines_of(loops_, LoopValues(loops_, turns));
    for (std::size_t i = 0; i < 2; ++i) least[i] = std::min(least[i], sine[i]);
  }
  return least;
}

std::optional<SixBarStrand> Walker::advanced(const SixBarStrand& here, const TurnVector& way) const {
  if (options_.exact_steps) return corrected(loops_, stepped(here.turns, way), tolerance::on_curve);
  return strand_at(loops_, stepped(here.turns, plus(way, here.correction)));
}

std::optional<SampledWalk> Walker::walk(int sense, Until until) const {
  auto here = corrected(loops_, wanted_.front(), tolerance::on_curve);
  if (!here) return std::nullopt;
  const SixBarTurns home = here->turns;
  const bool home_positive = here->positive();
  const double along_tangent = (home_positive ? 1 : -1) * sense;
  SampledWalk walk(wanted_.size());
  for (; walk.steps < options_.max_steps; ++walk.steps) {
    if (!(here->reach > tolerance::crossing_strands_radius)) return std::nullopt;
    if (until == Until::dead_point) walk.samples.push_back({walk.length, sines_of(loops_, here->values)});
    const TurnVector ahead = times(along_tangent, here->tangent);
    const double length = step_in_reach * here->reach;
    walk.meet(loops_, wanted_, *here, ahead, length, options_.pose_tolerance);
    if (walk.met_all() || (walk.steps > 0 && distance_to(home, *here, ahead, length))) return walk;
    const auto next = advanced(*here, times(length, ahead));
    if (!next) return std::nullopt;
    walk.turn += turn_between(here->turns, next->turns);
    walk.length += length;
    if (until == Until::dead_point && next->positive() != home_positive) return walk;
    here = next;
  }
  return std::nullopt;
}

SixBarDriveReport free_of_defects(const Walker& walker, const SampledWalk& walk, int sense) {
  const PositionMet last = walk.meetings.back().value_or(PositionMet{});
  SixBarDriveReport report;
  report.completed = true;
  report.sense = sense > 0 ? DriveSense::ccw : DriveSense::cw;
  report.sweep = std::abs(last.turn);
  report.min_sines = walker.sines_at_wanted();
  for (const Sample& sample : walk.samples)
    if (sample.arc <= last.arc)
      for (std::size_t i = 0; i < 2; ++i) report.min_sines[i] = std::min(report.min_sines[i], sample.sine[i]);
  report.min_sine = std::min(report.min_sines[0], report.min_sines[1]);
  return report;
}

SixBarDriveReport with_defects(unsigned bits) {
  SixBarDriveReport report;
  report.completed = true;
  report.defects.bits = static_cast<std::uint8_t>(bits);
  return report;
}

SixBarDriveReport undecided() {
  SixBarDriveReport report = with_defects(Defects::branch_bit | Defects::circuit_bit);
  report.completed = false;
  return report;
}

SixBarDriveReport branch_defect(const Walker& walker, bool circuits) {
  if (!circuits) return with_defects(Defects::branch_bit);
  const auto round = walker.walk(+1, Until::return_only);
  if (!round) return undecided();
  SixBarDriveReport report =
      with_defects(Defects::branch_bit | (round->met_all() ? 0u : unsigned{Defects::circuit_bit}));
  report.steps = round->steps;
  return report;
}

SixBarDriveReport drive(const Walker& walker, int sense, bool circuits) {
  const auto there = walker.walk(sense, Until::dead_point);
  if (!there) return undecided();
  if (there->met_all_in_order()) {
    SixBarDriveReport report = free_of_defects(walker, *there, sense);
    report.steps = there->steps;
    return report;
  }
  const auto back = walker.walk(-sense, Until::dead_point);
  if (!back) return undecided();
  SixBarDriveReport report = back->met_all_in_order()              ? free_of_defects(walker, *back, -sense)
                             : met_all_between_them(*there, *back) ? with_defects(Defects::order_bit)
                                                                   : branch_defect(walker, circuits);
  report.steps += there->steps + back->steps;
  return report;
}

}  // namespace

bool signs_agree(const SixBarLoops& loops, std::span<const SixBarTurns> wanted) {
  const SixBarTransmission first = signs_of(loops, LoopValues(loops, wanted.front()));
  return std::all_of(wanted.begin() + 1, wanted.end(), [&](const SixBarTurns& turns) {
    const SixBarTransmission here = signs_of(loops, LoopValues(loops, turns));
    return here.positive == first.positive && here.joint_positive == first.joint_positive;
  });
}

SixBarDriveReport turned_down_by_signs() { return with_defects(Defects::branch_bit); }

std::optional<double> sine_upper_bound(const SixBar& six_bar, std::span<const SixBarTurns> wanted) {
  if (wanted.empty()) return std::nullopt;
  const SixBarLoops loops(six_bar);
  if (!signs_agree(loops, wanted)) return std::nullopt;
  const std::array<double, 2> sines = Walker(loops, wanted, {}).sines_at_wanted();
  return std::min(sines[0], sines[1]);
}

SixBarDriveReport drive_six_bar(const SixBar& six_bar, std::span<const SixBarTurns> wanted,
                                const SixBarDriveOptions& options) {
  if (wanted.empty()) return undecided();
  const SixBarToDrive given{SixBarLoops(six_bar), wanted};
  const Walker walker(given.loops, wanted, options);
  if (!signs_agree(given.loops, wanted)) return branch_defect(walker, options.circuits);
  const SixBarDriveReport report = drive(walker, likelier_sense(wanted), options.circuits);
  if (report.completed || !given.loops.dyads) return report;
  // Where strands nearly cross on the torus of all angles, the dyads one by one may still be sure.
  const auto sure = judge_six_bars({&given, 1}).front();
  if (!sure) return report;
  return sure->defects.branch() ? branch_defect(walker, options.circuits) : *sure;
}

std::vector<SixBarDriveReport> drive_six_bars(std::span<const SixBarToDrive> six_bars, Simd simd) {
  const auto sure = judge_six_bars(six_bars, simd);
  SixBarDriveOptions options;
  options.circuits = false;
  options.max_steps = most_steps_of_many;
  std::vector<SixBarDriveReport> reports;
  for (std::size_t i = 0; i < six_bars.size(); ++i) {
    const auto& [loops, wanted] = six_bars[i];
    reports.push_back(sure[i] ? *sure[i]
                              : drive(Walker(loops, wanted, options), likelier_sense(wanted), options.circuits));
  }
  return reports;
}

}  // namespace linkwright
