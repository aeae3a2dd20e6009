#pragma once

#include <string_view>

#include "files/json/json_writer.hpp"
#include "linkwright/attitude/screw.hpp"

namespace linkwright {

/// "identity", "pure_translation", "half_turn", "general".
[[nodiscard]] std::string_view name(ScrewKind kind);

/// The members `kind`, `axis`, `axis_defined`, `point` (null where every line of the direction is an axis),
/// `angle_deg`, `slide`, `pitch` (per radian; null where infinite).
void write_screw(JsonWriter& json, const Screw& screw);

}  // namespace linkwright
