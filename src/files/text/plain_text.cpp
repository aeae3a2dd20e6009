#include "files/text/plain_text.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>

namespace linkwright {
namespace {

constexpr std::size_t longest_number = 400;  // no double takes more digits

}  // namespace

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n\f\v";
  const std::size_t first = text.find_first_not_of(blanks);
  return first == std::string_view::npos ? "" : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string in_small_letters(std::string_view text) {
  std::string small(trimmed(text));
  std::transform(small.begin(), small.end(), small.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return small;
}

double leading_number(std::string_view text) {
  text = trimmed(text);
  if (text.starts_with('+')) text.remove_prefix(1);
  // Not from_chars(), which WebAssembly's standard library lacks for doubles.
  const std::string ended(text.substr(0, longest_number));
  char* end = nullptr;
  const double number = std::strtod(ended.c_str(), &end);
  return end != ended.c_str() ? number : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace linkwright
