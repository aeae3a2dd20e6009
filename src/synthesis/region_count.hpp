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

/// Adds what is asked of a map beside what its family measures, yields only of the cells that meet all else.
void measure_added(RegionMap& map, const LinkageFamily& family, const Findings& found, const Progress& progress = {});

/// Lays the map of a family out, counts its linkages and those that meet the requirements; where none does, what would
/// leave some. With tolerances, whose turning length is set, what they do to the cells is measured as well. The filter
/// lives no longer than the findings.
[[nodiscard]] RequirementFilter count_region(Findings& found, const Task& task, const LinkageFamily& family,
                                             const MapExtent& extent, const Progress& progress);

}  // namespace linkwright
