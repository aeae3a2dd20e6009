#include "linkwright/files/nearest_name.hpp"

#include <algorithm>
#include <vector>

#include "files/json/json.hpp"

namespace linkwright {
namespace {

constexpr std::size_t longest_compared = 64;  // bytes; our own names are shorter than 30
constexpr std::size_t longest_shown = 40;

bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

}  // namespace

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t k = 0; k <= b.size(); ++k) last[k] = k;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t k = 1; k <= b.size(); ++k) {
      const std::size_t replaced = last[k - 1] + (a[i - 1] == b[k - 1] ? 0 : 1);
      row[k] = std::min({last[k] + 1, row[k - 1] + 1, replaced});
      const bool exchanged = i > 1 && k > 1 && a[i - 1] == b[k - 2] && a[i - 2] == b[k - 1];
      if (exchanged) row[k] = std::min(row[k], before[k - 2] + 1);
    }
    std::swap(before, last);
    std::swap(last, row);
  }
  return last[b.size()];
}

std::string_view nearest_name(std::string_view written, std::span<const std::string_view> known) {
  const std::string_view compared = written.substr(0, longest_compared);
  const auto nearest = *std::min_element(known.begin(), known.end(), [&](std::string_view a, std::string_view b) {
    return edit_distance(compared, a) < edit_distance(compared, b);
  });
  return 2 * edit_distance(compared, nearest) <= std::max(compared.size(), nearest.size()) ? nearest : "";
}

std::string well_formed(std::string_view text) {
  const bool is_ascii =
      std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; });
  if (is_ascii) return std::string(text);
  return Json::parse(Json(text).dump(-1, ' ', false, Json::error_handler_t::replace)).get<std::string>();
}

std::string presentable(std::string_view name) {
  std::size_t shown = std::min(name.size(), longest_shown);
  while (shown < name.size() && shown > 0 && is_continuation(name[shown])) --shown;
  std::string text;
  for (const char c : well_formed(name.substr(0, shown)))
    text += static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? '?' : c;
  return shown < name.size() ? text + "…" : text;
}

std::string in_quotes(std::string_view name) { return '"' + presentable(name) + '"'; }

}  // namespace linkwright
