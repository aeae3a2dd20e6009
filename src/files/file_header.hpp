#pragma once

#include <optional>

#include "files/json/json_object.hpp"
#include "linkwright/core/result.hpp"

namespace linkwright {

/// Why a file of a newer version is refused before anything else is looked at; nothing for all other files.
[[nodiscard]] std::optional<Error> refuse_version(const JsonValue& root);

}  // namespace linkwright
