#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace linkwright {

/// Least number of inserted, removed, replaced or exchanged neighbouring characters that turns `a` into `b`
/// (V. Levenshtein 1966, with F. Damerau's exchange of 1964).
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b);

/// The known name nearest to what was written; the first of equals. `known` is not empty. A name that is not like it –
/// more than half of its letters differ – is not offered: empty.
[[nodiscard]] std::string_view nearest_name(std::string_view written, std::span<const std::string_view> known);

/// The text in which bytes that are not UTF-8 have become U+FFFD.
[[nodiscard]] std::string well_formed(std::string_view text);

/// A name from a file as messages show it: well formed, control characters replaced, cut when long.
[[nodiscard]] std::string presentable(std::string_view name);

/// The same in double quotes.
[[nodiscard]] std::string in_quotes(std::string_view name);

}  // namespace linkwright
