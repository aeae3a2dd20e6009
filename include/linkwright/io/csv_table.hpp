#pragma once

#include <span>
#include <string>
#include <vector>

#include "linkwright/analysis/coupler_curve.hpp"
#include "linkwright/io/linkage_file.hpp"

namespace linkwright {

/// A motion as comma-separated values, one header line and one line a state: link angles in degrees from the ground
/// link's direction (input_center → output_center), counter-clockwise; moving pivots and the traced
/// point in the fixed frame; transmission angle in degrees; first and second derivatives of the coupler and output
/// angles by the input angle, empty at dead points. Numbers read back bit-identical.
[[nodiscard]] std::string motion_table(std::span<const MotionState> motion);

/// The whole motion cycle in 361 states: a state a degree for a crank; from dead point to dead point and back on the
/// other assembly for all others.
[[nodiscard]] std::vector<MotionState> tabulated_motion(const FourBar& four_bar, Point traced);

/// The point of the coupler that is traced: the moving frame's origin where the poses are known, else the input's
/// moving pivot. Fixed frame, position 1.
[[nodiscard]] Point traced_point(const StoredLinkage& linkage);

}  // namespace linkwright
