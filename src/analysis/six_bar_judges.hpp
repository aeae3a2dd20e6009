#pragma once

// What both judges of six-bars share.

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "analysis/six_bar_judge.hpp"
#include "analysis/six_bar_kernel.hpp"

namespace linkwright {

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
