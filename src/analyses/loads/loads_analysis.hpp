#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "fields/field_visitor.hpp"
#include "files/linkage_columns.hpp"
#include "linkwright/analyses/load_study.hpp"
#include "linkwright/core/progress.hpp"
#include "linkwright/loads/load_report.hpp"
#include "linkwright/loads/loads.hpp"
#include "linkwright/region/added_measures.hpp"
#include "linkwright/region/linkage_family.hpp"
#include "linkwright/synthesis/answer.hpp"

// Loads as an analysis: the block `loads` beside a task, the forces in the cells of a map and in the linkages listed.
namespace linkwright {

// The block, and a spring of it.
void fields(FieldVisitor& v, Loads& loads);
void fields(FieldVisitor& v, Spring& spring);
void fields(FieldVisitor& v, CarriedPoint& point);

/// A result's problem has no loads.
[[nodiscard]] Error no_loads();

/// What of loads does not go with the task, and what asks for loads, or for a hand or drive of them, where there is
/// none.
[[nodiscard]] std::vector<Error> mistakes_about_loads(const Task& task, const Requirements& wanted,
                                                      const SynthesisOptions& options);

/// Linkages of the task carry loads.
[[nodiscard]] bool carries_loads(const Task& task);

/// The loads' drive or handle gives a read-out its value.
[[nodiscard]] bool has_value(ReadOut read_out, const Loads& loads);
/// A case counts for it.
[[nodiscard]] bool is_counted(ReadOut read_out, const Loads& loads);
/// Of a measure of ours; nothing: it is another's.
[[nodiscard]] std::optional<ReadOut> read_out_of(const Measure& measure);

/// The forces in a family's linkages, by the stations of the loads. The family must outlive them.
[[nodiscard]] AddedMeasures load_measures(const LinkageFamily& family, const Loads& loads);

/// Findings::loads of the linkages listed, by the loads of the options, which are there; those that do not meet by it
/// what is required are left out, and a warning says so, but not what is at a place that was asked for; where these
/// rank them, the list is put in their order. Cancelled: of those that were reached. What to require of a search by the
/// stations of a map, so that it ends where the report meets what is required; nothing: none was left out.
std::optional<Requirements> report_loads(Answer& answer, const Progress& progress = {});

/// Of reports that are there: what is to be warned of in the linkages listed, and their order where these rank them.
void loads_of_list(Answer& answer);

/// `loads` of a linkage.
void fields(FieldVisitor& v, const LoadReport& report);

void fields(FieldVisitor& v, const BalanceOfCase& of);

/// A file of its own.
[[nodiscard]] Shape load_study_document();

/// The columns of a table of linkages.
void list_loads(LinkageColumns& list, const Loads& loads);

/// The member `loads` of the linkage number `place` of an answer; null: of one that is in no list.
void loads_field(FieldVisitor& v, const Findings* found, std::size_t place);

}  // namespace linkwright
