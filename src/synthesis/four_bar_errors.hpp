#pragma once

#include "linkwright/planar/four_bar_family.hpp"
#include "linkwright/region/cell_measure.hpp"
#include "linkwright/robust/tolerances.hpp"

namespace linkwright {

/// The errors to first order of a map of planar four-bars, a row at a time in lanes: user's unit, of functions degrees.
/// Refers to family and map. The turning length of the tolerances is set.
[[nodiscard]] CellMeasure::Rows four_bar_errors(const FourBarFamily& family, const RegionMap& map,
                                                const Tolerances& tolerances);

}  // namespace linkwright
