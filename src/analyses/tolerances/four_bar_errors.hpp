#pragma once

#include <memory>

#include "linkwright/region/cell_measure.hpp"
#include "linkwright/robust/tolerances.hpp"
#include "planar/four_bar_cells.hpp"

namespace linkwright {

/// The errors to first order of a map of planar four-bars, a row at a time in lanes: user's unit, of functions degrees.
/// Refers to the map, of which `links` are. The turning length of the tolerances is set.
[[nodiscard]] CellMeasure::Rows four_bar_errors(std::shared_ptr<const FourBarCells> links, const RegionMap& map,
                                                const Tolerances& tolerances);

}  // namespace linkwright
