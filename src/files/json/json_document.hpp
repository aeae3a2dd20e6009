#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "files/json/json_fwd.hpp"
#include "linkwright/core/result.hpp"

namespace linkwright {

struct JsonLimits {
  std::size_t max_bytes = 16u << 20;
  int deepest_nesting = 64;
  /// Which members of the outermost object are kept; the others are checked and dropped. Empty: all.
  std::vector<std::string_view> kept;
};

/// A JSON text with `//` comments as a tree, or all that is wrong with it as JSON: size, nesting, characters, syntax
/// (with line and column), numbers too large for a double, keys given twice. Nothing is thrown and nothing recurses
/// deeper than the nesting allowed. A byte order mark is skipped.
[[nodiscard]] Result<Json> parse_json(std::string_view text, const JsonLimits& limits);

}  // namespace linkwright
