#pragma once

#include <complex>
#include <vector>

#include "draw.hpp"
#include "linkwright/mechanism/pose.hpp"

namespace linkwright::soak {

/// Where a task is drawn on the sheet, and how large.
struct Sheet {
  double scale = 1;    ///< 1e-3 … 1e4
  Point shift = 0;     ///< up to 1e4 scales from the origin
  bool round = false;  ///< numbers as people write them
};
[[nodiscard]] Sheet drawn_sheet(Draw& draw);

/// A number as it is put into the file: with few digits on a round sheet.
[[nodiscard]] double written(const Sheet& sheet, double number);

/// As many poses as there are multiplicities, with derivatives to match: scattered, along a path, on a grid, nearly
/// equal, on a line, parallel, mirrored, turned about one pole or nearly so, …
[[nodiscard]] std::vector<PrescribedPose> drawn_poses(Draw& draw, const Sheet& sheet,
                                                      const std::vector<int>& multiplicities);

}  // namespace linkwright::soak
