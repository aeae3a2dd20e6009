#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "json_document.hpp"
#include "linkwright/core/result.hpp"

namespace linkwright {

/// "line 3, column 14" of a byte of the text, from 1; columns count characters, not bytes.
[[nodiscard]] std::string line_and_column(std::string_view text, std::size_t offset);

/// What can be said before parsing, in one pass: emptiness, size, NUL bytes, nesting. Nothing when all is well.
[[nodiscard]] std::optional<Error> scan_json(std::string_view text, const JsonLimits& limits);

}  // namespace linkwright
