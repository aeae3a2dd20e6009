#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "fields/field_visitor.hpp"
#include "files/linkage_columns.hpp"
#include "linkwright/analyses/tolerance_study.hpp"
#include "linkwright/core/progress.hpp"
#include "linkwright/mechanism/linkage_output.hpp"
#include "linkwright/region/added_measures.hpp"
#include "linkwright/region/linkage_family.hpp"
#include "linkwright/robust/tolerance_report.hpp"
#include "linkwright/robust/tolerances.hpp"
#include "linkwright/synthesis/answer.hpp"

// Tolerances as an analysis: the block `tolerances` beside a task, what they do to the cells of a map and to the
// linkages listed.
namespace linkwright {

// The block.
void fields(FieldVisitor& v, Tolerances& tolerances);

/// What of tolerances does not go with the task, and what asks for tolerances, or for a limit of them, where there are
/// none.
[[nodiscard]] std::vector<Error> mistakes_about_tolerances(const Task& task, const Requirements& wanted,
                                                           const SynthesisOptions& options);

/// The error to first order, and `with_sampled`, where there is a limit, the yield by few samples, of a family's
/// linkages. The turning length is set. The family must outlive them.
[[nodiscard]] AddedMeasures tolerance_measures(const LinkageFamily& family, const Tolerances& tolerances,
                                               bool with_sampled);

/// Findings::tolerance of the linkages listed, by the tolerances of the options, which are there; those that do not
/// meet by it what is required are left out, and a warning says so, but not what is at a place that was asked for;
/// where these rank them, the list is put in their order. Cancelled: of those that were reached.
void report_tolerances(Answer& answer, const Progress& progress = {});

/// An error as people read it: of functions and spheres degrees, which the engine has in radians.
[[nodiscard]] double readable_error(const LinkageOutput& output, double error);

/// `tolerance` of a linkage: what tolerances do to it. The seed is that of the samples.
struct ToleranceRecord {
  const ToleranceReport& report;
  std::uint64_t seed;
};
void fields(FieldVisitor& v, const ToleranceRecord& of);

/// A file of its own.
void fields(FieldVisitor& v, const ToleranceStudy& of);

/// The columns of a table of linkages.
void list_tolerances(LinkageColumns& list, const Task& task);

/// The member `tolerance` of the linkage number `place` of an answer; null: of one that is in no list.
void tolerance_field(FieldVisitor& v, const Findings* found, std::size_t place);

}  // namespace linkwright
