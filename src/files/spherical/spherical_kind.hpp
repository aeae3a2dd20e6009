#pragma once

#include <string>

#include "fields/field_visitor.hpp"
#include "files/axis_label.hpp"
#include "linkwright/files/spherical_file.hpp"
#include "linkwright/synthesis/answer.hpp"

// Spherical four-bars in files: their tasks, and what is found for them.
namespace linkwright {

/// As task_label() and short_task_label().
[[nodiscard]] std::string label_of(const SphericalMotionTask& task);
[[nodiscard]] std::string label_of(const SphericalFunctionTask& task);
[[nodiscard]] std::string short_label_of(const SphericalMotionTask& task);
[[nodiscard]] std::string short_label_of(const SphericalFunctionTask& task);

[[nodiscard]] AxisLabel axis_label(const SphericalMotionAnswer& answer, Side side, std::string_view length_unit);
[[nodiscard]] AxisLabel axis_label(const SphericalFunctionAnswer& answer, Side side, std::string_view length_unit);

/// A result has a map.
[[nodiscard]] inline bool is_mapped(const SphericalAnswer& /*answer*/) { return true; }
/// What stands in these members of a result.
void visit_curve(FieldVisitor& v, const SphericalAnswer& answer);
void visit_dyads(FieldVisitor& v, const SphericalAnswer& answer);
void visit_linkages(FieldVisitor& v, const SphericalAnswer& answer);
void visit_pairs(FieldVisitor& v, const SphericalAnswer& answer);
void visit_freed(FieldVisitor& v, const SphericalMotionAnswer& answer);

/// A linkage of an answer without title and unit.
[[nodiscard]] StoredSphericalFourBar stored(const SphericalSolution& found, const SphericalMotionAnswer& answer);
/// The orientations are those of its coupler at the pairs.
[[nodiscard]] StoredSphericalFourBar stored(const SphericalSolution& found, const SphericalFunctionAnswer& answer);

}  // namespace linkwright
