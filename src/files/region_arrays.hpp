#pragma once

#include "fields/field_visitor.hpp"
#include "linkwright/region/region_map.hpp"

namespace linkwright {

/// The members `type`, `defects`, `valid` and `properties` of a result's region: u8 and little-endian f32, row-major
/// [input][output], encoded row by row.
void region_array_fields(FieldVisitor& v, const RegionMap& region, bool are_written);

}  // namespace linkwright
