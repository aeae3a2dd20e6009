#pragma once

#include <string>

#include "fields/field_visitor.hpp"
#include "files/axis_label.hpp"
#include "linkwright/files/linkage_file.hpp"
#include "linkwright/synthesis/answer.hpp"

// Straight lines in files: their tasks, and what is found for them.
namespace linkwright {

/// As task_label() and short_task_label().
[[nodiscard]] std::string label_of(const StraightLineTask& task);
[[nodiscard]] std::string short_label_of(const StraightLineTask& task);

[[nodiscard]] AxisLabel axis_label(const StraightLineAnswer& answer, Side side, std::string_view length_unit);

/// A result has a map: some number is left open.
[[nodiscard]] bool is_mapped(const StraightLineAnswer& answer);
/// What stands in this member of a result.
void visit_linkages(FieldVisitor& v, const StraightLineAnswer& answer);

/// A linkage of an answer without title and unit; its poses are those of the coupler at the ends of the usable length
/// and where the point is on the line.
[[nodiscard]] StoredLinkage stored(const StraightLineSolution& found, const StraightLineAnswer& answer);

}  // namespace linkwright
