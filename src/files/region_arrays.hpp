#pragma once

#include "files/json/json_writer.hpp"
#include "linkwright/region/region_map.hpp"

namespace linkwright {

/// The members `type`, `defects` and `properties` of a result's region: base64 of u8 and of little-endian f32,
/// row-major [input][output], encoded row by row.
void write_region_arrays(JsonWriter& json, const RegionMap& region);

}  // namespace linkwright
