#pragma once

#include <optional>

#include "files/json/json_object.hpp"
#include "linkwright/files/displacement_file.hpp"

namespace linkwright {

/// A displacement in one of its forms (displacement_file.hpp), into the members `displacement`, `given` and
/// `small_turns_exact`; false, with a mistake, where it is something else.
bool read_displacement(const JsonValue& value, Mistakes& mistakes, DisplacementTask& task);

}  // namespace linkwright
