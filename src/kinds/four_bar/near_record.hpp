#pragma once

#include <optional>

#include "fields/field_visitor.hpp"
#include "linkwright/planar/near_poses.hpp"

namespace linkwright {

/// The member `near` of a linkage in a result file; nothing: its task has no near poses.
void near_field(FieldVisitor& v, const std::optional<NearMiss>& near);

}  // namespace linkwright
