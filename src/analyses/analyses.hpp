#pragma once

#include <cstddef>
#include <memory>
#include <string_view>
#include <vector>

#include "fields/field_visitor.hpp"
#include "files/linkage_columns.hpp"
#include "linkwright/core/progress.hpp"
#include "linkwright/core/result.hpp"
#include "linkwright/region/added_measures.hpp"
#include "linkwright/region/linkage_family.hpp"
#include "linkwright/synthesis/answer.hpp"
#include "linkwright/synthesis/options.hpp"

// What can be asked beside any task. An analysis has a folder here and its line in each of these functions; what it
// measures it requires and ranks by rows of the tables of criteria and objectives.
namespace linkwright {

/// The blocks beside the task in a problem file, whose lengths are in this unit.
void analysis_fields(FieldVisitor& v, SynthesisOptions& options, std::string_view length_unit);

/// Mistakes in the blocks.
[[nodiscard]] std::vector<Error> mistakes_in_analyses(const SynthesisOptions& options);

/// What of the blocks does not go with the task, and what asks for an analysis whose block is missing.
[[nodiscard]] std::vector<Error> mistakes_in_analyses(const Task& task, const Requirements& wanted,
                                                      const SynthesisOptions& options);

/// The blocks with the defaults of a task of this characteristic length, user's unit, filled in.
[[nodiscard]] SynthesisOptions with_task_defaults(SynthesisOptions options, double characteristic_length);

/// The blocks for lists that people wait for: with fewer samples, which move a linkage by a place or two.
[[nodiscard]] SynthesisOptions reported_soon(SynthesisOptions options);

/// Whether the blocks say the same.
[[nodiscard]] bool analyze_alike(const SynthesisOptions& a, const SynthesisOptions& b);

/// What the options ask of the linkages of a map, which must outlive it, and what the task does (Findings::of_task);
/// `with_sampled` what is sampled, too.
[[nodiscard]] AddedMeasures added_measures(const LinkageFamily& family, const SynthesisOptions& options,
                                           const std::shared_ptr<const CellMeasure>& of_task, bool with_sampled = true);

/// Of the linkages listed; those that do not meet by it what is required are left out. Cancelled: of those reached.
/// Stricter requirements by which a search is likely to end at linkages that are not left out; nothing: none was.
std::optional<Requirements> report_analyses(Answer& answer, const Progress& progress = {});

/// Of linkages that come from two lists, each with its reports: what is to be warned of, and their order.
void analyses_of_list(Answer& answer);

/// The members of the linkage number `place` of an answer in a result file; null: of one that is in no list.
void report_fields(FieldVisitor& v, const Findings* found, std::size_t place);

/// Their columns in tables of linkages.
void list_analyses(LinkageColumns& list, const Problem& problem);

/// The files that studies of one linkage write.
[[nodiscard]] std::vector<Shape> study_documents();

}  // namespace linkwright
