#pragma once

#include <string>
#include <string_view>

namespace linkwright {

/// Without blanks and ends of lines at its ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// Trimmed, its ASCII letters small.
[[nodiscard]] std::string in_small_letters(std::string_view text);

/// The number that a text begins with, after blanks; not a number where it begins with none.
[[nodiscard]] double leading_number(std::string_view text);

}  // namespace linkwright
