#pragma once

#include <array>
#include <optional>
#include <vector>

#include "linkwright/approximate/fit_wishes.hpp"
#include "linkwright/core/result.hpp"
#include "linkwright/loads/loads.hpp"
#include "linkwright/planar/six_bar_synthesis.hpp"
#include "linkwright/region/best_cells.hpp"
#include "linkwright/region/map_axis.hpp"
#include "linkwright/region/region_map.hpp"
#include "linkwright/region/requirements.hpp"
#include "linkwright/robust/tolerances.hpp"
#include "linkwright/straight_line/line_measuring.hpp"
#include "linkwright/synthesis/task.hpp"

namespace linkwright {

struct SynthesisOptions {
  static constexpr int min_samples = 8, max_samples = 20'000, max_best = 1000;
  static constexpr int max_seed = 999'999'999, max_effort = 10'000'000;

  int region_samples = 400;               ///< N of the N×N region
  Spacing spacing = Spacing::coordinate;  ///< of the samples along the curve
  Objective objective = Objective::min_transmission_angle;
  /// Two objectives: linkages that no other beats in both are listed, spread over the front of them. Nothing: the best
  /// by `objective`.
  std::optional<std::array<Objective, 2>> pareto;
  int best = 10;                    ///< how many linkages, ≥ 0
  std::optional<MapWindow> window;  ///< nothing: the whole region
  /// A place of the map: what is there is listed, whether it meets the requirements or not, and nothing else. Nothing:
  /// the best.
  std::optional<MapPoint> at;

  // Six-bars without a given chain, which is searched for; paths of five points whose ground pivot is.
  std::optional<Box> box;       ///< for all pivots in position 1, or for that pivot; user's unit
  int seed = 1;                 ///< of the chains or arms tried, ≥ 0
  int effort = default_effort;  ///< how many of them are tried, ≥ 1

  LineMeasuring line;  ///< of straight lines
  FitWishes fit;       ///< of paths that pass near points

  std::optional<Tolerances> tolerances;  ///< how linkages are made; nothing: exactly
  bool measure_yields = true;            ///< of the map's cells, even where nothing asks for them
  std::optional<Loads> loads;            ///< what acts on the linkages; nothing: nothing

  RegionOptions region;
};

/// The caller's mistakes. Places are `options.…`.
[[nodiscard]] std::vector<Error> mistakes_in(const SynthesisOptions& options);

/// What of requirements and options does not go with the task or with each other: an objective that it cannot be
/// measured by, what is asked of tolerances where none are given.
[[nodiscard]] std::vector<Error> mistakes_in(const Task& task, const Requirements& requirements,
                                             const SynthesisOptions& options);

}  // namespace linkwright
