#pragma once

#include "files/json/json_writer.hpp"
#include "linkwright/function/function_error.hpp"
#include "linkwright/function/wanted_function.hpp"

// What the page is told of function generation, degrees on the task's dials (web/src/engine/protocol.ts).
namespace linkwright::wasm {

/// WantedFunction: the pairs, and the named function between them.
void write_wanted_function(JsonWriter& json, const WantedFunction& wanted);

/// GeneratedFunction: what a linkage makes of `wanted`, whose free parameter is fixed.
void write_generated_function(JsonWriter& json, const WantedFunction& wanted, const FunctionError& error);

}  // namespace linkwright::wasm
