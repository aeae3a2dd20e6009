#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "linkwright/analysis/defects.hpp"
#include "linkwright/core/notice.hpp"
#include "linkwright/core/progress.hpp"
#include "linkwright/core/result.hpp"
#include "linkwright/mechanism/dyad.hpp"
#include "linkwright/planar/burmester_curve.hpp"
#include "linkwright/planar/four_bar_solution.hpp"
#include "linkwright/planar/freed_position.hpp"
#include "linkwright/planar/missed_box.hpp"
#include "linkwright/planar/six_bar_synthesis.hpp"
#include "linkwright/planar/task.hpp"
#include "linkwright/planar/task_family.hpp"
#include "linkwright/region/best_cells.hpp"
#include "linkwright/region/region_map.hpp"
#include "linkwright/region/requirement_filter.hpp"
#include "linkwright/region/requirements.hpp"

namespace linkwright {

struct SynthesisOptions {
  static constexpr int least_samples = 8, most_samples = 20'000, most_best = 1000;
  static constexpr int most_seed = 999'999'999, most_effort = 10'000'000;

  int region_samples = 400;               ///< N of the N×N region
  Spacing spacing = Spacing::coordinate;  ///< of the samples along the curve
  Objective objective = Objective::min_transmission_angle;
  int best = 10;                    ///< how many linkages, ≥ 0
  std::optional<MapWindow> window;  ///< of four-bars; nothing: the whole region

  // Six-bars without a given chain, which is searched for.
  std::optional<Box> box;       ///< for all pivots in position 1, user's unit
  int seed = 1;                 ///< of the chains tried, ≥ 0
  int effort = default_effort;  ///< how many chains are tried, ≥ 1

  RegionOptions region;
};

/// The caller's mistakes. Places are `options.…`.
[[nodiscard]] std::vector<Error> mistakes_in(const SynthesisOptions& options);

/// What of the options does not go with the task: an objective that it cannot be measured by.
[[nodiscard]] std::vector<Error> mistakes_in(const Task& task, const SynthesisOptions& options);

enum class SolutionStatus { solved, no_solution, degenerate };
[[nodiscard]] std::string_view name(SolutionStatus status);

/// Everything found for a task.
struct Solution {
  SolutionStatus status = SolutionStatus::solved;
  Notice reason;  ///< always set
  TaskFamily given;
  std::vector<Dyad> samples;  ///< of the curve, fixed frame, by rising τ
  RegionMap region;
  RegionCounts counts;
  Requirements requirements;              ///< as used: defaults filled in
  SynthesisOptions options;               ///< as used
  std::int64_t meeting_requirements = 0;  ///< cells
  std::int64_t left_out = 0;              ///< of the best: is_unconfirmed; a warning says so
  std::vector<FourBarSolution> linkages;  ///< best first
  /// Five positions: every pair of dyads, whatever its defects, best first; five precision points: every linkage.
  std::vector<FourBarSolution> pairs;
  std::vector<FreedPosition> freed;          ///< five positions, no linkage that meets the requirements: the ways out
  std::vector<SixBarSolution> six_bars;      ///< six-bar tasks, best first
  std::optional<SixBarSearchResult> search;  ///< six-bars without a given chain: how it went, its linkages moved out
  std::vector<Relaxation> relax;             ///< when no linkage meets the requirements, dearest first
  std::optional<JointRelaxation> relax_together;  ///< when relaxing one requirement alone would leave nothing either
  std::vector<MissedBox> missed_boxes;            ///< when no linkage meets the requirements
};

/// All linkages that do a task.
[[nodiscard]] Result<Solution> solve(const Task& task, const Requirements& requirements,
                                     const SynthesisOptions& options, const Progress& progress = {});

}  // namespace linkwright
