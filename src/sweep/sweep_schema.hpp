#pragma once

#include "files/fields/field_schema.hpp"

namespace linkwright {

/// The schema of sweep files, as problem_schema().
[[nodiscard]] OrderedJson sweep_schema(const OrderedJson& rules = OrderedJson::object());

}  // namespace linkwright
