#pragma once

#include "files/json/json_writer.hpp"
#include "linkwright/function/function_error.hpp"
#include "linkwright/function/wanted_function.hpp"

namespace linkwright {

/// The member `function`, or `pairs` where there is none, of a task of any mechanism.
void write_pairs_or_function(JsonWriter& json, const WantedFunction& wanted);
/// The member `free`, where something is free.
void write_free_parameter(JsonWriter& json, const WantedFunction& wanted);

/// What a linkage of a result says of the function that it generates.
void write_function_error(JsonWriter& json, const FunctionError& error);

}  // namespace linkwright
