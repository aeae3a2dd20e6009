#pragma once

#include "linkwright/region/cell_measure.hpp"
#include "linkwright/robust/tolerances.hpp"
#include "linkwright/spherical/spherical_family.hpp"

namespace linkwright {

/// The errors to first order, degrees, of a map of spherical four-bars that visit the same orientations. Refers to the
/// map.
[[nodiscard]] CellMeasure::Rows spherical_errors(const SphericalProductFamily& family, const RegionMap& map,
                                                 const Tolerances& tolerances);

}  // namespace linkwright
