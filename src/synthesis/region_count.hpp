#pragma once

#include <optional>

#include "linkwright/region/linkage_family.hpp"
#include "linkwright/synthesis/answer.hpp"

namespace linkwright {

/// What of a family's map is laid out.
struct MapExtent {
  int samples = 0;                  ///< N of the N×N map
  std::optional<MapWindow> window;  ///< nothing: the whole region
};

/// Lays the map of a family out, counts its linkages and those that meet the requirements; where none does, what would
/// leave some. The filter lives no longer than the findings.
[[nodiscard]] RequirementFilter count_region(Findings& found, const LinkageFamily& family, const MapExtent& extent,
                                             const Progress& progress);

}  // namespace linkwright
