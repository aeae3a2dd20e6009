#pragma once

#include <span>
#include <vector>

#include "analysis/six_bar_loops.hpp"
#include "linkwright/analysis/six_bar_drive.hpp"
#include "linkwright/core/simd.hpp"

namespace linkwright {

/// One of many six-bars to be driven.
struct SixBarToDrive {
  SixBarLoops loops;
  std::span<const SixBarTurns> wanted;
};

/// Of six-bars whose signs at all configurations agree. Where a verdict is sure: what drive_six_bar() says without
/// circuits, with γ to three digits or so; otherwise nothing: strands cross or nearly do, positions share an angle of
/// the driver, or a dead point is too near to tell. All have as many configurations as the first.
[[nodiscard]] std::vector<std::optional<SixBarDriveReport>> judge_six_bars(std::span<const SixBarToDrive> six_bars,
                                                                           Simd simd = Simd::automatic);

/// Of each what drive_six_bar() says without circuits: judged where that is sure, driven where it is not.
[[nodiscard]] std::vector<SixBarDriveReport> drive_six_bars(std::span<const SixBarToDrive> six_bars,
                                                            Simd simd = Simd::automatic);

}  // namespace linkwright
