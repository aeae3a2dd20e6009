#pragma once

#include "files/json/json_writer.hpp"
#include "linkwright/synthesis/answer.hpp"

// What a result says of six-bars; the members of an object that is open.
namespace linkwright {

/// A map is asked for: of a given chain.
[[nodiscard]] inline bool is_mapped(const SixBarAnswer& answer) { return !answer.search; }

/// `curve` and `dyads`: six-bars have none of their own.
void write_dyads(JsonWriter& json, const SixBarAnswer& answer);

/// `search`, `linkages`, `pairs` and `freed`.
void write_linkages(JsonWriter& json, const SixBarAnswer& answer);

}  // namespace linkwright
