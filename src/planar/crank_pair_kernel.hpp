#pragma once

#include "planar/four_bar_kernel.hpp"

namespace linkwright {

/// Rows [row_begin, row_end) of a map of timed linkages: a row has a crank, a column the crank of the cognate, both as
/// dyads of the body that turns with them. docs/theory/path.md has the loop that stands for their linkage.
struct CrankPairTask {
  KernelAxis cranks, cognates;  ///< without senses; length 0 where the link makes no linkage
  const double* crank_length;   ///< by row, of the linkage's input, unit of the axes
  int admissible_directions;    ///< of all cranks, whose turns are given: as in DyadAxis
  int at_least_half_turn;
  std::size_t row_begin, row_end, columns;
  int poses;
  double unit;        ///< user's length of one unit of the axes
  double zero_share;  ///< tolerance::change_point
  KernelCells cells;
};

LINKWRIGHT_DECLARE_KERNELS(crank_pair_kernel, const CrankPairTask&);

}  // namespace linkwright
