#pragma once

#include <string>

#include "linkwright/files/position_error.hpp"
#include "text_table.hpp"

namespace linkwright::cli {

/// What positions of its file a linkage misses, in a paragraph; or nothing.
[[nodiscard]] inline std::string missed_words(AnyStoredLinkage linkage) {
  std::visit([](auto& stored) { stored.length_unit = printable(stored.length_unit); }, linkage);
  std::string words = position_error_words(linkage);
  if (words.empty()) return "";
  words.front() = 'A';
  return wrapped(words + ".");
}

}  // namespace linkwright::cli
