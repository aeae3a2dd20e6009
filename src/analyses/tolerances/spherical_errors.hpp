#pragma once

#include "linkwright/region/cell_measure.hpp"
#include "linkwright/robust/tolerances.hpp"
#include "spherical/spherical_cells.hpp"

namespace linkwright {

/// The errors to first order, degrees, of a map of spherical four-bars, of which `cells` are. Refers to the map.
[[nodiscard]] CellMeasure::Rows spherical_errors(const SphericalCells& cells, const RegionMap& map,
                                                 const Tolerances& tolerances);

}  // namespace linkwright
