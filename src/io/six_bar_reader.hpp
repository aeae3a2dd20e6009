#pragma once

#include <optional>

#include "json_object.hpp"
#include "linkwright/io/six_bar_file.hpp"
#include "mistakes.hpp"

namespace linkwright {

/// Whether the value says that it is a six-bar.
[[nodiscard]] bool says_six_bar(const JsonValue& value);

/// Hinges, row and elbow of an element of a result's `linkages`; nothing, with mistakes, where it is none.
[[nodiscard]] std::optional<StoredSixBar> read_six_bar(const JsonValue& value, Mistakes& mistakes);

}  // namespace linkwright
