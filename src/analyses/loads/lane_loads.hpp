#pragma once

#include "linkwright/algebra/point.hpp"
#include "linkwright/loads/loads.hpp"
#include "loads/load_kernel.hpp"

namespace linkwright {

/// `turned`: e^{i angle} of the moving frame in position 1.
[[nodiscard]] LanePoint lane_point(const CarriedPoint& point, Point turned);

/// Loads as kernels read them: of what fits_lanes().
[[nodiscard]] LaneLoads lane_loads(const Loads& loads, Point turned);

}  // namespace linkwright
