#pragma once

#include <string>

#include "fields/field_visitor.hpp"
#include "files/axis_label.hpp"
#include "linkwright/files/linkage_file.hpp"
#include "linkwright/synthesis/answer.hpp"

// Planar four-bars in files: motion and function tasks, and what is found for them.
namespace linkwright {

/// As task_label() and short_task_label().
[[nodiscard]] std::string label_of(const MotionTask& task);
[[nodiscard]] std::string label_of(const FunctionTask& task);
[[nodiscard]] std::string short_label_of(const MotionTask& task);
[[nodiscard]] std::string short_label_of(const FunctionTask& task);

[[nodiscard]] AxisLabel axis_label(const MotionAnswer& answer, Side side, std::string_view length_unit);
[[nodiscard]] AxisLabel axis_label(const FunctionAnswer& answer, Side side, std::string_view length_unit);

/// A result has a map.
[[nodiscard]] inline bool is_mapped(const FourBarAnswer& /*answer*/) { return true; }
/// The grounded links form a curve, even where it has grown to everything.
[[nodiscard]] bool is_curve_expected(const MotionTask& task);
[[nodiscard]] bool is_curve_expected(const FunctionTask& task);
/// What stands in these members of a result.
void visit_curve(FieldVisitor& v, const FourBarAnswer& answer);
void visit_dyads(FieldVisitor& v, const FourBarAnswer& answer);
void visit_linkages(FieldVisitor& v, const FourBarAnswer& answer);
void visit_pairs(FieldVisitor& v, const FourBarAnswer& answer);
void visit_freed(FieldVisitor& v, const MotionAnswer& answer);

/// A linkage of an answer without title and unit.
[[nodiscard]] StoredLinkage stored(const FourBarSolution& found, const MotionAnswer& answer);
[[nodiscard]] StoredLinkage stored(const FourBarSolution& found, const FunctionAnswer& answer);

}  // namespace linkwright
