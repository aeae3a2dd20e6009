#pragma once

#include <vector>

#include "files/json/json_writer.hpp"
#include "linkwright/core/result.hpp"
#include "linkwright/planar/burmester_curve.hpp"
#include "linkwright/region/requirement_filter.hpp"

namespace linkwright {

/// `[{"code": …, "message": …}, …]`.
void write_notices(JsonWriter& json, const std::vector<Notice>& notices);

/// `[{"name": …, "from": τ, "to": τ}, …]`.
void write_branches(JsonWriter& json, const std::vector<CurveBranch>& branches);

/// `"value": …`, as a problem file wants it: a number, a box or null.
void write_relaxed_value(JsonWriter& json, const Relaxation& relaxation);
/// Of a linkage at a picked place: `"meets_requirements"`, and `"fails"` where it does not.
void write_failures(JsonWriter& json, const std::vector<RequirementKind>& failed);
/// `{"requirements": […], "leaves": …}`.
void write_joint_relaxation(JsonWriter& json, const JointRelaxation& joint);

}  // namespace linkwright
