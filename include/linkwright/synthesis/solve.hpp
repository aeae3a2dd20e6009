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
#include "linkwright/planar/chain_family.hpp"
#include "linkwright/planar/four_bar_solution.hpp"
#include "linkwright/planar/freed_position.hpp"
#include "linkwright/planar/missed_box.hpp"
#include "linkwright/planar/six_bar_synthesis.hpp"
#include "linkwright/planar/task_family.hpp"
#include "linkwright/region/best_cells.hpp"
#include "linkwright/region/region_map.hpp"
#include "linkwright/region/requirement_filter.hpp"
#include "linkwright/region/requirements.hpp"
#include "linkwright/synthesis/options.hpp"
#include "linkwright/synthesis/task.hpp"

namespace linkwright {

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
  std::int64_t dyads_left_out = 0;        ///< of the samples: rounding changes their lengths; a warning says so
  std::int64_t left_out = 0;              ///< of the best: is_unconfirmed; a warning says so
  std::vector<FourBarSolution> linkages;  ///< best first
  /// Five positions: every pair of dyads, whatever its defects, best first; five precision points: every linkage.
  std::vector<FourBarSolution> pairs;
  std::vector<FreedPosition> freed;          ///< five positions, no linkage that meets the requirements: the ways out
  std::shared_ptr<const ChainFamily> chain;  ///< six-bars of a given chain
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
