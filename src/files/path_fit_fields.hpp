#pragma once

#include "fields/field_visitor.hpp"
#include "linkwright/planar/fitted_path.hpp"

// How near a path passes to points, in results and in analyses.
namespace linkwright {

/// The member `error`.
void error_field(FieldVisitor& v, const CurveError& error);
/// The member `at`.
void nearest_field(FieldVisitor& v, const FittedPath& path);

}  // namespace linkwright
