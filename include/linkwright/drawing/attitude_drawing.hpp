#pragma once

#include <string>

#include "linkwright/files/displacement_file.hpp"
#include "linkwright/files/orientation_file.hpp"

namespace linkwright {

// Pictures of rotations and displacements (SVG, 640 px wide): orthographic views of the fixed frame from above and in
// front, z upwards, in which nothing hides anything else.

/// An orientation: given by three angles, the three turns one after another and all of them together, with the line of
/// nodes, or at gimbal lock the two axes that have come to lie in one line; given otherwise, one turn about its axis,
/// both triads, and a vector (the task's first, or one that shows the turn well) with its image.
[[nodiscard]] std::string draw_orientation(const OrientationReport& report);

/// A displacement as a screw: its axis, both triads, the helix of the origin (or, where that lies on the axis, of a
/// point beside it), angle and slide.
[[nodiscard]] std::string draw_displacement(const DisplacementReport& report);

}  // namespace linkwright
