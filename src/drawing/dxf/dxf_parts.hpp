#pragma once

#include <string_view>

#include "dxf_writer.hpp"
#include "linkwright/mechanism/pose.hpp"

namespace linkwright {

/// $INSUNITS of a length unit.
[[nodiscard]] int insert_units(std::string_view unit);

/// A link: an outline with round ends, and the holes of its pins.
void draw_link(DxfWriter& dxf, std::string_view layer, Point from, Point to, double radius);

/// A pin on the ground, with its feet.
void draw_ground_pivot(DxfWriter& dxf, std::string_view layer, Point pivot, double radius);

/// A moving frame with its number.
void draw_frame(DxfWriter& dxf, std::string_view layer, const Pose& pose, std::size_t number, double size);

}  // namespace linkwright
