#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "linkwright/files/linkage_file.hpp"
#include "linkwright/mechanism/task_cycle.hpp"

namespace linkwright {

/// A motion as numbers: a row a state, a column a quantity.
struct MotionTable {
  std::vector<std::string> columns;  ///< names, units in them
  std::vector<double> values;        ///< row-major; NaN: not defined there

  [[nodiscard]] std::size_t rows() const { return columns.empty() ? 0 : values.size() / columns.size(); }
};

/// As comma-separated values, one header line and one line a row; nothing between two commas where it is not defined.
/// Numbers read back bit-identical.
[[nodiscard]] std::string csv_text(const MotionTable& table);

/// The motion cycle from position 1 on (tabulated_cycle): the input's turn from position 1; the directions of the
/// links, from fixed to moving pivot and from the input's to the output's, against the x axis of the fixed frame;
/// moving pivots; the body, which is the moving frame, in the fixed one; transmission angle; first and second
/// derivatives of the coupler and output angles by the input angle, not defined at dead points; the number of the
/// position that the body comes nearest to, from 1, and how far it is from it, not defined between; of a linkage with a
/// point that point. Degrees, all angles counter-clockwise.
[[nodiscard]] MotionTable motion_columns(const StoredLinkage& linkage);
/// The same as csv_text().
[[nodiscard]] std::string motion_table(const StoredLinkage& linkage);

/// The cycle that motion_table() tells: a row a degree of the input (task_cycle).
[[nodiscard]] std::vector<CycleState> tabulated_cycle(const StoredLinkage& linkage);

/// The poses of a linkage; where the file does not say, the one in which it lies, the frame at the input's moving
/// pivot.
[[nodiscard]] std::vector<PrescribedPose> framed_poses(const StoredLinkage& linkage);

/// The point of the coupler that is traced: the file's own, else the moving frame's origin where the poses are known,
/// else the input's moving pivot. Fixed frame, position 1.
[[nodiscard]] Point traced_point(const StoredLinkage& linkage);

}  // namespace linkwright
