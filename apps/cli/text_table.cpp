#include "text_table.hpp"

#include <algorithm>

#include "linkwright/core/angle.hpp"
#include "linkwright/files/number_text.hpp"

namespace linkwright::cli {
namespace {

constexpr std::size_t widest_line = 100;

/// Columns that a text takes: characters of UTF-8 (none of ours is wide).
std::size_t columns(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// The next space that a line may break at: not one between two digits, which holds a number together.
std::size_t end_of_word(std::string_view text) {
  std::size_t end = text.find(' ');
  while (end != std::string_view::npos && end > 0 && end + 1 < text.size() && is_digit(text[end - 1]) &&
         is_digit(text[end + 1]))
    end = text.find(' ', end + 1);
  return std::min(end, text.size());
}

}  // namespace

TextTable::TextTable(std::vector<std::string> headings) {
  for (std::string& heading : headings) {
    const bool to_the_left = heading.rfind('<', 0) == 0;
    if (to_the_left) heading.erase(0, 1);
    to_the_left_.push_back(to_the_left);
  }
  rows_.push_back(std::move(headings));
}

void TextTable::add_row(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }

std::string TextTable::text() const {
  std::vector<std::size_t> widths(to_the_left_.size(), 0);
  for (const auto& row : rows_) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], columns(row[i]));
  }
  std::string text;
  for (const auto& row : rows_) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string room(widths[i] - columns(row[i]), ' ');
      line += "  " + (to_the_left_[i] ? row[i] + room : room + row[i]);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + '\n';
  }
  return text;
}

std::string wrapped(std::string_view text, std::size_t indent) {
  const std::size_t start = std::min(text.find_first_not_of(' '), text.size());
  std::string lines(start, ' ');
  std::size_t used = start;
  bool is_first = true;
  text.remove_prefix(start);
  while (!text.empty()) {
    const std::size_t end = end_of_word(text);
    const std::string_view word = text.substr(0, end);
    if (!is_first && used + 1 + columns(word) > widest_line) {
      lines += '\n' + std::string(indent, ' ');
      used = indent;
    } else if (!is_first) {
      lines += ' ';
      ++used;
    }
    is_first = false;
    lines += word;
    used += columns(word);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines + '\n';
}

std::string printable(std::string_view text) {
  std::string shown(text);
  for (char& c : shown) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = ' ';
  }
  return shown;
}

std::string angle_text(double radians, int decimals) { return rounded_text(degrees(radians), decimals) + "°"; }

}  // namespace linkwright::cli
