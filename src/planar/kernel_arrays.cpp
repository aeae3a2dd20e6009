#include "kernel_arrays.hpp"

namespace linkwright {

KernelAxis plain_arrays(const DyadAxis& axis) {
  KernelAxis plain{axis.center_x.data(),
                   axis.center_y.data(),
                   axis.circle_x.data(),
                   axis.circle_y.data(),
                   axis.length.data(),
                   {},
                   {},
                   axis.admissible_directions.data(),
                   axis.at_least_half_turn.data()};
  for (std::size_t j = 0; j < axis.pose_count(); ++j) {
    plain.arm_x[j] = axis.arm_x[j].data();
    plain.arm_y[j] = axis.arm_y[j].data();
  }
  return plain;
}

KernelCells kernel_cells(const RegionMap::Cells& cells) {
  return {cells.type,        cells.defects,     cells.measures[0],          cells.measures[1],
          cells.measures[2], cells.measures[3], cells.admissible_directions};
}

}  // namespace linkwright
