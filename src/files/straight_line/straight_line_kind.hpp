#pragma once

#include <string>

#include "files/axis_label.hpp"
#include "files/json/json_writer.hpp"
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
/// The members `curve` and `dyads` of a result, both empty: linkages of a straight line are found whole.
void write_dyads(JsonWriter& json, const StraightLineAnswer& answer);
/// The members `linkages`, `pairs` and `freed` of a result.
void write_linkages(JsonWriter& json, const StraightLineAnswer& answer);

/// How straight the point of a linkage runs, as members of it: `contact_points` and `deviation_series`; and the lengths
/// that are usable, with what is to be said over them and over the stroke asked for.
void write_contact(JsonWriter& json, const LineContact& contact);
void write_usable_lengths(JsonWriter& json, const StraightLineSolution& found, LineMeasure measure);
/// The member `cognates` of a linkage: the others whose point traces the same curve.
void write_cognates(JsonWriter& json, const StraightLineSolution& found);
/// A linkage of an answer without title and unit; its poses are those of the coupler at the ends of the usable length
/// and where the point is on the line.
[[nodiscard]] StoredLinkage stored(const StraightLineSolution& found, const StraightLineAnswer& answer);

}  // namespace linkwright
