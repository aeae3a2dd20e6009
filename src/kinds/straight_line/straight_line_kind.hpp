#pragma once

#include <string>

#include "fields/field_visitor.hpp"
#include "files/axis_label.hpp"
#include "files/linkage_columns.hpp"
#include "linkwright/core/progress.hpp"
#include "linkwright/core/result.hpp"
#include "linkwright/files/linkage_file.hpp"
#include "linkwright/synthesis/answer.hpp"
#include "solve/of_all_kinds.hpp"
#include "synthesis/warnings.hpp"

// Planar four-bars whose coupler point runs along a line: what kinds/kinds.hpp asks of them.
namespace linkwright {

// Found.

/// What is known of a straight line before linkages are looked for; `task` without mistakes.
[[nodiscard]] StraightLineAnswer begin_answer(const StraightLineTask& task, const Requirements& requirements,
                                              const SynthesisOptions& options, const Progress& progress = {});

/// Everything found for a straight line; `task` without mistakes. Cancelled: an error.
[[nodiscard]] Result<Answer> solve_of_kind(const StraightLineTask& task, const Requirements& requirements,
                                           const SynthesisOptions& options, const Progress& progress);

/// The longest link at most ten times the size of the task, where nothing else is asked for.
[[nodiscard]] Requirements with_default_length(Requirements wanted, const StraightLineTask& task);

/// Why a map holds nothing at all.
[[nodiscard]] Notice no_straight_line(const StraightLineTask& task);

/// Linkages that the triangles of their links do not confirm, or the referee of their contact; with a warning.
void leave_out_unconfirmed(StraightLineAnswer& answer);

/// Straight lines are ranked by what locking ends: there is nothing to warn of.
inline void warn_of_locking(const StraightLineAnswer& /*answer*/, const Progress& /*progress*/) {}

/// How a linkage listed lies along the line; nothing where it does not reach the ends.
[[nodiscard]] inline std::optional<LinkageOutput> output_of(const StraightLineAnswer& answer,
                                                            const StraightLineSolution& found) {
  return StraightLineFamily(found.task, answer.options.line)
      .output_of(found.linkage, StraightLineFamily::places_of_line);
}

// Of a session.

[[nodiscard]] bool serves(const StraightLineAnswer& known, const Problem& before, const Problem& now);
[[nodiscard]] Requirements with_defaults(Requirements wanted, const StraightLineAnswer& known);
[[nodiscard]] Notice no_map(const StraightLineAnswer& known);
[[nodiscard]] Notice nothing_on_map(const StraightLineAnswer& known, const RegionMap& map);
[[nodiscard]] LinkPolygon links_along(const StraightLineAnswer& known, Side side);
[[nodiscard]] ShownAxis shown_axis(const StraightLineAnswer& known, Side side, int order, const ShownAxis* before);
[[nodiscard]] std::vector<double> coordinates_of(const StraightLineAnswer& known, const LinkageFamily& family,
                                                 const MapRequest& request, const ShownAxis& shown, Side side);
[[nodiscard]] int live_samples(const StraightLineAnswer& known, int asked);
[[nodiscard]] int samples_for_best(const StraightLineAnswer& known);
[[nodiscard]] bool window_sets_axes(const StraightLineAnswer& known);
[[nodiscard]] std::optional<StraightLineSolution> solution_at(const StraightLineAnswer& known, MapPoint place,
                                                              bool verify);
void describe(PickedLinkage& picked, const StraightLineAnswer& known, const StraightLineSolution* found);
[[nodiscard]] bool meets_exactly(const StraightLineAnswer& known, MapPoint place);
[[nodiscard]] double residual_of(const StraightLineSolution& found);

// In files.

void fields(FieldVisitor& v, StraightLineTask& task);

[[nodiscard]] std::string label_of(const StraightLineTask& task);
[[nodiscard]] std::string short_label_of(const StraightLineTask& task);

[[nodiscard]] AxisLabel axis_label(const StraightLineAnswer& answer, Side side, std::string_view length_unit);

/// A result has a map: some number is left open.
[[nodiscard]] bool is_mapped(const StraightLineAnswer& answer);
/// What stands in this member of a result.
void visit_linkages(FieldVisitor& v, const StraightLineAnswer& answer);

/// The columns of its linkages in a table.
void list_columns(LinkageColumns& list, const StraightLineTask& task);

/// A linkage of an answer without title and unit; its poses are those of the coupler at the ends of the usable length
/// and where the point is on the line.
[[nodiscard]] StoredLinkage stored(const StraightLineSolution& found, const StraightLineAnswer& answer);

// Drawn.

/// As draw_answer(const Problem&, const Answer&): the best linkage with its line, Ball's point and inflection circle;
/// the map; the deviation from the line, magnified; the numbers.
[[nodiscard]] std::string draw_sheet(const Problem& problem, const StraightLineAnswer& answer);

}  // namespace linkwright
