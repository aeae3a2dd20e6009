#pragma once

#include "fields/field_visitor.hpp"
#include "linkwright/function/function_error.hpp"

namespace linkwright {

/// What a linkage of a result says of the function that it generates, as members of it; nothing of others.
void function_error_fields(FieldVisitor& v, const std::optional<FunctionError>& of);

}  // namespace linkwright
