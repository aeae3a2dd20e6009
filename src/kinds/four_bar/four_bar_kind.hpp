#pragma once

#include <string>

#include "fields/field_visitor.hpp"
#include "files/axis_label.hpp"
#include "files/linkage_columns.hpp"
#include "linkwright/files/linkage_file.hpp"
#include "linkwright/synthesis/answer.hpp"
#include "solve/of_all_kinds.hpp"
#include "synthesis/pair_answer.hpp"
#include "synthesis/warnings.hpp"

// Planar four-bars that guide a body, generate a function or lead a point along a path: what kinds/kinds.hpp asks of
// them.
namespace linkwright {

// Found.

/// How a linkage listed lies in the positions of the task.
[[nodiscard]] inline LinkageOutput output_of(const FourBarAnswer& answer, const FourBarSolution& found) {
  return answer.family()->output_of(answer.point_of(found), found.four_bar);
}

// Of a session.

[[nodiscard]] bool serves(const MotionAnswer& known, const Problem& before, const Problem& now);
[[nodiscard]] bool serves(const PathAnswer& known, const Problem& before, const Problem& now);
[[nodiscard]] Requirements with_defaults(Requirements wanted, const FourBarAnswer& known);
[[nodiscard]] Notice nothing_on_map(const FourBarAnswer& known, const RegionMap& map);
[[nodiscard]] LinkPolygon links_along(const FourBarAnswer& known, Side side);
[[nodiscard]] std::vector<CurveMark> marks_of(const MotionAnswer& known);
[[nodiscard]] ShownAxis shown_axis(const FourBarAnswer& known, Side side, int order, const ShownAxis* before);
[[nodiscard]] std::vector<double> coordinates_of(const FourBarAnswer& known, const LinkageFamily& family,
                                                 const MapRequest& request, const ShownAxis& shown, Side side);
[[nodiscard]] int live_samples(const FunctionAnswer& known, int asked);
[[nodiscard]] int live_samples(const PathAnswer& known, int asked);
[[nodiscard]] std::vector<MissedBox> boxes_missed(const FourBarAnswer& known);
bool write_property(const MotionAnswer& known, const ColouredMap& map, std::string_view property,
                    std::span<float> values);
bool write_property(const FunctionAnswer& known, const ColouredMap& map, std::string_view property,
                    std::span<float> values);
[[nodiscard]] std::optional<FourBarSolution> solution_at(const MotionAnswer& known, MapPoint place, bool verify);
[[nodiscard]] std::optional<FourBarSolution> solution_at(const FunctionAnswer& known, MapPoint place, bool verify);
[[nodiscard]] std::optional<FourBarSolution> solution_at(const PathAnswer& known, MapPoint place, bool verify);
void describe(PickedLinkage& picked, const FourBarAnswer& known, const FourBarSolution* found);
[[nodiscard]] double residual_of(const FourBarSolution& found);
[[nodiscard]] const GeneratorFamily* generators_of(const FunctionAnswer& known);

// In files.

void fields(FieldVisitor& v, MotionTask& task);
void fields(FieldVisitor& v, FunctionTask& task);
void fields(FieldVisitor& v, PathTask& task);

[[nodiscard]] std::string label_of(const MotionTask& task);
[[nodiscard]] std::string label_of(const FunctionTask& task);
[[nodiscard]] std::string label_of(const PathTask& task);
[[nodiscard]] std::string short_label_of(const MotionTask& task);
[[nodiscard]] std::string short_label_of(const FunctionTask& task);
[[nodiscard]] std::string short_label_of(const PathTask& task);

[[nodiscard]] AxisLabel axis_label(const MotionAnswer& answer, Side side, std::string_view length_unit);
[[nodiscard]] AxisLabel axis_label(const FunctionAnswer& answer, Side side, std::string_view length_unit);
[[nodiscard]] AxisLabel axis_label(const PathAnswer& answer, Side side, std::string_view length_unit);

/// A result has a map.
[[nodiscard]] inline bool is_mapped(const FourBarAnswer& /*answer*/) { return true; }
/// The grounded links form a curve, even where it has grown to everything.
[[nodiscard]] bool is_curve_expected(const MotionTask& task);
[[nodiscard]] bool is_curve_expected(const FunctionTask& task);
[[nodiscard]] bool is_curve_expected(const PathTask& task);
/// What stands in these members of a result.
void visit_curve(FieldVisitor& v, const FourBarAnswer& answer);
void visit_dyads(FieldVisitor& v, const FourBarAnswer& answer);
void visit_linkages(FieldVisitor& v, const FourBarAnswer& answer);
void visit_pairs(FieldVisitor& v, const FourBarAnswer& answer);
void visit_freed(FieldVisitor& v, const MotionAnswer& answer);
void visit_cranks(FieldVisitor& v, const PathAnswer& answer);

/// The columns of its linkages in a table.
void list_columns(LinkageColumns& list, const MotionTask& task);
void list_columns(LinkageColumns& list, const FunctionTask& task);
void list_columns(LinkageColumns& list, const PathTask& task);

/// A linkage of an answer without title and unit.
[[nodiscard]] StoredLinkage stored(const FourBarSolution& found, const MotionAnswer& answer);
[[nodiscard]] StoredLinkage stored(const FourBarSolution& found, const FunctionAnswer& answer);
[[nodiscard]] StoredLinkage stored(const FourBarSolution& found, const PathAnswer& answer);

// Drawn.

/// As draw_answer(): the best four-bar in its task, the solution region, the numbers.
[[nodiscard]] std::string draw_sheet(const Problem& problem, const MotionAnswer& answer);
[[nodiscard]] std::string draw_sheet(const Problem& problem, const FunctionAnswer& answer);
[[nodiscard]] std::string draw_sheet(const Problem& problem, const PathAnswer& answer);

}  // namespace linkwright
