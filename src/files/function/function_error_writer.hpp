#pragma once

#include "files/json/json_writer.hpp"
#include "linkwright/function/function_error.hpp"

namespace linkwright {

/// What a linkage of a result says of the function that it generates.
void write_function_error(JsonWriter& json, const FunctionError& error);

}  // namespace linkwright
