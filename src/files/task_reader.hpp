#pragma once

#include <optional>

#include "files/json/json_object.hpp"
#include "linkwright/synthesis/task.hpp"

namespace linkwright {

/// The object `task` of a problem file, by its kind and mechanism; `options_box`: `options.box`, in which a six-bar is
/// searched for. Mistakes in the file and in the task itself go to `mistakes`; the task then is as far as it was read.
[[nodiscard]] Task read_task(const JsonValue& value, const std::optional<Box>& options_box, Mistakes& mistakes);

/// `{"x": [low, high], "y": [low, high]}`.
[[nodiscard]] std::optional<Box> read_box(const JsonValue& value, Mistakes& mistakes);

}  // namespace linkwright
