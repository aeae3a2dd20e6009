#pragma once

#include <cstdint>

#include "core/kernels.hpp"

namespace linkwright {

/// Arms that take a point through the places of a path, a lane to each; their further dyads, number by number; and the
/// verdict over both as a pair, as a kernel reads and writes them. Working frame, its origin in the first place.
struct ArmBlock {
  static constexpr int size = 64, most_places = 5, most_dyads = 3;

  // Of all arms.
  int count = 0;            ///< lanes beyond it are worked on, too, and mean nothing
  int places = 0;           ///< of the point, one to five
  bool has_rows = false;    ///< `row` has the conditions; otherwise they are those of five places without derivatives
  bool arm_drives = false;  ///< pairs are judged; otherwise not
  double zero_share = 0;    ///< tolerance::change_point
  double infinity = 0;      ///< tolerance::infinity
  double place[most_places][2] = {};

  // Of each.
  alignas(64) double row[4][7][size];                 ///< conditions, as ConditionRow
  alignas(64) double pivot[2][size];                  ///< the fixed one
  alignas(64) double link[most_places][2][size];      ///< by place, from there to the moving pivot
  alignas(64) double turn[most_places][2][size];      ///< by place, e^{iθ} of the body from the first place on
  std::uint8_t senses[size], half_turn_senses[size];  ///< of an arm that drives, as DriverSequence has them

  // Of each of its further dyads.
  std::uint8_t real[most_dyads][size];             ///< 1 where there is one
  alignas(64) double circle[most_dyads][3][size];  ///< unit vectors (w, x, y), w ≥ 0
  alignas(64) double center[most_dyads][3][size];
  std::uint8_t type[most_dyads][size], defects[most_dyads][size];  ///< of the pair; a slider's is degenerate
  alignas(64) double versine[most_dyads][size], full_versine[most_dyads][size];  ///< as of PairJudgement
  alignas(64) double longest[most_dyads][size], shortest[most_dyads][size];
};

LINKWRIGHT_DECLARE_KERNELS(arm_kernel, ArmBlock&);

}  // namespace linkwright
