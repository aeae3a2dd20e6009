#pragma once

#include "fields/field_visitor.hpp"
#include "four_bar_record.hpp"

namespace linkwright {

/// The member `lengths` of a four-bar, of paths with both arms of the point.
void lengths_field(FieldVisitor& v, const FourBarSolution& found);

/// The members that only four-bars of paths have.
void path_fields(FieldVisitor& v, const FourBarSolution& found);

}  // namespace linkwright
