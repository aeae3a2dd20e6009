#pragma once

#include <vector>

#include "json_writer.hpp"
#include "linkwright/planar/burmester_curve.hpp"

namespace linkwright {

/// `[{"name": …, "from": τ, "to": τ}, …]`.
void write_branches(JsonWriter& json, const std::vector<CurveBranch>& branches);

}  // namespace linkwright
