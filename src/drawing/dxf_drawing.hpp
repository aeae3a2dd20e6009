#pragma once

#include <string>

#include "linkwright/files/linkage_file.hpp"
#include "linkwright/files/six_bar_file.hpp"
#include "linkwright/loads/loads.hpp"

namespace linkwright {

/// One linkage as a DXF drawing (AutoCAD 2000), 1 : 1 in the fixed frame, $INSUNITS by the length unit (mm, cm, m, in,
/// ft; unitless else). Layers: GROUND, INPUT, COUPLER, OUTPUT with the outline and the two pin holes of each link in
/// position 1, of a coupler with a point the triangle as well; POSITIONS with the moving frame in all poses and the
/// links in the others; COUPLER_CURVE with the path of traced_point() over the motion cycle.
/// With `loads`, of a linkage with poses: SPRINGS with the two studs of each and the line between them, CYLINDER with
/// those of a cylinder that drives, MASSES with the centres of mass, HANDLE; as they lie in position 1.
[[nodiscard]] std::string draw_dxf(const StoredLinkage& linkage, const Loads* loads = nullptr);

/// The same of a six-bar. Layers: GROUND, BODY_1 (the driver) … BODY_5, a bar with round ends where a body has two
/// hinges, a closed polyline where it has three; POSITIONS with the moving frame in all poses and the bodies in the
/// others; BODY_PATH with the path of the moving frame's origin.
[[nodiscard]] std::string draw_dxf(const StoredSixBar& linkage);

}  // namespace linkwright
