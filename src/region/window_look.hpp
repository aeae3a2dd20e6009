#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "linkwright/core/progress.hpp"
#include "linkwright/region/best_cells.hpp"
#include "linkwright/region/linkage_family.hpp"
#include "linkwright/region/requirement_filter.hpp"

namespace linkwright {

/// A map with what of it passes; its address stays, for the filter refers to the map.
struct JudgedMap {
  RegionMap map;
  std::optional<RequirementFilter> filter;
  MapPoint step;

  [[nodiscard]] SearchMap view() const { return {&map, &*filter, step}; }
};

/// How a family's map is filled and judged.
struct MapMaking {
  /// Classifies the cells over these coordinates, and measures what else is asked for.
  std::function<void(RegionMap& map, std::span<const double> input, std::span<const double> output)> fill;
  int samples = 0;                  ///< a side of the usual map
  std::optional<MapWindow> window;  ///< nothing: the whole region
  std::size_t followed = 40;        ///< where links depend on each other: places that are looked at closer at a time
  bool doubts_samples = true;       ///< an axis of which these find no stretch in the windows is looked at closer, too
};

using JudgedMaps = std::vector<std::unique_ptr<JudgedMap>>;

/// What of a family has its hinges in the windows required of them, looked at more closely than a map of the whole
/// family can: however small a window is, the stretches of the axes whose hinges lie in it are sampled for themselves.
struct WindowLook {
  JudgedMaps maps;
  std::int64_t looked_at = 0;  ///< their linkages with all hinges in the windows
  std::int64_t meeting = 0;    ///< of these: meet all requirements
  bool is_empty = false;       ///< no grounded link on one of the axes has its hinges there: proved, no linkage does
};

/// `seen`: the family's map under the same requirements. Where a grounded link depends on its own coordinate alone, its
/// stretches are computed (LinkageFamily::arcs_within); otherwise, or where samples find no stretch, a map of which
/// less meets the requirements than places would be followed is looked at closer and closer where its hinges come
/// nearest to their windows, a bounded number of times. Nothing to look at without windows, and where the map holds all
/// linkages that there are.
[[nodiscard]] WindowLook look_into_windows(const LinkageFamily& family, const SearchMap& seen,
                                           const Requirements& requirements, const MapMaking& making,
                                           const Progress& progress = {});

/// Where nothing of the maps (that of the whole family first, then a look into its windows) meets the requirements:
/// what relaxing a single one would leave, dearest first; of one window what lies in the other. Of the map that it
/// leaves most of.
[[nodiscard]] std::vector<Relaxation> relaxations(const LinkageFamily& family, std::span<const SearchMap> maps,
                                                  const Requirements& requirements, const MapMaking& making,
                                                  const Progress& progress = {});

}  // namespace linkwright
