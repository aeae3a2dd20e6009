#pragma once

#include <string>

#include "linkwright/io/linkage_file.hpp"

namespace linkwright {

/// One linkage as a DXF drawing (AutoCAD 2000), 1 : 1 in the fixed frame, $INSUNITS by the length unit (mm, cm, m, in,
/// ft; unitless else). Layers: GROUND, INPUT, COUPLER, OUTPUT with the outline and the two pin holes of each link in
/// position 1; POSITIONS with the moving frame in all poses and the links in the others; COUPLER_CURVE with the path of
/// traced_point() over the motion cycle.
[[nodiscard]] std::string draw_dxf(const StoredLinkage& linkage);

}  // namespace linkwright
