#pragma once

#include "files/fields/field_schema.hpp"

namespace linkwright {

/// The schema of sweep files, as problem_schema().
[[nodiscard]] FieldSchema::Json sweep_schema(const FieldSchema::Json& rules = FieldSchema::Json::object());

}  // namespace linkwright
