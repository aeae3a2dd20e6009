#include "json_scan.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace linkwright {
namespace {

constexpr std::string_view white_space = " \t\r\n";
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/// The byte after the text or comment that starts at `start`; `start` itself where neither does.
std::size_t skip_text_or_comment(std::string_view text, std::size_t start) {
  const auto after = [&](std::size_t found, std::size_t length) {
    return found == std::string_view::npos ? text.size() : found + length;
  };
  if (text[start] == '"') {
    std::size_t end = start + 1;
    while (end < text.size() && text[end] != '"') end += text[end] == '\\' ? 2 : 1;
    return std::min(end + 1, text.size());
  }
  if (text.substr(start, 2) == "//") return after(text.find('\n', start), 1);
  if (text.substr(start, 2) == "/*") return after(text.find("*/", start + 2), 2);
  return start;
}

/// First bracket that opens deeper than allowed.
std::optional<std::size_t> too_deep_at(std::string_view text, int deepest) {
  int depth = 0;
  for (std::size_t place = 0; place < text.size();) {
    const std::size_t after = skip_text_or_comment(text, place);
    if (after != place) {
      place = after;
      continue;
    }
    if (text[place] == '[' || text[place] == '{') ++depth;
    if (text[place] == ']' || text[place] == '}') --depth;
    if (depth > deepest) return place;
    ++place;
  }
  return std::nullopt;
}

}  // namespace

std::string line_and_column(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, offset);
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t start = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
  std::string_view in_line = before.substr(start);
  if (start == 0 && in_line.substr(0, byte_order_mark.size()) == byte_order_mark) {
    in_line.remove_prefix(byte_order_mark.size());
  }
  const auto column = 1 + std::count_if(in_line.begin(), in_line.end(),
                                        [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; });
  return fmt::format("line {}, column {}", line, column);
}

std::optional<Error> scan_json(std::string_view text, const JsonLimits& limits) {
  if (text.size() > limits.max_bytes) {
    return Error{"file_too_large",
                 "",
                 fmt::format("this file is larger than {} MiB, the most that is read; a Linkwright file is far smaller",
                             limits.max_bytes >> 20),
                 {{"most", limits.max_bytes >> 20}}};
  }
  std::string_view content = text;
  if (content.substr(0, byte_order_mark.size()) == byte_order_mark) content.remove_prefix(byte_order_mark.size());
  if (content.find_first_not_of(white_space) == std::string_view::npos) {
    return Error{"empty_file", "", "this file is empty; it should hold a JSON object that starts with {"};
  }
  if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos) {
    return Error{"zero_byte", line_and_column(text, zero),
                 "a zero byte stands here; this is not a JSON text in UTF-8, save it as one"};
  }
  if (const auto place = too_deep_at(text, limits.deepest_nesting)) {
    return Error{"nested_too_deep",
                 line_and_column(text, *place),
                 fmt::format("brackets are nested deeper than {}, the most that is read", limits.deepest_nesting),
                 {{"most", limits.deepest_nesting}}};
  }
  return std::nullopt;
}

}  // namespace linkwright
