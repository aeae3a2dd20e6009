#pragma once

#include <optional>

#include "files/json/json_object.hpp"
#include "linkwright/algebra/directed_line.hpp"

namespace linkwright {

/// The object `{"point": [x, y], "direction_deg": …}`; nothing, with a mistake, where it is something else.
[[nodiscard]] std::optional<LineAtAngle> read_line(const JsonValue& value, Mistakes& mistakes);

}  // namespace linkwright
