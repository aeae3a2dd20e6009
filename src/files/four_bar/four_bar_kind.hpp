#pragma once

#include <string>

#include "files/axis_label.hpp"
#include "files/json/json_writer.hpp"
#include "files/task_form.hpp"
#include "linkwright/files/linkage_file.hpp"
#include "linkwright/synthesis/answer.hpp"

// Planar four-bars in files: motion and function tasks, and what is found for them.
namespace linkwright {

[[nodiscard]] Task read_motion(const JsonValue& value, const std::optional<Box>& options_box, Mistakes& mistakes);
[[nodiscard]] Task read_function_task(const JsonValue& value, const std::optional<Box>& options_box,
                                      Mistakes& mistakes);
inline constexpr TaskForm motion_by_four_bar{"motion", "four_bar", read_motion};
inline constexpr TaskForm function_by_four_bar{"function", "four_bar", read_function_task};

/// The members of the object `task`.
void write_of_kind(JsonWriter& json, const MotionTask& task);
void write_of_kind(JsonWriter& json, const FunctionTask& task);

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
