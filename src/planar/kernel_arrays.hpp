#pragma once

#include "four_bar_kernel.hpp"
#include "linkwright/planar/four_bar_map.hpp"

namespace linkwright {

/// An axis as kernels read it; it must outlive them.
[[nodiscard]] KernelAxis plain_arrays(const DyadAxis& axis);
/// Where kernels put cells that measure `planar_measures`.
[[nodiscard]] KernelCells kernel_cells(const RegionMap::Cells& cells);

}  // namespace linkwright
