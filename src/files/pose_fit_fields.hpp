#pragma once

#include "fields/field_visitor.hpp"
#include "linkwright/planar/near_poses.hpp"

// How near a body comes to poses, in results and in analyses.
namespace linkwright {

/// The member `error`.
void error_field(FieldVisitor& v, const PoseFitError& error);
/// The member `at`.
void nearest_field(FieldVisitor& v, const NearMiss& miss);
/// The members `within_tolerance` and `outside`.
void tolerance_fields(FieldVisitor& v, const NearMiss& miss);

}  // namespace linkwright
