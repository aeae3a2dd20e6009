#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "linkwright/core/result.hpp"
#include "linkwright/loads/load_report.hpp"
#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/planar/chain_family.hpp"
#include "linkwright/planar/four_bar_solution.hpp"
#include "linkwright/planar/missed_box.hpp"
#include "linkwright/planar/relaxed_position.hpp"
#include "linkwright/planar/six_bar_synthesis.hpp"
#include "linkwright/planar/task_family.hpp"
#include "linkwright/region/added_measures.hpp"
#include "linkwright/region/best_cells.hpp"
#include "linkwright/region/region_map.hpp"
#include "linkwright/region/requirement_filter.hpp"
#include "linkwright/region/requirements.hpp"
#include "linkwright/robust/tolerance_report.hpp"
#include "linkwright/spherical/relaxed_orientation.hpp"
#include "linkwright/spherical/spherical_solution.hpp"
#include "linkwright/straight_line/straight_line_search.hpp"
#include "linkwright/straight_line/straight_line_solution.hpp"
#include "linkwright/synthesis/options.hpp"
#include "linkwright/synthesis/task.hpp"

namespace linkwright {

enum class SolutionStatus { solved, no_solution, degenerate };
[[nodiscard]] std::string_view name(SolutionStatus status);

/// What was looked at inside the windows required of hinges, more closely than the map shows it.
struct InsideWindows {
  std::int64_t looked_at = 0;  ///< linkages with all hinges inside
  std::int64_t meeting = 0;    ///< of these: meet all requirements
  bool is_empty = false;       ///< proved: no linkage has all hinges inside

  friend bool operator==(const InsideWindows&, const InsideWindows&) = default;
};

/// What is found for a task, whatever the kind of linkage.
struct Findings {
  SolutionStatus status = SolutionStatus::solved;
  Notice reason;                     ///< always set
  std::string pattern;               ///< of the positions, as pattern()
  double condition = 1;              ///< of the conditions, ≥ 1
  double characteristic_length = 1;  ///< of the task, user's unit
  std::vector<Notice> warnings;
  RegionMap region;  ///< without rows where there is no map
  RegionCounts counts;
  Requirements requirements;                        ///< as used: defaults filled in
  SynthesisOptions options;                         ///< as used
  std::int64_t meeting_requirements = 0;            ///< cells
  std::optional<InsideWindows> inside;              ///< where windows are required; nothing: the map is complete
  std::int64_t left_out = 0;                        ///< of the best: driving does not confirm them; a warning says so
  std::vector<std::vector<RequirementKind>> fails;  ///< options.at: by linkages, the requirements that each fails
  std::vector<ParetoCell> pareto;                   ///< options.pareto: the whole front of the map
  AddedMeasures added;                              ///< of the task, options.tolerances and loads, of the map
  /// What the task itself asks beside what its family measures: the error at near poses. Null: nothing.
  std::shared_ptr<const CellMeasure> of_task;
  /// With tolerances, by linkages: what they do to each; nothing at a dead point.
  std::vector<std::optional<ToleranceReport>> tolerance;
  /// With loads, by linkages: the forces in each; nothing where a dead point keeps it from the task.
  std::vector<std::optional<LoadReport>> loads;
  std::vector<Relaxation> relax;                  ///< when no linkage meets the requirements, dearest first
  std::optional<JointRelaxation> relax_together;  ///< when relaxing one requirement alone would leave nothing either
};

/// Where linkages were found inside windows for hinges and none by the cells of the map: how many, in a sentence;
/// otherwise nothing.
[[nodiscard]] std::string found_inside_text(const Findings& found);

/// Of a task whose linkages are pairs of dyads.
template <class Given, class PairedDyad, class Solution>
struct PairAnswer : Findings {
  Given given;
  std::vector<PairedDyad> samples;  ///< of the curve, fixed frame, by rising coordinate
  std::vector<Solution> linkages;   ///< best first
  /// Of few dyads (five positions; on the sphere three, too): every pair, whatever its defects, best first; five
  /// precision points, or five positions of a path: every linkage.
  std::vector<Solution> pairs;

  /// What the map is of; null without one.
  [[nodiscard]] const auto* family() const { return given.family.get(); }
  [[nodiscard]] MapPoint point_of(const Solution& found) const {
    return {found.input.coordinate, found.output.coordinate};
  }
};

struct FourBarAnswer : PairAnswer<TaskFamily, Dyad, FourBarSolution> {
  std::int64_t dyads_left_out = 0;      ///< of the samples: rounding changes their lengths; a warning says so
  std::vector<MissedBox> missed_boxes;  ///< when no linkage meets the requirements
};

struct MotionAnswer : FourBarAnswer {
  MotionTask task;
  std::vector<RelaxedPosition> relaxed;  ///< five positions, no linkage that meets the requirements: the ways out
};

struct FunctionAnswer : FourBarAnswer {
  FunctionTask task;
};

struct PathAnswer : FourBarAnswer {
  PathTask task;
};

struct SphericalAnswer : PairAnswer<SphericalTaskFamily, SphericalDyad, SphericalSolution> {};

struct SphericalMotionAnswer : SphericalAnswer {
  SphericalMotionTask task;
  std::vector<RelaxedOrientation> relaxed;  ///< five positions, no linkage that meets the requirements: the ways out
};

struct SphericalFunctionAnswer : SphericalAnswer {
  SphericalFunctionTask task;
};

struct SixBarAnswer : Findings {
  SixBarTask task;
  std::shared_ptr<const ChainFamily> chain;  ///< of a given chain
  std::vector<SixBarSolution> linkages;      ///< best first
  std::optional<SixBarSearchResult> search;  ///< without a given chain: how it went, its linkages moved out

  /// What the map is of; null without a chain.
  [[nodiscard]] const ChainFamily* family() const { return chain.get(); }
  [[nodiscard]] MapPoint point_of(const SixBarSolution& found) const { return chain->point_of(found.member); }
};

struct StraightLineAnswer : Findings {
  StraightLineTask task;
  std::shared_ptr<const StraightLineFamily> lines;  ///< null where a linkage is searched for
  std::optional<StraightLineSearchResult> search;   ///< then: how it went, its linkages moved out
  std::vector<StraightLineSolution> linkages;       ///< best first; of a place that was picked, layer by layer

  /// What the map is of; null without one.
  [[nodiscard]] const StraightLineFamily* family() const { return lines.get(); }
  [[nodiscard]] MapPoint point_of(const StraightLineSolution& found) const { return *lines->point_of(found.place); }
};

/// Everything found for a task, by its kind.
using Answer = std::variant<MotionAnswer, FunctionAnswer, SixBarAnswer, SphericalMotionAnswer, SphericalFunctionAnswer,
                            StraightLineAnswer, PathAnswer>;

/// What the answers of all kinds have in common.
[[nodiscard]] const Findings& findings(const Answer& answer);
[[nodiscard]] Findings& findings(Answer& answer);

/// By a search, how many linkages were looked at; nothing: the answer is not that of a search.
[[nodiscard]] std::optional<std::int64_t> looked_at_by_search(const Answer& answer);

/// How many linkages are listed.
[[nodiscard]] std::size_t linkage_count(const Answer& answer);

}  // namespace linkwright
