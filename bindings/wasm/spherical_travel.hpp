#pragma once

#include <vector>

#include "linkwright/spherical/spherical_analysis.hpp"

namespace linkwright::wasm {

/// A state of the drive, and where it is passed. Radians: the input's turn from position 1, positive in the sense of
/// travel; the output's, right-handed about its fixed axis, without jumps.
struct SphericalPassage {
  SphericalState state;
  double input_turn = 0, output_turn = 0;
};

/// A drive in the sense in which the positions come in order, or most nearly so: from dead point to dead point, or a
/// whole turn with the positions in its middle, as DriveTable of planar ones.
struct SphericalTravel {
  std::vector<SphericalPassage> passages;  ///< by rising input_turn
  std::vector<int> row_of_position;        ///< −1 where the drive does not come to it
  std::vector<double> dead_points;         ///< input_turn where it meets them, ascending
  bool full_turn = false;
};
[[nodiscard]] SphericalTravel spherical_travel(const SphericalAnalysis& analysis, std::size_t positions);

/// Of the four arcs and their supplements, radians.
[[nodiscard]] double least_link_angle(const LinkAngles& angles);

}  // namespace linkwright::wasm
