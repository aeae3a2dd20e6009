#pragma once

#include "fields/field_visitor.hpp"
#include "linkwright/infinitesimal/instant_analysis.hpp"

namespace linkwright {

/// The object `instant` of an analysis and of a linkage of a result.
void fields(FieldVisitor& v, const InstantAnalysis& analysis);

}  // namespace linkwright
