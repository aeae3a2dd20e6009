#pragma once

#include <optional>
#include <string_view>

#include "files/json/json_object.hpp"
#include "linkwright/synthesis/task.hpp"

namespace linkwright {

/// A kind of task as problem files name it, and how it is read. `options_box`: `options.box`. Mistakes in the file and
/// in the task itself go to `mistakes`; the task then is as far as it was read.
struct TaskForm {
  std::string_view kind, mechanism;
  Task (*read)(const JsonValue& value, const std::optional<Box>& options_box, Mistakes& mistakes);
};

}  // namespace linkwright
