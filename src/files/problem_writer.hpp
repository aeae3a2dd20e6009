#pragma once

#include "files/json/json_writer.hpp"
#include "linkwright/region/linkage_class.hpp"

namespace linkwright {

/// Those of the class as one object, `respect_direction` last.
void write_requirements(JsonWriter& json, Requirements requirements, const LinkageClass& asked);

}  // namespace linkwright
