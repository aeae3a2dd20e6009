#pragma once

#include "files/json/json_writer.hpp"
#include "linkwright/synthesis/answer.hpp"

// What a result says of four-bars; the members of an object that is open.
namespace linkwright {

/// A map is asked for.
[[nodiscard]] inline bool is_mapped(const FourBarAnswer& /*answer*/) { return true; }

/// `curve` and `dyads`.
void write_dyads(JsonWriter& json, const MotionAnswer& answer);
void write_dyads(JsonWriter& json, const FunctionAnswer& answer);

/// `linkages`, `pairs` and `freed`.
void write_linkages(JsonWriter& json, const MotionAnswer& answer);
void write_linkages(JsonWriter& json, const FunctionAnswer& answer);

}  // namespace linkwright
