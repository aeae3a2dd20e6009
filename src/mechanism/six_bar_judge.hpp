#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "linkwright/core/simd.hpp"
#include "linkwright/mechanism/six_bar_drive.hpp"
#include "six_bar_kernel.hpp"
#include "six_bar_loops.hpp"

// What both judges of six-bars share.
namespace linkwright {

/// One of many six-bars to be driven.
struct SixBarToDrive {
  SixBarLoops loops;
  std::span<const SixBarTurns> wanted;
};

/// The signs of the transmission are the same in all configurations: necessary for one branch, and cheap.
[[nodiscard]] bool signs_agree(const SixBarLoops& loops, std::span<const SixBarTurns> wanted);

/// Of six-bars whose signs agree. Where a verdict is sure: what drive_six_bar() says without circuits, with γ to three
/// digits or so; otherwise nothing: positions share an angle of the driver or do not close, a dead point is too near to
/// tell, or there are too few or too many positions (at least three for dyads, at most four otherwise).
[[nodiscard]] std::vector<std::optional<SixBarDriveReport>> judge_six_bars(std::span<const SixBarToDrive> six_bars,
                                                                           Simd simd = Simd::automatic);

/// Of the few that take longer than this one in two is never decided, and each takes as long as thousands of others.
inline constexpr int most_steps_of_many = 5'000;

/// Of six-bars whose signs agree, of each what drive_six_bar() says without circuits: judged where that is sure, driven
/// by at most most_steps_of_many where it is not.
[[nodiscard]] std::vector<SixBarDriveReport> drive_six_bars(std::span<const SixBarToDrive> six_bars,
                                                            Simd simd = Simd::automatic);

/// What drive_six_bar() says of one whose signs do not agree, without circuits.
[[nodiscard]] SixBarDriveReport turned_down_by_signs();

using SixBarReports = std::vector<std::optional<SixBarDriveReport>>;

/// Judges those of `six_bars` that `open` lists, and leaves nothing in the reports of which it is not sure.
void judge_dyads(std::span<const SixBarToDrive> six_bars, std::vector<std::size_t> open, Simd simd,
                 SixBarReports& reports);
void judge_strands(std::span<const SixBarToDrive> six_bars, std::vector<std::size_t> open, Simd simd,
                   SixBarReports& reports);

inline void put(LaneVector& to, std::size_t lane, Point value) {
  to.x.of[lane] = value.real();
  to.y.of[lane] = value.imag();
}
inline Point at(const LaneVector& from, std::size_t lane) { return {from.x.of[lane], from.y.of[lane]}; }

/// One of order and branch.
inline SixBarDriveReport with_defect(unsigned bit) {
  SixBarDriveReport report;
  report.completed = true;
  report.defects.bits = static_cast<std::uint8_t>(bit);
  return report;
}

inline SixBarDriveReport without_defects(int sense, double sweep, std::array<double, 2> min_sines) {
  SixBarDriveReport report;
  report.completed = true;
  report.sense = sense > 0 ? DriveSense::ccw : DriveSense::cw;
  report.sweep = sweep;
  report.min_sines = min_sines;
  report.min_sine = std::min(min_sines[0], min_sines[1]);
  return report;
}

}  // namespace linkwright
