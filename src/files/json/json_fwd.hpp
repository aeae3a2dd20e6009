#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace linkwright {

/// A JSON tree; json.hpp has its members. Code outside this folder names the library by these alone.
using Json = nlohmann::json;
using JsonPointer = nlohmann::json_pointer<std::string>;
/// Members stay in the order in which they were added.
using OrderedJson = nlohmann::ordered_json;

}  // namespace linkwright
