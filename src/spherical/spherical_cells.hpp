#pragma once

#include <optional>
#include <vector>

#include "linkwright/spherical/spherical_family.hpp"

namespace linkwright {

/// The dyads of a map's rows and columns (nothing where there is none), and the orientations that all of its linkages
/// visit.
struct SphericalCells {
  std::vector<PrescribedOrientation> orientations;
  std::vector<std::optional<SphericalDyad>> rows, columns;
};

}  // namespace linkwright
