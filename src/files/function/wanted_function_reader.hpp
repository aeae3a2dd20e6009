#pragma once

#include "files/json/json_object.hpp"
#include "linkwright/function/wanted_function.hpp"

namespace linkwright {

/// The members `pairs` or `function`, and `free`, of a task of any mechanism; false where one cannot be read. `value`:
/// the task.
[[nodiscard]] bool read_wanted_function(const JsonObject& object, const JsonValue& value, Mistakes& mistakes,
                                        WantedFunction& wanted);

}  // namespace linkwright
