#pragma once

#include <optional>
#include <string>

#include "fields/field_visitor.hpp"
#include "files/axis_label.hpp"
#include "files/json/json_object.hpp"
#include "files/json/mistakes.hpp"
#include "files/linkage_columns.hpp"
#include "linkwright/core/progress.hpp"
#include "linkwright/core/result.hpp"
#include "linkwright/files/six_bar_file.hpp"
#include "linkwright/synthesis/answer.hpp"
#include "solve/of_all_kinds.hpp"
#include "synthesis/warnings.hpp"

// Planar six-bars that guide a body: what kinds/kinds.hpp asks of them.
namespace linkwright {

// Found.

/// What is known of a six-bar task without mistakes before linkages are looked for.
[[nodiscard]] SixBarAnswer begin_answer(const SixBarTask& task, const Requirements& requirements,
                                        const SynthesisOptions& options, const Progress& progress = {});

/// Everything found for a six-bar task without mistakes: with a chain the map over both added links and its best,
/// without one the best of a search. A search that is cancelled answers with the best so far; a map says that it was
/// cancelled.
[[nodiscard]] Result<Answer> solve_of_kind(const SixBarTask& task, const Requirements& requirements,
                                           const SynthesisOptions& options, const Progress& progress);

/// How a linkage listed lies in the positions of the task.
[[nodiscard]] inline LinkageOutput output_of(const SixBarAnswer& answer, const SixBarSolution& found) {
  return output_of(found.member, answer.task.poses.front().pose);
}

// Of a session.

[[nodiscard]] Requirements with_defaults(Requirements wanted, const SixBarAnswer& known);
[[nodiscard]] Notice no_map(const SixBarAnswer& known);
[[nodiscard]] Notice nothing_on_map(const SixBarAnswer& known, const RegionMap& map);
[[nodiscard]] LinkPolygon links_along(const SixBarAnswer& known, Side side);
[[nodiscard]] ShownAxis shown_axis(const SixBarAnswer& known, Side side, int order, const ShownAxis* before);
[[nodiscard]] int live_samples(const SixBarAnswer& known, int asked);
[[nodiscard]] int halo_samples(const SixBarAnswer& known, int asked, std::size_t places);
[[nodiscard]] std::optional<SixBarSolution> solution_at(const SixBarAnswer& known, MapPoint place, bool verify);
void describe(PickedLinkage& picked, const SixBarAnswer& known, const SixBarSolution* found);
[[nodiscard]] std::optional<Notice> six_bar_defect(const SixBarDriveReport& drive);
[[nodiscard]] double residual_of(const SixBarSolution& found);

// In files.

void fields(FieldVisitor& v, SixBarTask& task);

[[nodiscard]] std::string label_of(const SixBarTask& task);
[[nodiscard]] std::string short_label_of(const SixBarTask& task);

[[nodiscard]] AxisLabel axis_label(const SixBarAnswer& answer, Side side, std::string_view length_unit);

/// A result has a map: of a given chain.
[[nodiscard]] inline bool is_mapped(const SixBarAnswer& answer) { return !answer.search; }
/// What stands in these members of a result.
void visit_search(FieldVisitor& v, const SixBarAnswer& answer);
void visit_linkages(FieldVisitor& v, const SixBarAnswer& answer);

/// The columns of its linkages in a table.
void list_columns(LinkageColumns& list, const SixBarTask& task);

/// A linkage of an answer without title and unit.
[[nodiscard]] StoredSixBar stored(const SixBarSolution& found, const SixBarAnswer& answer);

/// Members `topology`, `chain`, `added` and `joints`. `coordinates`: τ of the added links, or none.
void make_up_fields(FieldVisitor& v, const SixBar& six_bar, const std::array<int, 4>& assembly_mode,
                    std::span<const double> coordinates);

/// Whether the value says that it is a six-bar.
[[nodiscard]] bool says_six_bar(const JsonValue& value);

/// Hinges, row and elbow of an element of a result's `linkages`; nothing, with mistakes, where it is none.
[[nodiscard]] std::optional<StoredSixBar> read_six_bar(const JsonValue& value, Mistakes& mistakes);

// Drawn.

/// As draw_answer(const Problem&, const Answer&): the best six-bar; the map of its chain, or of a search what it has
/// found; the numbers.
[[nodiscard]] std::string draw_sheet(const Problem& problem, const SixBarAnswer& answer);

}  // namespace linkwright
