#pragma once

#include <optional>
#include <string>

#include "fields/field_visitor.hpp"
#include "files/axis_label.hpp"
#include "files/json/json_object.hpp"
#include "files/linkage_columns.hpp"
#include "linkwright/files/spherical_file.hpp"
#include "linkwright/mechanism/spherical_four_bar.hpp"
#include "linkwright/synthesis/answer.hpp"
#include "solve/of_all_kinds.hpp"
#include "synthesis/pair_answer.hpp"
#include "synthesis/warnings.hpp"

// Spherical four-bars that guide a body about a fixed centre or generate a function: what kinds/kinds.hpp asks of them.
namespace linkwright {

// Found.

/// How a linkage listed lies in the positions of the task.
[[nodiscard]] inline LinkageOutput output_of(const SphericalAnswer& answer, const SphericalSolution& found) {
  return answer.family()->output_of(answer.point_of(found), found.four_bar);
}

// Of a session.

[[nodiscard]] Requirements with_defaults(Requirements wanted, const SphericalAnswer& known);
[[nodiscard]] Notice nothing_on_map(const SphericalAnswer& known, const RegionMap& map);
[[nodiscard]] LinkPolygon links_along(const SphericalAnswer& known, Side side);
[[nodiscard]] ShownAxis shown_axis(const SphericalAnswer& known, Side side, int order, const ShownAxis* before);
bool write_property(const SphericalFunctionAnswer& known, const ColouredMap& map, std::string_view property,
                    std::span<float> values);
[[nodiscard]] std::optional<SphericalSolution> solution_at(const SphericalMotionAnswer& known, MapPoint place,
                                                           bool verify);
[[nodiscard]] std::optional<SphericalSolution> solution_at(const SphericalFunctionAnswer& known, MapPoint place,
                                                           bool verify);
void describe(PickedLinkage& picked, const SphericalAnswer& known, const SphericalSolution* found);
[[nodiscard]] std::optional<Notice> spherical_defect(const DefectReport& report);
[[nodiscard]] double residual_of(const SphericalSolution& found);
[[nodiscard]] const GeneratorFamily* generators_of(const SphericalFunctionAnswer& known);

// In files.

void fields(FieldVisitor& v, SphericalMotionTask& task);
void fields(FieldVisitor& v, SphericalFunctionTask& task);

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

/// The columns of its linkages in a table.
void list_columns(LinkageColumns& list, const SphericalMotionTask& task);
void list_columns(LinkageColumns& list, const SphericalFunctionTask& task);

/// A linkage of an answer without title and unit.
[[nodiscard]] StoredSphericalFourBar stored(const SphericalSolution& found, const SphericalMotionAnswer& answer);
/// The orientations are those of its coupler at the pairs.
[[nodiscard]] StoredSphericalFourBar stored(const SphericalSolution& found, const SphericalFunctionAnswer& answer);

/// The member `mechanism` is "spherical_four_bar".
[[nodiscard]] bool says_spherical_four_bar(const JsonValue& value);

/// An element of a result's `linkages`, `axes` or `angles_deg` (read_any_linkage); nothing, with a mistake, where it
/// cannot be read.
[[nodiscard]] std::optional<SphericalFourBar> read_spherical_four_bar(const JsonValue& value, Mistakes& mistakes);

// Drawn.

/// As draw_answer(const Problem&, const Answer&): the map and the best linkage's numbers.
[[nodiscard]] std::string draw_sheet(const Problem& problem, const SphericalMotionAnswer& answer);
/// As draw_answer(const Problem&, const Answer&): the map, and what the best linkage generates.
[[nodiscard]] std::string draw_sheet(const Problem& problem, const SphericalFunctionAnswer& answer);

}  // namespace linkwright
