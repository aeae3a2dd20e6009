#pragma once

#include <optional>
#include <vector>

#include "linkwright/region/linkage_family.hpp"
#include "linkwright/synthesis/answer.hpp"
#include "region/window_look.hpp"

namespace linkwright {

/// What of a family's map is laid out.
struct MapExtent {
  int samples = 0;                  ///< N of the N×N map
  std::optional<MapWindow> window;  ///< nothing: the whole region
  int inside = 0;                   ///< windows for hinges are looked into by so many samples a side, if that is more
};

/// Adds what is asked of a map beside what its family measures, yields only of the cells that meet all else.
void measure_added(RegionMap& map, const LinkageFamily& family, const Findings& found, const Progress& progress = {});

/// The map of the findings under their requirements, and what was looked at inside windows for hinges.
struct CountedRegion {
  RequirementFilter filter;
  MapPoint step;                    ///< from cell to cell of the map
  std::optional<MapWindow> window;  ///< of the map
  WindowLook within;

  /// What a search for the best begins at.
  [[nodiscard]] std::vector<SearchMap> maps(const RegionMap& region) const;
};

/// Lays the map of a family out, counts its linkages and those that meet the requirements, and looks into the windows
/// for hinges; where nothing meets the requirements, what would leave some. With tolerances, whose turning length is
/// set, what they do to the cells is measured as well. What is returned lives no longer than the findings.
[[nodiscard]] CountedRegion count_region(Findings& found, const LinkageFamily& family, const MapExtent& extent,
                                         const Progress& progress);

}  // namespace linkwright
