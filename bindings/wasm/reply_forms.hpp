#pragma once

#include <limits>
#include <string>
#include <string_view>

#include "fields/field_visitor.hpp"
#include "linkwright/region/map_axis.hpp"

// Values that several replies have.
namespace linkwright::wasm {

inline constexpr Whole natural = {0, std::numeric_limits<std::int32_t>::max()};
/// -1: there is none.
inline constexpr Whole natural_or_none = {-1, std::numeric_limits<std::int32_t>::max()};
inline constexpr List pair = {.what = "", .least = 2, .most = 2, .is_of_length = true};
inline constexpr List four = {.what = "", .least = 4, .most = 4, .is_of_length = true};

/// A member as it stands in result files. `name`: of the definition there.
void member_of_results(FieldVisitor& v, const Field& field, std::string_view name, Visit value);
/// The member `tau`.
void place_field(FieldVisitor& v, MapPoint place);
/// The member `record`: JSON text of an element of a result's `linkages`, of any kind; `or_null`: empty for none.
void record_field(FieldVisitor& v, std::string record, bool or_null);

}  // namespace linkwright::wasm
