#pragma once

#include "files/fields/field_schema.hpp"

namespace linkwright {

/// The schemas of what `linkwright loads --place-springs` and `--catalogue` read, as problem_schema().
[[nodiscard]] OrderedJson spring_boxes_schema(const OrderedJson& rules = OrderedJson::object());
[[nodiscard]] OrderedJson spring_catalogue_schema(const OrderedJson& rules = OrderedJson::object());

}  // namespace linkwright
