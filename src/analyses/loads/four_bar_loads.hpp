#pragma once

#include <memory>
#include <span>

#include "linkwright/core/simd.hpp"
#include "linkwright/loads/loads.hpp"
#include "linkwright/region/cell_measure.hpp"
#include "planar/four_bar_cells.hpp"

namespace linkwright {

/// All of the loads is what kernels know: no torsion springs, no fast gas, no inertia, no more stations than they take.
[[nodiscard]] bool fits_lanes(const Loads& loads, std::size_t positions);

/// CellLoads::read_out() of the four-bars of a map without defects, CellLook::map, in packs; infinite, to the worse
/// side, with a defect. `body`: the moving frame in position 1, of all. Refers to the map.
[[nodiscard]] CellMeasures::Rows four_bar_loads(std::shared_ptr<const FourBarCells> links, const RegionMap& map,
                                                const Loads& loads, std::span<const ReadOut> read_outs,
                                                const Pose& body, Simd simd = Simd::automatic);

}  // namespace linkwright
