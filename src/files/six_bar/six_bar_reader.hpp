#pragma once

#include <optional>

#include "files/json/json_object.hpp"
#include "files/json/mistakes.hpp"
#include "linkwright/files/six_bar_file.hpp"

namespace linkwright {

/// Whether the value says that it is a six-bar.
[[nodiscard]] bool says_six_bar(const JsonValue& value);

/// Hinges, row and elbow of an element of a result's `linkages`; nothing, with mistakes, where it is none.
[[nodiscard]] std::optional<StoredSixBar> read_six_bar(const JsonValue& value, Mistakes& mistakes);

}  // namespace linkwright
