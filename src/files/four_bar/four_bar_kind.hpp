#pragma once

#include <string>

#include "files/axis_label.hpp"
#include "files/json/json_writer.hpp"
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
/// The members `curve` and `dyads` of a result.
void write_dyads(JsonWriter& json, const MotionAnswer& answer);
void write_dyads(JsonWriter& json, const FunctionAnswer& answer);
/// The members `linkages`, `pairs` and `freed` of a result.
void write_linkages(JsonWriter& json, const MotionAnswer& answer);
void write_linkages(JsonWriter& json, const FunctionAnswer& answer);

/// A linkage of an answer without title and unit.
[[nodiscard]] StoredLinkage stored(const FourBarSolution& found, const MotionAnswer& answer);
[[nodiscard]] StoredLinkage stored(const FourBarSolution& found, const FunctionAnswer& answer);

}  // namespace linkwright
