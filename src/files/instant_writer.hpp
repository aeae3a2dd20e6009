#pragma once

#include "files/json/json_writer.hpp"
#include "linkwright/infinitesimal/instant_analysis.hpp"

namespace linkwright {

/// The object `instant` of an analysis and of a linkage of a result: schema/result.schema.json, $defs.instant.
void write_instant(JsonWriter& json, const InstantAnalysis& analysis);

}  // namespace linkwright
